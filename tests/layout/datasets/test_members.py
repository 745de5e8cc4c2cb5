"""Every data source keeps the contract, and refuses what is none of its own."""

import inspect
from pathlib import Path

import pytest

from apartgen.schemas.errors import BadInput
from apartgen.stages.layout import datasets


@pytest.mark.parametrize("name", datasets.names())
def test_a_source_has_help_and_homes(name: str) -> None:
    member = datasets.source(name)
    assert member.__doc__ and member.__doc__.splitlines()[0].endswith((".", ","))
    assert next(iter(inspect.signature(member.homes).parameters)) == "root"


def test_an_unknown_source_is_named_with_those_there_are() -> None:
    with pytest.raises(BadInput, match="furnisher"):
        datasets.source("nothing")


@pytest.mark.parametrize("name", [name for name in datasets.names() if name != "single_rooms"])
def test_a_missing_folder_is_bad_input(name: str, tmp_path: Path) -> None:
    with pytest.raises(BadInput):
        list(datasets.source(name).homes(tmp_path / "nowhere"))


@pytest.mark.parametrize("name", ["procthor", "ssr", "furnisher", "front3d"])
def test_a_broken_file_is_bad_input(name: str, tmp_path: Path) -> None:
    (tmp_path / "broken.json").write_text('{"rooms": 3}')
    (tmp_path / "model_info.json").write_text("[]")
    (tmp_path / "asset-database.json").write_text("{}")
    with pytest.raises(BadInput):
        list(datasets.source(name).homes(tmp_path))
