"""The networks while they are trained, and how their weights are written."""

import json
from pathlib import Path
from typing import Any

import torch
from safetensors import SafetensorError, safe_open
from safetensors.torch import save_file
from torch import Tensor, nn

from apartgen.schemas.base import ROOM_TYPES
from apartgen.schemas.errors import BadInput
from apartgen.stages.layout.relations import order, weights
from apartgen.stages.layout.relations.config import Training
from apartgen.stages.layout.relations.network import Relations
from apartgen.stages.layout.relations.network_contents import Contents
from apartgen.stages.layout.relations.shape import Shape
from apartgen.stages.things.categories import CATEGORIES


class Model(nn.Module):
    """The network of places and that of contents."""

    def __init__(self, shape: Shape, categories: int, types: int) -> None:
        super().__init__()
        self.places = Relations(shape, categories, types)
        self.contents = Contents(shape, categories, types)


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


def tensors(path: Path) -> dict[str, Tensor]:
    """Parameters by name; BadInput where there are none."""
    try:
        with safe_open(path, "pt") as file:
            return {name: file.get_tensor(name).float() for name in file.keys()}  # noqa: SIM118
    except (OSError, SafetensorError) as error:
        raise BadInput(f"{path}: no weights ({error}); train some with `apartgen train layout`") from error


def empty(config: Training) -> Model:
    """A model that has learned nothing yet; its first weights hang on the seed alone."""
    torch.manual_seed(config.seed)
    return Model(config.shape, len(CATEGORIES), len(ROOM_TYPES))


def frozen(model: Model) -> weights.Model:
    """The same networks as they are asked."""
    found = {name: value.detach().float().numpy() for name, value in model.state_dict().items()}
    return weights.model_of(found, model.places.shape)
