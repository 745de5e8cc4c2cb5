"""Weights of the relations model with their vocabulary, configuration and training record, in one safetensors file."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from safetensors import SafetensorError, safe_open

from apartgen.schemas.errors import BadInput
from apartgen.schemas.rooms import base_of
from apartgen.stages.layout.relations.config import Training
from apartgen.stages.layout.relations.infer import Contents, Places
from apartgen.stages.layout.relations.shape import Shape
from apartgen.stages.layout.relations.tokens import Ints
from apartgen.stages.things.categories import TABLE, stand_in

SHIPPED = Path(__file__).parent / "weights.safetensors"


class Model(NamedTuple):
    """The network of places and that of contents."""

    places: Places
    contents: Contents


def model_of(tensors: Mapping[str, NDArray[np.float32]], shape: Shape) -> Model:
    """The networks that have parameters of such names; KeyError where one is missing."""
    places, contents = ({name.removeprefix(part): value for name, value in tensors.items() if name.startswith(part)}
                        for part in ("places.", "contents."))
    return Model(Places(places, shape), Contents(contents))


@dataclass(frozen=True, eq=False)
class Vocabulary:
    """Names that the weights know: categories with their ranks in the functional order, room types."""

    categories: tuple[str, ...]
    types: tuple[str, ...]
    rank: Ints

    @cached_property
    def _index(self) -> dict[str, int]:
        known = {name: stand_in(name, self.categories) for name in TABLE}
        return {name: self.categories.index(found) for name, found in known.items() if found is not None}

    def category(self, name: str) -> int:
        """The index of a category, or of what it is like; BadInput where the weights know neither."""
        if name not in self._index:
            raise BadInput(f"category {name!r} is none that the layout weights know; say in its facts what it is like")
        return self._index[name]

    def type(self, name: str) -> int:
        """The index of a room type, or of the type that always exists behind it."""
        base = base_of(name) or name
        if base not in self.types:
            raise BadInput(f"room type {name!r} is none that the layout weights know; train again")
        return self.types.index(base)


def history(path: Path) -> dict[str, Any]:
    """What weights say of their training: corpus, rooms, steps, and from which weights they started themselves."""
    with safe_open(path, "np") as file:
        record = json.loads((file.metadata() or {}).get("record", "{}"))
    return {name: record[name] for name in ("corpus", "rooms", "step", "start") if name in record}


def load(path: Path | None = None) -> tuple[Model, Vocabulary, dict[str, Any]]:
    """The model, ready for sampling, what it knows, and its training record; BadInput where there is none."""
    return _load(str(path or SHIPPED))


@lru_cache(maxsize=2)
def _load(path: str) -> tuple[Model, Vocabulary, dict[str, Any]]:
    try:
        with safe_open(path, "np") as file:
            header = file.metadata() or {}
            found = {name: file.get_tensor(name).astype(np.float32) for name in file.keys()}  # noqa: SIM118
        known = Vocabulary(tuple(json.loads(header["categories"])), tuple(json.loads(header["types"])),
                           np.array(json.loads(header["rank"])))
        shape, record = Training.model_validate_json(header["config"]).shape, json.loads(header["record"])
        model = model_of(found, shape)
        if len(model.places.ask) != len(known.categories) or len(model.contents.type) != len(known.types):
            raise ValueError("they are of other names than they say")
    except (OSError, SafetensorError, KeyError, ValueError, RuntimeError) as error:
        raise BadInput(f"{path}: no weights of the relations model ({error}); train some with `apartgen train layout`"
                       ) from error
    return model, known, record
