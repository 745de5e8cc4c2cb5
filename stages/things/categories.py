"""The furniture vocabulary: sizes, what a thing is for, where it stands, what opens and how far it sweeps.

The data is `categories.toml`, to which packages add by the entry points `apartgen.categories`. An entry that is `like`
another has its facts but for those it gives itself, and models that never saw it place it as they place that one.
"""

import difflib
import logging
import re
import tomllib
from collections.abc import Callable, Collection, Container, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray
from pydantic import ConfigDict, TypeAdapter, ValidationError

from apartgen.schemas import facts, plugins
from apartgen.schemas.base import ROOM_TYPES
from apartgen.schemas.errors import CLOSE, BadInput, near
from apartgen.schemas.layout import Box
from apartgen.stages.things.claims import amiss
from apartgen.stages.things.stands import Stands

log = logging.getLogger("apartgen")

Place = Literal["floor", "wall", "ceiling", "top", "flat"]
Opens = Literal["", "leaf", "drawer", "flap", "lid", "sliding"]

GROUP = "apartgen.categories"
"""The entry points by which packages bring categories."""
DRAWER_TRAVEL = 0.75
"""A drawer comes out by this share of its unit's depth."""
OVEN_TOWER = 1.3
"""Ovens that are higher stand in a tower, others under a worktop or their own hob, m."""
LEAST_CLEARANCE_HEIGHT = 1.8
"""What hangs above this is no obstacle to people, m."""


@dataclass(frozen=True, kw_only=True)
class Category:
    """One kind of furniture; sizes are [depth, width, height] in metres. `categories.toml` says what each fact is."""

    __pydantic_config__ = ConfigDict(extra="forbid")

    name: str
    like: str = ""
    place: Place
    rooms: tuple[str, ...]
    size: tuple[float, float, float]
    min: tuple[float, float, float]
    max: tuple[float, float, float]
    rule: tuple[float, float, float] | None = None
    mass: tuple[float, float] | None = None
    weighed: tuple[str, ...] = ()
    listed: tuple[float, float] | None = None
    entry: str = ""
    mechanism: Literal["", "cabinet_door", "sealed_door", "latched_door", "sprung_flap", "flap"] = ""
    uses: tuple[str, ...] = ()
    opens: Opens = ""
    leaf_max: float = 0.6
    handed: bool = False
    flap: float = 0.0
    belongs: tuple[str, ...] = ()
    z: float = 0.0
    back: bool = False
    faces: bool = True
    soft: bool = False
    loose: bool = False
    hangs: bool = False
    kneehole: bool = False
    appliance: bool = False
    standard: bool = False
    matters: Literal["little", "some", "much"] = "some"
    serves: str = ""
    instead: tuple[str, ...] = ()
    family: str = ""
    run: Literal["", "unit", "fitted", "beside", "hung"] = ""
    stands: Stands = Stands()
    symbol: str = ""
    pictures: int = 0
    socket: bool = False
    affords: tuple[str, ...] = ()
    on: float = 0.0
    lumens: float = 0.0
    called: str = ""
    thor: str = ""
    labels: dict[str, tuple[str, ...]] = field(default_factory=dict)
    synonyms: tuple[str, ...] = ()
    lineage: tuple[str, ...] = ()

    @property
    def articulated(self) -> bool:
        """Whether any part of it moves."""
        return self.opens != ""

    def is_for(self, *uses: str) -> bool:
        """Whether it has one of these uses."""
        return not set(uses).isdisjoint(self.uses)


_CHECKED = TypeAdapter(Category)
_NAME = re.compile(r"[a-z][a-z0-9_]*")
_FACTS = tuple(name for name in Category.__dataclass_fields__ if name not in ("name", "lineage"))
_NO = {"belongs": "no category", "instead": "no category", "serves": "no category", "rooms": "no type of room",
       "uses": "no use"}
_NONE = ("rule", "mass", "listed")  # `[]` leaves these out
_ITS_OWN = ("name", "like", "serves", "synonyms", "called", "labels", "lineage")
"""Facts that what is like a category does not take over from it."""


def _load(own: Path = Path(__file__).parent / "categories.toml") -> dict[str, Category]:
    """Our entries, then those of other packages, of which a faulty one is left out with a warning."""
    try:
        table = read(tomllib.loads(own.read_text(encoding="utf-8")), {})
    except BadInput as error:
        raise BadInput(f"{own.name}: {error}") from None
    for plugin, rows in plugins.facts(GROUP):
        try:
            if alone := [name for name, row in rows.items() if isinstance(row, dict) and not row.get("like")]:
                raise BadInput(f'[{alone[0]}] needs like = "…", the category that it is placed as')
            found = read(rows, table)
            for fault in amiss(found, table):
                log.warning("%s", plugin.told(fault))
            table |= found
        except BadInput as error:
            log.warning("%s", plugin.told(f"{error}; its categories are left out"))
    return dict(sorted(table.items()))


def read(rows: dict[str, Any], known: dict[str, Category]) -> dict[str, Category]:
    """Entries as categories by name, `known` being those there are already; BadInput names the entry and its fault."""
    found: dict[str, Category] = {}
    waiting = dict(rows)
    while waiting:
        ready = [name for name, row in waiting.items() if _model(row) not in waiting]
        if not ready:
            raise BadInput(f"[{next(iter(waiting))}] is like one that is like it; name one that stands by itself")
        for name in ready:
            if name in known:
                raise BadInput(f"[{name}] is there already; give it another name")
            found[name] = _entry(name, waiting.pop(name), known | found)
    every = known | found
    for kind in found.values():
        for fact, named, there in (("belongs", kind.belongs, every), ("instead", kind.instead, every),
                                   ("serves", filter(None, [kind.serves]), every), ("rooms", kind.rooms, ROOM_TYPES),
                                   ("uses", kind.uses, _uses(known) or kind.uses)):
            if strange := [other for other in named if other not in there]:
                raise BadInput(f"[{kind.name}] {fact}: {strange[0]!r} is {_NO[fact]}; {near(strange[0], there)}")
    return found


def _uses(kinds: dict[str, Category]) -> list[str]:
    return sorted({use for kind in kinds.values() for use in kind.uses})


def _model(row: Any) -> str:
    return str(row.get("like", "")) if isinstance(row, dict) else ""


def _entry(name: str, row: Any, known: dict[str, Category]) -> Category:
    if not isinstance(row, dict):
        raise BadInput(f"{name} is no entry; begin one with [its_name]")
    if not _NAME.fullmatch(name):
        raise BadInput(f"[{name}] is no name of small letters, digits and _; change it")
    model = _model(row)
    if model and model not in known:
        raise BadInput(f"[{name}] like: {model!r} is no category; {near(model, known)}")
    taken = {k: v for k, v in vars(known[model]).items() if k not in _ITS_OWN} if model else {}
    lineage = (name, *known[model].lineage) if model else (name,)
    try:
        own = {fact: None if value == [] and fact in _NONE else value for fact, value in row.items()}
        kind = _CHECKED.validate_python(taken | own | {"name": name, "lineage": lineage})
    except ValidationError as error:
        raise BadInput(f"[{name}] {facts.fault(error, _FACTS)}") from None
    if not all(0 < low <= usual <= high for low, usual, high in zip(kind.min, kind.size, kind.max, strict=True)):
        raise BadInput(f"[{name}] size {list(kind.size)} is not within min {list(kind.min)} and max {list(kind.max)}")
    if blank := [word for word in kind.synonyms if not any(map(str.isalnum, word))]:
        raise BadInput(f"[{name}] synonyms: {blank[0]!r} is no word; leave it out")
    (d, w, h), rule = kind.max, kind.rule  # the rule of its model may be larger than it comes
    return replace(kind, serves=kind.serves or (known[model].serves or model if model else name),
                   rule=rule and (min(rule[0], d), min(rule[1], w), min(rule[2], h)),
                   called=kind.called or name.replace("_", " "))


TABLE: dict[str, Category] = _load()
CATEGORIES: tuple[str, ...] = tuple(name for name, kind in TABLE.items() if not kind.like)
"""What models learn, their class indices in this order; what is like one of these is placed as that is."""


def unknown(category: str, *meant: str) -> str:
    """That there is no such category here, which may be `meant`, and why that may be, in words."""
    close = meant or difflib.get_close_matches(category, TABLE, n=1, cutoff=CLOSE)
    hint = f" (did you mean {' or '.join(map(repr, close))}?)" if close else ""
    return (f"no category {category!r} is known here{hint}; if it is one that a package brings (entry points {GROUP}), "
            "install that: `apartgen --version` names those that are there")


def those(true_of: Callable[[Category], bool]) -> frozenset[str]:
    """Names of the categories of which something is true."""
    return frozenset(name for name, kind in TABLE.items() if true_of(kind))


@cache
def used_for(*uses: str) -> frozenset[str]:
    """Names of the categories that have one of these uses; ValueError for what is the use of none."""
    known = _uses(TABLE)
    if strange := [use for use in uses if use not in known]:
        raise ValueError(f"no use {strange[0]!r}; {near(strange[0], known)}")
    return those(lambda kind: kind.is_for(*uses))


def stand_in(category: str, known: Container[str] = CATEGORIES) -> str | None:
    """The first of a category, what it is like, what that is like and so on, that is `known`; None if none is."""
    lineage = TABLE[category].lineage if category in TABLE else (category,)
    return next((name for name in lineage if name in known), None)


def leaves(category: str, width: float) -> int:
    """How many hinged doors stand side by side across `width` metres."""
    return max(1, int(np.ceil(width / TABLE[category].leaf_max - 1e-6)))


def reach(category: str, size: ArrayLike) -> NDArray[np.float64]:
    """How far open parts may stand out in front of a box, metres.

    An upper bound over all designs of the category, used before an asset is chosen and kept by every
    asset of the embedded library. `size` is (..., 3); returns (...,).
    """
    d, w, h = np.moveaxis(np.asarray(size, float), -1, 0)
    kind = TABLE[category]
    match kind.opens:
        case "leaf":
            out = w / np.maximum(1, np.ceil(w / kind.leaf_max - 1e-6))
        case "drawer":
            out = DRAWER_TRAVEL * d
        case "flap":
            out = kind.flap * h
        case _:
            out = np.zeros_like(d)
    return np.asarray(out, float)


@cache
def groups() -> frozenset[tuple[str, str]]:
    """Ordered pairs (child, parent) that touch by design, such as a chair and its table or what is like one."""
    return frozenset((child.name, parent.name) for child in TABLE.values() for parent in TABLE.values()
                     if not set(child.belongs).isdisjoint(parent.lineage))


def parents(children: Collection[str]) -> frozenset[str]:
    """Names of the categories that one of these belongs to."""
    return frozenset(parent for child, parent in groups() if child in children)


def belong_together(a: str, b: str) -> bool:
    """Whether contact between categories `a` and `b` is part of their use."""
    return (a, b) in groups() or (b, a) in groups()


@cache
def carriers() -> frozenset[str]:
    """Names of the categories that others stand on."""
    return frozenset(parent for child, parent in groups() if TABLE[child].place == "top")


SEATS = used_for("sit")


def tucks(a: str, b: str) -> bool:
    """Whether one is a seat that may be drawn under the other."""
    return belong_together(a, b) and (a in SEATS or b in SEATS)


@cache
def by_word() -> dict[str, str]:
    """Category of every word for one, lower case. A newcomer has its own name, but takes no word that is spoken for."""
    models, newcomers = ([c for c in TABLE.values() if bool(c.like) == new] for new in (False, True))
    named = {c.name.replace("_", " "): c.name for c in models}
    return _words(newcomers) | named | _words(models) | {c.name.replace("_", " "): c.name for c in newcomers}


def _words(kinds: Sequence[Category]) -> dict[str, str]:
    return {word.lower(): c.name for c in kinds for word in c.synonyms}


@cache
def labelled(source: str) -> dict[str, tuple[str, ...]]:
    """What a source of models calls furniture, and the categories that each of its labels may be."""
    pairs = [(label, name) for name, kind in TABLE.items() for label in kind.labels.get(source, ())]
    return {label: tuple(name for other, name in pairs if other == label) for label, _ in pairs}


def fitted_ovens(objects: Sequence[Box]) -> frozenset[str]:
    """Ids of ovens fitted into a kitchen with a hob of its own; elsewhere an oven is a cooker."""
    hobs = {o.room for o in objects if o.category in used_for("fry")}
    return frozenset(o.id for o in objects if o.category in used_for("bake") and o.room in hobs)
