"""Numbers on things in pictures: a question that means "the thing marked 3" tells nothing of it by its words."""

from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

import numpy as np

from apartgen.schemas.qa import Question
from apartgen.schemas.render import Render, View

MARKED = ".marks"
"""Ends the names of pictures with numbers; those without are NAME.rgb."""
COVERS = 0.006
"""Share of a picture that a thing must cover to get a number."""
RADIUS = 1 / 40
"""Of a mark, as a share of the picture's height; all of it lies on its thing."""
MOST = 12
"""Numbers in a picture."""

Marks = Mapping[str, Mapping[str, int]]
Meant = Callable[[str, View, tuple[int, int]], bool]
"""Whether a number at a pixel of a view means a thing, by its id."""


def dealt(render: Render, objects: Iterable[str], rng: np.random.Generator,
          meant: Meant = lambda id, view, pixel: True) -> dict[str, dict[str, int]]:
    """By view at the height of eyes, the number of each object that is seen well and `meant` by a number at its pixel;
    numbers are drawn by chance.
    """
    ids, known = {thing.number: thing.id for thing in render.instances}, set(objects)
    found = {}
    for view in (view for view in render.views if view.kind == "eye"):
        parts = [part for part in view.visible if ids[part.number] in known and part.inmost[2] >= _radius(view)
                 and part.pixels > COVERS * view.width * view.height
                 and meant(ids[part.number], view, part.inmost[:2])]
        kept = sorted(parts, key=lambda part: (-part.pixels, part.number))[:MOST]
        numbers = rng.permutation(len(kept)) + 1
        found[view.name] = {ids[part.number]: int(number) for part, number in zip(kept, numbers)}
    return found


def _radius(view: View) -> int:
    return max(3, round(RADIUS * view.height))


def file_of(image: str) -> str:
    """The file of a question's picture."""
    return f"{image}.png" if image.endswith(MARKED) else f"{image}.rgb.png"


def view_of(image: str) -> str:
    """The view that a question's picture is of."""
    return image.removesuffix(MARKED)


def draw(questions: Iterable[Question], folder: Path) -> list[Path]:
    """Write the pictures with numbers that questions need beside those without."""
    wanted = {question.images[0]: question.marks for question in questions if question.marks}
    return [_drawn(folder / file_of(view_of(name)), folder / file_of(name), marks)
            for name, marks in sorted(wanted.items())]


def _drawn(source: Path, target: Path, marks: Mapping[str, tuple[int, int]]) -> Path:
    from PIL import Image, ImageDraw, ImageFont

    with Image.open(source) as picture:
        picture.load()
    r = max(3, round(RADIUS * picture.height))
    pen, font = ImageDraw.Draw(picture), ImageFont.load_default(1.5 * r)
    for number, (x, y) in marks.items():
        pen.ellipse((x - r, y - r, x + r, y + r), fill="white", outline="black")
        pen.text((x + 0.5, y + 0.5), number, fill="black", font=font, anchor="mm")
    picture.save(target, "PNG")
    return target
