"""What door leaves look like: designs of fields, boards, ribs and panes that stay within 2 mm of the leaf's faces."""

from collections.abc import Callable, Iterable

import numpy as np

from apartgen.stages.things import finishes, solids
from apartgen.stages.things.asset import Array, Material, Mesh

PROUD = 0.002
"""How far what is raised stands out of the leaf's faces, m; so little that it needs no collider."""
MARGIN = 0.12
"""Width of stiles and rails, m."""
_SUNK = 0.004  # m, of a pane behind the leaf's faces

Rectangle = tuple[float, float, float, float]
"""On the leaf's face: y0, y1, z0, z1."""
Design = Callable[[Array, Array, Material], list[Mesh]]


def leaf(design: str, lo: Array, hi: Array, material: Material) -> list[Mesh]:
    """A leaf between two corners; narrow ones are flush, and those of a design that there is not have two fields."""
    made = DESIGNS.get(design, DESIGNS["panelled"]) if hi[1] - lo[1] >= 4 * MARGIN else _flush
    return made(lo, hi, material)


def _flush(lo: Array, hi: Array, material: Material) -> list[Mesh]:
    return [upright(lo, hi, material)]


def _raised(rectangles: Callable[[Array, Array], Iterable[Rectangle]]) -> Design:
    """A slab with raised rectangles on both faces."""

    def draw(lo: Array, hi: Array, material: Material) -> list[Mesh]:
        tone = Material(f"{material.name}_field", (*(0.94 * c for c in material.color[:3]), 1.0),  # type: ignore[arg-type]
                        material.roughness)
        field = material if material.texture else tone
        return [upright(lo, hi, material), *(
            upright((lo[0] - PROUD, y0, z0), (hi[0] + PROUD, y1, z1), field) for y0, y1, z0, z1 in rectangles(lo, hi))]

    return draw


def _two(lo: Array, hi: Array) -> list[Rectangle]:
    middle = lo[2] + 0.42 * (hi[2] - lo[2])
    y0, y1 = lo[1] + MARGIN, hi[1] - MARGIN
    return [(y0, y1, lo[2] + 1.5 * MARGIN, middle - MARGIN / 2), (y0, y1, middle + MARGIN / 2, hi[2] - MARGIN)]


def _six(lo: Array, hi: Array) -> list[Rectangle]:
    y, half = (lo[1] + hi[1]) / 2, MARGIN / 2
    columns = [(lo[1] + MARGIN, y - half), (y + half, hi[1] - MARGIN)]
    high = hi[2] - lo[2]
    edges = [lo[2] + 1.5 * MARGIN, lo[2] + 0.42 * high, lo[2] + 0.80 * high, hi[2] - MARGIN + half]
    return [(a, b, z0 + (half if k else 0), z1 - half)
            for a, b in columns for k, (z0, z1) in enumerate(zip(edges[:-1], edges[1:]))]


def _frame(lo: Array, hi: Array) -> list[Rectangle]:
    y0, y1 = lo[1] + MARGIN, hi[1] - MARGIN
    rails = [(lo[2], lo[2] + 1.5 * MARGIN), (lo[2] + 0.45 * (hi[2] - lo[2]),) * 2, (hi[2] - MARGIN, hi[2])]
    rails[1] = (rails[1][0] - MARGIN / 2, rails[1][0] + MARGIN / 2)
    return [(lo[1], y0, lo[2], hi[2]), (y1, hi[1], lo[2], hi[2]), *((y0, y1, a, b) for a, b in rails)]


def _strips(width: float, gap: float) -> Callable[[Array, Array], list[Rectangle]]:
    def draw(lo: Array, hi: Array) -> list[Rectangle]:
        edges = np.linspace(lo[1], hi[1], max(2, round((hi[1] - lo[1]) / width)) + 1)
        return [(float(a) + gap / 2, float(b) - gap / 2, lo[2], hi[2]) for a, b in zip(edges[:-1], edges[1:])]

    return draw


def _glazed(lo: Array, hi: Array, material: Material) -> list[Mesh]:
    (y0, y1, _, _), (_, _, z0, z1) = _two(lo, hi)
    bars = [(lo[1], y0, lo[2], hi[2]), (y1, hi[1], lo[2], hi[2]), (y0, y1, lo[2], z0), (y0, y1, z1, hi[2])]
    wood = [upright((lo[0], a, c), (hi[0], b, d), material) for a, b, c, d in bars]
    return [*wood, solids.box((lo[0] + _SUNK, y0, z0), (hi[0] - _SUNK, y1, z1), finishes.GLASS)]


def upright(lo: Array | tuple[float, ...], hi: Array | tuple[float, ...], material: Material) -> Mesh:
    """A box whose grain runs upward."""
    made = solids.box(lo, hi, material)
    assert made.uv is not None
    return Mesh(made.vertices, made.faces, material, made.uv[:, ::-1].copy())


DESIGNS: dict[str, Design] = {
    "panelled": _raised(_two), "sixfold": _raised(_six), "shaker": _raised(_frame),
    "boarded": _raised(_strips(0.12, 0.004)), "ribbed": _raised(_strips(0.03, 0.008)), "flush": _flush,
    "glazed": _glazed,
}  # fmt: skip
"""How a leaf between two corners is drawn."""
