"""Many plans on one picture: each in its square, all to one scale, those of larger homes larger."""

import numpy as np
import pytest
from commandline import run
from export import sample

from apartgen.schemas import artifact
from apartgen.schemas.plan import Plan
from apartgen.stages.export._contact import CELL, GAP, LEADING, LINES, contact
from apartgen.stages.export._drawing import ARROW
from apartgen.stages.space import polygons

WALL = 70
"""Walls are darker."""


def scaled(home, by):
    """A home whose rooms are larger by a factor."""
    body = home.model_dump()
    for room in body["rooms"]:
        room["polygon"] = [(x * by, y * by) for x, y in room["polygon"]]
    return Plan.model_validate({**body, "openings": []})


@pytest.fixture(scope="module")
def homes():
    home = Plan.model_validate(sample.home().model_dump(include=set(Plan.model_fields)))
    home = scaled(home, 1)
    return [home, scaled(home, 0.5), scaled(home, 1.5), home, home]


def extents(sheet, count, columns):
    """Pixels from left to right that walls take in each square."""
    dark = np.asarray(sheet.convert("L")) < WALL
    found = []
    for k in range(count):
        x, y = GAP + k % columns * (CELL + GAP), GAP + k // columns * (CELL + GAP + (LINES + 1) * LEADING)
        across = np.flatnonzero(dark[y:y + CELL, x:x + CELL].any(0))
        found.append(across.max() - across.min() + 1)
    return found


def test_plans_are_to_one_scale(homes):
    sheet = contact(homes, 3)
    sides = [polygons.shell(home).bounds for home in homes]
    widths = [x1 - x0 for x0, _, x1, _ in sides]
    largest = max(max(x1 - x0, y1 - y0) for x0, y0, x1, y1 in sides)
    for pixels, metres in zip(extents(sheet, 5, 3), widths):
        assert abs(pixels - metres / (largest + 2 * ARROW) * CELL) < 3
    assert sheet.size == (3 * (CELL + GAP) + GAP, 2 * (CELL + GAP + (LINES + 1) * LEADING) + GAP)


def test_each_is_told_of(homes):
    """Below each square something is written, and the same homes give the same bytes."""
    sheet = contact(homes, 5)
    below = np.asarray(sheet.convert("L"))[GAP + CELL + 2:]
    assert all((below[:, GAP + k * (CELL + GAP):][:, :CELL] < 160).any() for k in range(5))
    assert sheet.tobytes() == contact(homes, 5).tobytes()


def test_the_command_writes_any_number(capsys, monkeypatch, tmp_path):
    source, _ = artifact.finish(sample.home(), artifact.Made(by="test", seed=1))
    (tmp_path / "home.json").write_text(source)
    args = ["view", *[tmp_path / "home.json"] * 3]
    assert run(capsys, monkeypatch, *args, "-o", tmp_path / "homes.png").code == 0
    assert (tmp_path / "homes.png").read_bytes()[:4] == b"\x89PNG"
    assert run(capsys, monkeypatch, *args, "-o", tmp_path / "homes.html").code == 2
