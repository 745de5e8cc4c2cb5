"""The notebook runs from its first cell to its last, and shows what it says."""

import ast
import json
from pathlib import Path

import matplotlib
import pytest
from matplotlib.figure import Figure
from PIL import Image
from syntax import tree_of

FILE = Path(__file__).parent.parent / "examples/first_steps.ipynb"


@pytest.fixture(scope="module")
def ran():
    """What the last line of every cell of code gives, as a notebook shows it, and all names."""
    matplotlib.use("Agg")
    shown, names = [], {}
    for cell in json.loads(FILE.read_text(encoding="utf-8"))["cells"]:
        if cell["cell_type"] == "code":
            tree = tree_of("".join(cell["source"]))
            *before, last = tree.body
            exec(compile(ast.Module(before, []), str(FILE), "exec"), names)
            assert isinstance(last, ast.Expr)
            shown.append(eval(compile(ast.Expression(last.value), str(FILE), "eval"), names))
    return shown, names


def test_it_runs(ran):
    shown, names = ran
    rooms, plan, parts, picture, seen, files = shown
    assert "living_room" in rooms.values() and "balcony" in rooms.values()
    assert isinstance(plan, Figure) and len(plan.axes[0].patches) > len(rooms) + 5
    assert isinstance(parts, Figure) and sum(bar.get_height() for bar in parts.axes[0].patches) == len(names["joints"])
    assert isinstance(picture, Image.Image) and picture.size == (480, 320)
    assert len(seen) == 8 and seen[0][1] >= seen[-1][1]
    assert {"scene.xml", "apartment.glb"} & set(files) and "SHA256SUMS" in files


def test_it_is_written_as_notebooks_are():
    book = json.loads(FILE.read_text(encoding="utf-8"))
    assert (book["nbformat"], book["nbformat_minor"]) == (4, 5)
    assert len({cell["id"] for cell in book["cells"]}) == len(book["cells"])
    for cell in book["cells"]:
        wanted = {"cell_type", "id", "metadata", "source"}
        assert set(cell) == wanted | ({"execution_count", "outputs"} if cell["cell_type"] == "code" else set())
