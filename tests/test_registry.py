"""Registries list their members without importing them, and load one by name."""

import sys

import pytest

from apartgen.schemas.errors import BadInput
from apartgen.stages import registry


@pytest.fixture
def package(tmp_path, monkeypatch):
    folder = tmp_path / "zoo"
    (folder / "owl").mkdir(parents=True)
    (folder / "__init__.py").write_text("")
    (folder / "cat.py").write_text('"""Purrs.\n\nMore."""\nsound = "meow"\n')
    (folder / "broken.py").write_text('"""Never imported by listing."""\nraise RuntimeError\n')
    (folder / "owl" / "__init__.py").write_text('"""Hoots."""\n')
    (folder / "_private.py").write_text('"""Hidden."""\n')
    monkeypatch.syspath_prepend(str(tmp_path))
    registry._folders.cache_clear()
    yield "zoo"
    for name in [name for name in sys.modules if name.partition(".")[0] == "zoo"]:
        del sys.modules[name]
    registry._folders.cache_clear()


def test_members_are_listed_with_help_and_not_imported(package):
    assert registry.members(package) == {
        "broken": "Never imported by listing.", "cat": "Purrs.", "owl": "Hoots."}
    assert not any(name.startswith("zoo.") for name in sys.modules)


def test_a_member_is_loaded_by_name(package):
    assert registry.load(package, "cat").sound == "meow"


def test_an_unknown_name_says_which_there_are(package):
    with pytest.raises(BadInput, match="did you mean 'cat'.*broken, cat, owl"):
        registry.load(package, "cap")
    with pytest.raises(BadInput):
        registry.load(package, "_private")
