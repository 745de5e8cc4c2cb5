"""A contact sheet: plans of many homes on one picture, to one scale, with what was asked for and their areas."""

import textwrap
from collections.abc import Sequence
from io import BytesIO
from math import ceil, sqrt
from typing import TYPE_CHECKING

from matplotlib.font_manager import FontProperties, findfont

from apartgen.schemas.plan import Plan
from apartgen.stages.export._drawing import ARROW, INCH, bare
from apartgen.stages.space import polygons

if TYPE_CHECKING:
    from PIL.Image import Image

CELL = 360
"""Pixels of a home's square."""
GAP = 16
SMALL, LINES = 13, 2
"""Size of text in pixels, and lines of a sentence."""
LETTERS = 46
"""Of a line."""
LEADING = 17
INK, FAINT, PAPER = "#222222", "#777777", "white"


def contact(homes: Sequence[Plan], columns: int | None = None) -> "Image":
    """The sheet, as many homes in a row as below one another unless columns are given."""
    from PIL import Image

    columns = columns or ceil(sqrt(len(homes)))
    wide, high = CELL + GAP, CELL + GAP + (LINES + 1) * LEADING
    sheet = Image.new("RGB", (columns * wide + GAP, -(-len(homes) // columns) * high + GAP), PAPER)
    sides = [polygons.shell(home).bounds for home in homes]
    metre = CELL / (max(max(x1 - x0, y1 - y0) for x0, y0, x1, y1 in sides) + 2 * ARROW)
    for k, home in enumerate(homes):
        x, y = GAP + k % columns * wide, GAP + k // columns * high
        plan = _plan(home, metre)
        sheet.paste(plan, (x + (CELL - plan.width) // 2, y + (CELL - plan.height) // 2))
        _told(sheet, k + 1, home, (x, y + CELL + 4))
    return sheet


def _plan(home: Plan, metre: float) -> "Image":
    """One home without words, so many pixels a metre."""
    from PIL import Image

    drawn = BytesIO()
    bare(home).savefig(drawn, format="png", dpi=metre / INCH)
    with Image.open(drawn) as plan:
        return plan.convert("RGB")


def _told(sheet: "Image", number: int, home: Plan, at: tuple[int, int]) -> None:
    from PIL import ImageDraw, ImageFont

    font = ImageFont.truetype(findfont(FontProperties(family="DejaVu Sans")), SMALL)
    area = sum(polygons.floor(room).area for room in home.rooms)
    lines = textwrap.wrap(home.prompt or "", LETTERS, max_lines=LINES, placeholder=" …")
    pen = ImageDraw.Draw(sheet)
    for k, line in enumerate(lines):
        pen.text((at[0], at[1] + k * LEADING), line, fill=INK, font=font)
    rooms = f"{len(home.rooms)} room{'s' if len(home.rooms) > 1 else ''}"
    pen.text((at[0], at[1] + len(lines) * LEADING), f"{number}  ·  {area:.0f} m²  ·  {rooms}", fill=FAINT, font=font)
