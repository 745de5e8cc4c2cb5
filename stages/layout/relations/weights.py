"""Weights of the relations model with their vocabulary, configuration and training record, in one safetensors file."""

import json
from dataclasses import dataclass
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any

import numpy as np
import torch
from safetensors import SafetensorError, safe_open
from safetensors.torch import save_file
from torch import Tensor, nn

from apartgen.schemas.base import ROOM_TYPES
from apartgen.schemas.errors import BadInput
from apartgen.schemas.rooms import base_of
from apartgen.stages.layout.relations import order
from apartgen.stages.layout.relations.config import Training
from apartgen.stages.layout.relations.contents import Contents
from apartgen.stages.layout.relations.network import Relations
from apartgen.stages.layout.relations.shape import Shape
from apartgen.stages.layout.relations.tokens import Ints
from apartgen.stages.things.categories import CATEGORIES, TABLE, stand_in

SHIPPED = Path(__file__).parent / "weights.safetensors"


class Model(nn.Module):
    """The network of places and that of contents."""

    def __init__(self, shape: Shape, categories: int, types: int) -> None:
        super().__init__()
        self.places = Relations(shape, categories, types)
        self.contents = Contents(shape, categories, types)


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


def save(model: Model, path: Path, config: Training, record: dict[str, Any]) -> None:
    """Write half-precision weights; the header holds config, vocabulary and `record`."""
    halves = {name: value.detach().half().contiguous() for name, value in model.state_dict().items()}
    names = {"corpus": Path(config.corpus).name, "start": Path(config.start).name if config.start else None}
    named = config.model_copy(update=names)
    header = {
        "config": named.model_dump_json(), "categories": json.dumps(CATEGORIES), "types": json.dumps(ROOM_TYPES),
        "rank": json.dumps(order.ranks().tolist()), "record": json.dumps(record),
    }
    part = path.with_suffix(".part")
    save_file(halves, part, header)
    part.replace(path)


def history(path: Path) -> dict[str, Any]:
    """What weights say of their training: corpus, rooms, steps, and from which weights they started themselves."""
    with safe_open(path, "pt") as file:
        record = json.loads((file.metadata() or {}).get("record", "{}"))
    return {name: record[name] for name in ("corpus", "rooms", "step", "start") if name in record}


def tensors(path: Path) -> dict[str, Tensor]:
    """Parameters by name; BadInput where there are none."""
    try:
        with safe_open(path, "pt") as file:
            return {name: file.get_tensor(name).float() for name in file.keys()}  # noqa: SIM118
    except (OSError, SafetensorError) as error:
        raise BadInput(f"{path}: no weights ({error}); train some with `apartgen train layout`") from error


def load(path: Path | None = None) -> tuple[Model, Vocabulary, dict[str, Any]]:
    """The model, ready for sampling, what it knows, and its training record; BadInput where there is none."""
    return _load(str(path or SHIPPED))


@lru_cache(maxsize=2)
def _load(path: str) -> tuple[Model, Vocabulary, dict[str, Any]]:
    try:
        with safe_open(path, "pt") as file:
            header = file.metadata() or {}
            found = {name: file.get_tensor(name).float() for name in file.keys()}  # noqa: SIM118
        known = Vocabulary(tuple(json.loads(header["categories"])), tuple(json.loads(header["types"])),
                           np.array(json.loads(header["rank"])))
        shape, record = Training.model_validate_json(header["config"]).shape, json.loads(header["record"])
        model = Model(shape, len(known.categories), len(known.types))
        model.load_state_dict(found)
    except (OSError, SafetensorError, KeyError, ValueError, RuntimeError) as error:
        raise BadInput(f"{path}: no weights of the relations model ({error}); train some with `apartgen train layout`"
                       ) from error
    return model.eval().requires_grad_(False), known, record


def empty(config: Training) -> Model:
    """A model that has learned nothing yet; its first weights hang on the seed alone."""
    torch.manual_seed(config.seed)
    return Model(config.shape, len(CATEGORIES), len(ROOM_TYPES))
