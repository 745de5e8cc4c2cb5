"""Outlines of eight shapes, filled with flats that their areas are usual for: `python outlines.py 50`, so many a shape.

Prints for each shape how many were filled without a fault, how many gave something up, and CPU seconds of a plan.
"""

import logging
import sys
from collections.abc import Callable
from time import process_time

import numpy as np
from shapely import get_coordinates
from shapely.affinity import rotate, scale, translate
from shapely.geometry import Polygon, box

from apartgen import planning
from apartgen.schemas.errors import ApartgenError
from apartgen.schemas.plan import Side
from apartgen.stages.plan import validate, warm

FLATS = [(45, "studio"), (62, "one-bedroom flat"), (88, "two-bedroom flat"), (125, "three-bedroom flat"),
         (1000, "four-bedroom flat")]  # fmt: skip
"""Flats by the area up to which they are usual, m²."""
DEEP = "two-bedroom flat"
"""Between two neighbours, whatever its area: two fronts of 6 m light no more."""
Rng = np.random.Generator


def ell(rng: Rng) -> Polygon:
    """A rectangle that lacks a corner."""
    w, h = rng.uniform((8.5, 7.5), (13, 11))
    return box(0, 0, w, h) - box(w * rng.uniform(0.5, 0.65), h * rng.uniform(0.45, 0.6), 20, 20)


def u(rng: Rng) -> Polygon:
    """Two wings about a court."""
    w, h, wing = rng.uniform((11.5, 8, 3.6), (14.5, 10, 4.4))
    return box(0, 0, w, h) - box(wing, h * rng.uniform(0.5, 0.6), w - wing, 20)


def tee(rng: Rng) -> Polygon:
    """A bar with a stem."""
    w, bar, stem, deep = rng.uniform((10, 4.5, 4.2, 3.2), (14, 6, 5.5, 5))
    x = rng.uniform(2, w - stem - 2)
    return box(0, 0, w, bar).union(box(x, bar, x + stem, bar + deep))


def skewed(rng: Rng) -> Polygon:
    """Four walls of which two slant."""
    w, h, a, b = rng.uniform((8.5, 7, 0.4, 0.2), (12, 10, 2, 1))
    return Polygon([(0, 0), (w, 0), (w - a, h), (0, h - b)])


def cut_off(rng: Rng) -> Polygon:
    """A rectangle that lacks a corner aslant, of up to .45 of its sides."""
    w, h = rng.uniform((6.5, 5.5), (12.5, 10.5))
    (a, b), (x, y) = rng.uniform(1, (0.45 * w, 0.45 * h)), rng.integers(0, 2, 2)
    corner = Polygon([(-1, -1), (a + a / b, -1), (-1, b + b / a)])
    return box(0, 0, w, h) - scale(corner, 1 - 2 * x, 1 - 2 * y, origin=(w / 2, h / 2))


def deep(rng: Rng) -> Polygon:
    """6 x 15 m or a little otherwise, for a flat between two neighbours."""
    w, h = rng.uniform((5.8, 14), (6.6, 15.5))
    return box(0, 0, w, h)


def askew(rng: Rng) -> Polygon:
    """A rectangle turned by 23 degrees."""
    w, h = rng.uniform((7, 6), (13, 10))
    return rotate(box(0, 0, w, h), 23, origin=(0, 0))


def stepped(rng: Rng) -> Polygon:
    """Four fronts of each of which a part stands out by .3 to 1.4 m, as those of blocks of flats do."""
    w, h = rng.uniform((8, 6.5), (11.5, 9.5))
    whole = box(0, 0, w, h)
    for x, y in ((0, 1), (1, 0), (0, -1), (-1, 0)):
        part, out, last = *rng.uniform((0.35, 0.3), (0.65, 1.4)), rng.integers(2)
        wide, high = (part * w, h) if x == 0 else (w, part * h)
        bay = box(0, 0, wide, high)
        whole |= translate(bay, x * out + last * (w - wide), y * out + last * (h - high))
    return whole


SHAPES: dict[str, tuple[Callable[[Rng], Polygon], list[Side]]] = {
    "L": (ell, []), "U": (u, []), "T": (tee, []), "skewed": (skewed, []),
    "corner cut off": (cut_off, []), "6 x 15": (deep, ["east", "west"]), "turned": (askew, []),
    "stepped": (stepped, []),
}  # fmt: skip


def tried(shape: str, number: int) -> tuple[bool, bool, float]:
    """Whether an outline was filled without a fault, whether something was given up, and CPU seconds."""
    draw, party = SHAPES[shape]
    outline = draw(np.random.default_rng([number, *shape.encode()]))
    usual = next(flat for most, flat in FLATS if outline.area < most)
    prompt = DEEP if party else usual
    ring = [(float(x), float(y)) for x, y in get_coordinates(outline.exterior)[:-1]]
    ring = ring if outline.exterior.is_ccw else ring[::-1]
    began = process_time()
    try:
        plan, _ = planning.draw(prompt, planning.PlanSettings(outline=ring, party_walls=party, processes=1), number)
    except ApartgenError as error:
        print(f"{shape} {number}, {outline.area:.0f} m², {prompt}: {error}", file=sys.stderr)
        return False, False, process_time() - began
    return not validate(plan), bool(plan.relaxed), process_time() - began


def main(each: int) -> None:
    """The table, a row when its shape is done."""
    logging.getLogger("apartgen").setLevel(logging.ERROR)
    warm()
    print("| shape | filled | something given up | CPU s, median | p95 |\n|---|---|---|---|---|")
    every: list[tuple[bool, bool, float]] = []
    for shape in SHAPES:
        found = [tried(shape, i) for i in range(each)]
        every += found
        print(row(shape, found), flush=True)
    print(row("all", every))


def row(name: str, found: list[tuple[bool, bool, float]]) -> str:
    """A line of the table."""
    filled, relaxed, seconds = zip(*found, strict=True)
    quantiles = f"{np.median(seconds):.2f} | {np.quantile(seconds, 0.95):.2f}"
    return f"| {name} | {sum(filled)} of {len(found)} | {sum(relaxed)} | {quantiles} |"


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 50)
