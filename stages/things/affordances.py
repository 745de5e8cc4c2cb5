"""What can be done with things: by what furniture is for, and as the tables of small things say."""

from collections.abc import Sequence

from apartgen.schemas.retrieve import Furnishing
from apartgen.stages.things import categories, small

BY_USE: dict[str, tuple[str, ...]] = {
    "sit": ("sittable",), "lounge": ("sittable",), "sleep": ("sittable", "lie_on"),
    "light": ("switchable", "light_source"), "fry": ("switchable", "heat_source"),
    "bake": ("switchable", "heat_source"), "rinse": ("switchable", "water_source"),
    "wash": ("switchable", "water_source"), "bathe": ("switchable", "water_source"),
    "relieve": ("sittable", "water_source"), "launder": ("switchable",), "cool": ("switchable",),
}  # fmt: skip
"""What furniture affords that is for this. What is switchable is on or off: a tap runs, a hob is hot, a lamp shines."""


def affordances(o: Furnishing, places: Sequence[str], held: bool) -> list[str]:
    """What a thing affords, sorted; `places` are kinds of its receptacles, `held` says that a gripper can hold it."""
    found: set[str] = set()
    if o.category in small.TABLE:
        found |= set(small.TABLE[o.category].affords)
    elif o.category in categories.TABLE:
        kind = categories.TABLE[o.category]
        found |= {*kind.affords, *(name for use in kind.uses for name in BY_USE.get(use, ()))}
    found |= {"openable"} if o.joints else set()
    found |= {"graspable"} if held else set()
    found |= {"container"} if {"inside", "drawer", "basin"} & set(places) else set()
    found |= {"surface"} if {"top", "shelf"} & set(places) else set()
    return sorted(found)
