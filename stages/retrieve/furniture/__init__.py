"""Parametric furniture: every category of the vocabulary in several styles, at any size within its range.

`build(category, style, size, seed)` is pure: the same four give the same asset, and the asset's id holds them,
`wardrobe/shaker/600x1500x2100/17` (millimetres), so `load_asset(id)` makes it again. What comes with its one leaf on
either side, as fridges do, has it on the left, or on the right where the id ends in `/right`.
"""

import itertools
import logging
from functools import cache, lru_cache
from typing import TYPE_CHECKING

from apartgen.schemas.errors import BadInput, Unknown, near
from apartgen.stages import registry
from apartgen.stages.things import categories, small
from apartgen.stages.things.asset import Asset

if TYPE_CHECKING:
    from apartgen.stages.retrieve.furniture.designs import Builder

log = logging.getLogger("apartgen")
BUILDING = ("door", "window")
"""Parts of the building itself; any size goes."""
RIGHT = "right"
KEPT = 1000
"""Assets that are at hand, those of some homes: a stage asks for what the one before has made."""


@cache
def _designs() -> "dict[str, dict[str, Builder]]":
    """Builders by category and style: of all modules here, then of other packages, faulty ones left out."""
    from apartgen.stages.retrieve.furniture.designs import DESIGNS
    from apartgen.stages.retrieve.furniture.foreign import told

    members = registry.sound(__name__)
    entered = [builder for styles in DESIGNS.values() for builder in styles.values()]
    for name, member in members.items():
        plugin, own = registry.bringer(__name__, name), list(map(id, vars(member).values()))
        if plugin and not any(f"{b.__module__}.".startswith(f"{plugin.value}.") or id(b) in own for b in entered):
            log.warning("%s", plugin.told('enters no builder; put @design("category", "style") above one'))
    known = (*categories.TABLE, *small.TABLE, *BUILDING)
    for category in [name for name in DESIGNS if name not in known]:
        builder = next(iter(DESIGNS.pop(category).values()))
        hint = near(category, known)
        log.warning("%s", told(builder, f"no category {category!r} to build; {hint} Else give it an entry; left out"))
    return DESIGNS


def _model(category: str) -> str:
    """The category, or the one that it is like, of which there are designs; BadInput for none."""
    model = categories.stand_in(category, _designs())
    if model is None:
        raise Unknown(categories.unknown(category))
    return model


def styles(category: str) -> tuple[str, ...]:
    """The styles a category comes in: its own, or else those of what it is like."""
    return tuple(_designs()[_model(category)])


def tried(category: str, seed: int) -> None:
    """BadInput, as where one is looked for, for another package's style that can't be built of some size: the usual
    one, the smallest, the largest and those between."""
    from apartgen.stages.retrieve.furniture.foreign import is_foreign

    kind, made = categories.TABLE.get(category), _designs()[_model(category)]
    if kind is None or not any(map(is_foreign, made.values())):
        return
    corners = [(d, w, h) for d, w, h in itertools.product(*zip(kind.min, kind.max, strict=True))]
    corners.sort(key=lambda size: size not in (kind.min, kind.max))
    for style, size in itertools.product(made, (kind.size, *corners)):
        if is_foreign(made[style]):
            build(category, style, size, seed)


def build(category: str, style: str, size: tuple[float, float, float], seed: int = 0, right: bool = False) -> Asset:
    """The asset of that category and style whose box is `size`, [depth, width, height] in m, to the millimetre; what is
    handed has its leaf hung on the left or `right`."""
    d, w, h = (round(float(s) * 1000) for s in size)
    return _built(category, style, (d, w, h), int(seed), right)


@lru_cache(KEPT)
def _built(category: str, style: str, mm: tuple[int, int, int], seed: int, right: bool) -> Asset:
    """The asset of a size in mm; every stage of a run is given the same."""
    from apartgen.stages.retrieve.furniture import foreign
    from apartgen.stages.retrieve.furniture.kit import Kit

    if style not in styles(category):
        raise Unknown(f"{category} has no style {style!r} here; one of {', '.join(styles(category))}, or one that a "
                      f"package brings (entry points {registry.group(__name__)}): install that")
    _check(category, style, mm)
    if right and not (category in categories.TABLE and categories.TABLE[category].handed):
        raise BadInput(f"{category} is not made with its leaf on the right; leave /{RIGHT} out")
    d, w, h = mm
    model = _model(category)
    _opens_alike(category, model)
    kit = Kit(category, style, (d / 1000, w / 1000, h / 1000), seed, model, right)
    builder, id = _designs()[model][style], f"{category}/{style}/{d}x{w}x{h}/{seed}" + right * f"/{RIGHT}"
    if foreign.is_foreign(builder):
        return foreign.made(builder, kit, id)
    builder(kit)
    return kit.finish(id)


def _opens_alike(category: str, model: str) -> None:
    """BadInput where a category would be built as one that opens in another way than it says."""
    opens, theirs = (categories.TABLE[name].opens if name in categories.TABLE else "" for name in (category, model))
    if opens and opens != theirs:
        own = f'@design("{category}", "plain")'
        raise BadInput(f"{category}: opens is {opens!r} and nothing here builds one; as a {model}, which it is like, "
                       f"it would have {theirs!r}: give it a builder, {own}, or leave opens out")


def _check(category: str, style: str, mm: tuple[int, ...]) -> None:
    if category in BUILDING:
        return
    kind = categories.TABLE.get(category) or small.TABLE[category]
    standing = small.upright(style, mm)[1] if category in small.TABLE else mm
    spare = small.LATITUDE if category in small.TABLE else 0.0
    for value, least, most, side in zip(standing, kind.min, kind.max, ("depth", "width", "height"), strict=True):
        if not round(least * (1 - spare) * 1000) <= value <= round(most * (1 + spare) * 1000):
            raise BadInput(f"{category}: {side} {value / 1000} m is outside [{least}, {most}]; give a size within it")


def load_asset(id: str) -> Asset:
    """The asset an id names."""
    try:
        category, style, size, seed, *side = id.split("/")
        d, w, h = (int(s) for s in size.split("x"))
        number = int(seed)
        if side not in ([], [RIGHT]):
            raise ValueError(side)
    except ValueError as error:
        raise BadInput(f"parametric asset {id!r}: not category/style/DxWxH/seed with the size in mm") from error
    return _built(category, style, (d, w, h), number, bool(side))
