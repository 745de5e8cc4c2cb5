"""What packages bring is found by its entry points, and known again by what it consists of."""

import importlib
import sys

import pytest

from apartgen.schemas import plugins

POINTS = """[apartgen.categories]
mine = mine:categories.toml

[apartgen.export]
labels = mine.labels
"""


def forget() -> None:
    """As a new process would."""
    for function in (plugins._points, plugins.brought, plugins.digest):
        function.cache_clear()
    importlib.invalidate_caches()


@pytest.fixture
def site(tmp_path, monkeypatch):
    """A folder with a package that brings a category and an export format, and a helper beside them."""
    about = tmp_path / "mine-1.0.dist-info"
    written = {"mine/labels.py": '"""Labels."""', "mine-1.0.dist-info/entry_points.txt": POINTS}
    empty = ("mine/__init__.py", "mine/categories.toml", "mine/shared.py", "mine/words.txt")
    for file, text in (dict.fromkeys(empty, "") | written).items():
        (tmp_path / file).parent.mkdir(exist_ok=True)
        (tmp_path / file).write_text(text)
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: mine\nVersion: 1.0\n")
    monkeypatch.syspath_prepend(str(tmp_path))
    forget()
    yield tmp_path
    monkeypatch.undo()
    forget()


def digests() -> list[str]:
    forget()
    return [plugins.digest(group) for group in ("apartgen.categories", "apartgen.export", "apartgen.metrics")]


def test_nothing_has_no_digest() -> None:
    """So that what is made without packages is the same byte for byte as ever."""
    assert plugins.digest("apartgen.nothing") == plugins.digest() == ""


@pytest.mark.parametrize(("file", "others"), [
    ("mine/categories.toml", [True, False, False]), ("mine/labels.py", [False, True, False]),
    ("mine/shared.py", [True, True, False]), ("mine/words.txt", [False, False, False]),
    ("mine-1.0.dist-info/METADATA", [True, True, False])])
def test_a_change_is_one_of_what_it_takes_part_in(site, file, others) -> None:
    """A member's file counts for its group, other code for all of its package, other files for nothing."""
    before = digests()
    assert digests() == before and before[2] == "" and "" not in before[:2]
    (site / file).write_text((site / file).read_text().replace("1.0", "1.1") + "\n")
    assert [a != b for a, b in zip(before, digests())] == others
    assert "mine" not in sys.modules, "nothing is imported"


def test_a_member_that_is_a_package_counts_with_all_its_files(site) -> None:
    (site / "mine/labels.py").unlink()
    (site / "mine/labels").mkdir()
    (site / "mine/labels/__init__.py").write_text('"""Labels."""')
    (site / "mine/labels/inner.py").write_text("")
    before = digests()
    (site / "mine/labels/inner.py").write_text("A = 1")
    assert [a != b for a, b in zip(before, digests())] == [False, True, False]


def test_a_group_that_nobody_looks_into_is_told(site, caplog) -> None:
    points = site / "mine-1.0.dist-info/entry_points.txt"
    points.write_text(points.read_text().replace("apartgen.export", "apartgen.exports"))
    forget()
    assert plugins.brought("apartgen.export") == {}
    assert "mine: " in caplog.text and "did you mean 'export'" in caplog.text
