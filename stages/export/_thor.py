"""AI2-THOR's own assets, the only ones that a house of its may name: furniture, doors, windows.

Furniture is looked up in `asset-database.json` of the Python package `procthor`, where that is installed.
"""

import json
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple

import numpy as np

from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Box
from apartgen.stages.things.asset import Array
from apartgen.stages.things.categories import TABLE

MOST, LEAST = 0.4, 0.5
"""By how much an asset may be larger than the object on any side, m, and what share of its side it has at least."""
WINDOWS = {
    "Window_Fixed_36x48": (0.92, 1.22), "Window_Fixed_60x36": (1.53, 0.92), "Window_Fixed_60x48": (1.53, 1.22),
    "Window_Fixed_60x72": (1.53, 1.83), "Window_Fixed_96x48": (2.44, 1.23), "Window_Fixed_96x72": (2.44, 1.83),
    "Window_Hung_32x60": (0.87, 1.58), "Window_Hung_44x60": (1.18, 1.58), "Window_Hung_48x24": (1.28, 0.67),
    "Window_Hung_48x44": (1.29, 1.28), "Window_Slider_36x36": (0.91, 0.92), "Window_Slider_48x36": (1.22, 0.91),
    "Window_Slider_48x48": (1.22, 1.22),
}  # fmt: skip
"""Width and height of THOR's windows, m."""
DOUBLE = 1.5
"""A passage of this width or more has a double door or frame, m."""


class Model(NamedTuple):
    """An asset: its id, THOR's type, [depth, width, height] in m."""

    id: str
    kind: str
    size: tuple[float, float, float]


def furniture() -> list[Model]:
    """Every asset of the installed package, none without it; BadInput where its file is not what it should be."""
    spec = find_spec("procthor")
    for place in (spec.submodule_search_locations or []) if spec else []:
        path = Path(place) / "databases" / "asset-database.json"
        if not path.exists():
            continue
        try:
            groups = json.loads(path.read_text(encoding="utf-8"))
            return [
                Model(row["assetId"], kind, (row["boundingBox"]["z"], row["boundingBox"]["x"], row["boundingBox"]["y"]))
                for kind, rows in groups.items() for row in rows
            ]
        except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
            raise BadInput(f"{path}: not ProcTHOR's asset database ({error!r}); reinstall procthor") from error
    return []


def type_of(category: str) -> str | None:
    """THOR's type of furniture that a category is most like; None where there is none."""
    return TABLE[category].thor or None if category in TABLE else None


def alike(o: Box, known: list[Model]) -> Model | None:
    """The asset of the object's type that is nearest in size, None where none comes near."""
    fits = [m for m in known if m.kind == type_of(o.category) and _fits(m.size, np.array(o.size))]
    return min(fits, key=lambda m: (float(np.abs(np.subtract(m.size, o.size)).sum()), m.id), default=None)


def _fits(size: tuple[float, float, float], wanted: Array) -> bool:
    return bool((size <= wanted + MOST).all() and (size >= LEAST * wanted).all())


def dressed(objects: list[Box], known: list[Model]) -> dict[str, tuple[Model, tuple[float, float, float]]]:
    """By object its asset and the middle of that: backs stay at their walls, bottoms on the floor or on what is below.

    Objects without a like are left out.
    """
    found: dict[str, tuple[Model, tuple[float, float, float]]] = {}
    for o in sorted(objects, key=lambda o: o.center[2] - o.size[2] / 2):
        model = alike(o, known)
        if model is not None:
            forward = (model.size[0] - o.size[0]) / 2 * np.array([np.cos(o.yaw), np.sin(o.yaw)])
            x, y = np.add(o.center[:2], forward)
            below, middle = found.get(o.on or "", (None, (0.0, 0.0, o.center[2] - o.size[2] / 2)))
            low = middle[2] + (below.size[2] / 2 if below else 0.0)
            found[o.id] = model, (float(x), float(y), low + model.size[2] / 2)
    return found


def window(width: float, height: float) -> str:
    """THOR's window nearest in size."""
    return min(WINDOWS, key=lambda name: abs(WINDOWS[name][0] - width) + abs(WINDOWS[name][1] - height))


def passage(width: float, has_leaf: bool) -> str:
    """THOR's doorway with a leaf, or frame without one."""
    return ("Doorway" if has_leaf else "Doorframe") + ("_Double_1" if width >= DOUBLE else "_1")
