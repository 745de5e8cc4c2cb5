"""Tell2Design's human descriptions (CC BY-NC 4.0, never part of this repository) read and planned.

`python tell2design.py TEXTS --read 500 --plan 120 [--images FOLDER [--outlines]]` takes so many of the texts with an
even id, evenly spread over all. Of those read it prints how many were refused and S_node against the names a pattern
finds in the text; of those planned, how many of the places asked for the plan has, and with the data set's images the
macro IoU over room types under the best translation, without mirroring; `--outlines` gives each plan the outline of its
image.
"""

import argparse
import logging
import re
from collections import Counter
from pathlib import Path

import numpy as np
import shapely
from numpy.typing import NDArray
from PIL import Image, ImageDraw
from scipy.ndimage import binary_opening, label

from apartgen.schemas.errors import ApartgenError
from apartgen.schemas.plan import Plan, Program
from apartgen.stages import plan
from apartgen.stages.plan.reader import read

NAMES = re.compile(
    r"\b(master|common|guest|second|child|children|bath|living|dining|storage|study|bed|balcony|kitchen)"
    r"(?: ?(?:bed)? ?(?:rooms?|area))?s?(?: ?#? ?(\d))?(?![a-z])", re.IGNORECASE)
TYPES = dict.fromkeys("master common guest second child children bed".split(), "bedroom") | {
    "bath": "bathroom", "living": "living_room", "dining": "dining_room"}  # fmt: skip
COLOURS = {"living_room": (238, 232, 170), "kitchen": (240, 128, 128), "bathroom": (173, 216, 230),
           "common": (255, 215, 0), "master": (255, 165, 0), "balcony": (107, 142, 35)}  # fmt: skip
OUTSIDE = ((255, 255, 255), (0, 0, 0), (255, 0, 0))
"""Colours of what is no room: the ground and inner walls, outer walls, the entrance."""
PIXELS, METRES = 256, 18.0
Masks = dict[str, NDArray[np.bool_]]


def named(text: str) -> Counter[str]:
    """Rooms by type that a text names; those with numbers are told apart by them."""
    found: dict[str, set[str]] = {}
    for name, number in NAMES.findall(text):
        found.setdefault(name.lower(), set()).add(number)
    counts = Counter[str]()
    for name, numbers in found.items():
        counts[TYPES.get(name, name)] += max(len(numbers - {""}), 1)
    return counts


def likeness(program: Program, wanted: Counter[str]) -> float:
    """S_node against rooms by type."""
    rooms = Counter(str(r.type) for r in program.rooms)
    return (rooms & wanted).total() / max(rooms.total(), wanted.total())


def drawn(made: Plan) -> Masks:
    """What a plan covers by kind of room, at the data set's scale."""
    masks = {}
    for kind in COLOURS:
        image = Image.new("1", (PIXELS, PIXELS))
        for room in made.rooms:
            if kind == _kind(room.id, room.type):
                ring = [(x * PIXELS / METRES + 40, PIXELS - 40 - y * PIXELS / METRES) for x, y in room.polygon]
                ImageDraw.Draw(image).polygon(ring, fill=1)
        masks[kind] = np.array(image, bool)
    return masks


def _kind(room: str, type: str) -> str:
    return "master" if room == "bedroom_1" else "common" if type in ("bedroom", "study") else type


def painted(path: Path) -> tuple[Masks, int]:
    """The same of an image, and how many pixels are of rooms of other kinds."""
    pixels = np.array(Image.open(path).convert("RGB"))
    masks = {kind: (pixels == colour).all(axis=2) for kind, colour in COLOURS.items()}
    known = np.any([(pixels == colour).all(axis=2) for colour in (*COLOURS.values(), *OUTSIDE)], axis=0)
    return masks, int((~known).sum())


def overlap(ours: Masks, theirs: Masks, others: int) -> float:
    """Greatest share that both have in common over all translations: intersections over unions, summed over kinds."""
    shared = sum(
        np.fft.irfft2(np.fft.rfft2(theirs[k]) * np.conj(np.fft.rfft2(ours[k])), (PIXELS, PIXELS)) for k in COLOURS)
    whole = others + sum(int(ours[k].sum() + theirs[k].sum()) for k in COLOURS)
    return float(np.max(shared / (whole - shared)))


def outline(path: Path) -> list[tuple[float, float]]:
    """Clear outline of an image's home without its balconies, m: what outer walls and the entrance shut in."""
    pixels = np.array(Image.open(path).convert("RGB"))
    grounds, _ = label((pixels == 255).all(axis=2))
    rim = np.concatenate([grounds[0], grounds[-1], grounds[:, 0], grounds[:, -1]])
    shut = ~np.isin(grounds, rim[rim > 0]) & (pixels >= 40).any(axis=2)
    for colour in (OUTSIDE[2], COLOURS["balcony"]):
        shut &= ~(pixels == colour).all(axis=2)
    parts, many = label(binary_opening(shut, np.ones((5, 5))))
    largest = parts == 1 + np.argmax([(parts == k + 1).sum() for k in range(many)])
    rows = [np.flatnonzero(np.diff(np.r_[0, row, 0])).reshape(-1, 2) for row in largest.astype(int)]
    runs = [shapely.box(a, PIXELS - y - 1, b, PIXELS - y) for y, row in enumerate(rows) for a, b in row]
    whole = shapely.geometry.polygon.orient(shapely.Polygon(shapely.union_all(runs).simplify(1e-9).exterior))
    corners = (np.array(whole.exterior.coords[:-1]) - 40) * METRES / PIXELS
    return [(float(x), float(y)) for x, y in corners.round(2)]


def spread(files: list[Path], count: int) -> list[Path]:
    """So many of them, evenly."""
    return [files[int(k)] for k in np.linspace(0, len(files) - 1, min(count, len(files)))]


def main() -> None:
    """Prints the figures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("texts", type=Path)
    parser.add_argument("--read", type=int, default=500)
    parser.add_argument("--plan", type=int, default=120)
    parser.add_argument("--images", type=Path)
    parser.add_argument("--outlines", action="store_true", help="give plans the outlines of their images")
    parser.add_argument("--each", action="store_true", help="name what every plan lacks")
    given = parser.parse_args()
    logging.getLogger("apartgen").setLevel(logging.CRITICAL)
    files = sorted((f for f in given.texts.glob("*.txt") if int(f.stem) % 2 == 0), key=lambda f: int(f.stem))
    _read_all(spread(files, given.read))
    _plan_all(spread(files, given.plan), given.images, given.each, given.outlines)


def _read_all(files: list[Path]) -> None:
    scores = []
    for file in files:
        try:
            scores.append(likeness(read(file.read_text()), named(file.read_text())))
        except ApartgenError:
            scores.append(np.nan)
    refused = int(np.isnan(scores).sum())
    share = refused / len(files)
    print(f"read {len(files)}: refused {refused} ({share:.3f}), S_node {np.nanmean(scores):.4f}", flush=True)


def _plan_all(files: list[Path], images: Path | None, each: bool, outlines: bool) -> None:
    asked, ious, failed = Counter[str](), [], 0
    for file in files:
        try:
            rng = np.random.default_rng(int(file.stem))
            program = read(file.read_text())
            if outlines and images is not None:
                within = program.envelope.model_copy(update={"outline": outline(images / f"{file.stem}.png")})
                program = program.model_copy(update={"envelope": within})
        except ApartgenError:
            failed += 1
            continue
        try:
            made = plan.build(program, plan.PlanConfig(processes=1), rng)
        except ApartgenError:
            failed += 1
            asked["lost"] += sum(r.kind == "position" for r in program.requirements)
            continue
        for r in (r for r in made.program.requirements if r.kind == "position"):
            asked[f"{'beside' if r.to else 'place'} {'met' if r.met else 'unmet'}"] += 1
            if each and not r.met:
                print(file.stem, r.of, r.value, r.to or "", sep="\t")
        if images is not None and (images / f"{file.stem}.png").exists():
            ious.append(overlap(drawn(made), *painted(images / f"{file.stem}.png")))
    met = sum(n for name, n in asked.items() if name.endswith(" met"))
    had = asked.total() - asked["lost"]
    print(f"planned {len(files) - failed} of {len(files)}: places {met} of {had} met ({met / max(had, 1):.3f}; "
          f"of all, also without a plan, {met / max(asked.total(), 1):.3f}) {dict(asked)}; "
          f"macro IoU {np.mean(ious or [np.nan]):.3f} of {len(ious)}")


if __name__ == "__main__":
    main()
