"""The library: functions that a person calls, the same homes as the commands make, errors that can be caught."""

import doctest
import inspect
import json
from pathlib import Path

import handmade
import pytest

import apartgen
from apartgen.schemas.errors import BadInput
from apartgen_cli.main import status

EXAMPLE = Path(__file__).parents[1] / "examples" / "two-bedroom-flat"


def test_examples_in_the_documentation_run() -> None:
    found = doctest.testmod(apartgen)
    assert found.attempted >= 3 and not found.failed


def test_a_home_comes_out_as_by_the_commands(tmp_path: Path) -> None:
    asked, files = "studio", [tmp_path / f"{word}.json" for word in ("plan", "layout", "retrieve", "walkable")]
    assert status(["-q", "plan", asked, "--seed", "5", "-o", str(files[0])]) == 0
    for before, after in zip(files, files[1:]):
        assert status(["-q", after.stem, str(before), "-o", str(after)]) == 0
    home = apartgen.plan(asked, seed=5)
    for step in (apartgen.layout, apartgen.retrieve, apartgen.walkable):
        home = step(home)
    by_command = apartgen.load(files[-1])
    assert home.body == by_command.body and home.digest == by_command.digest
    home.save(tmp_path / "mine.json")
    assert apartgen.load(tmp_path / "mine.json").digest == home.digest
    assert "apartgen" in json.loads((tmp_path / "mine.json").read_text())


def test_a_home_is_taken_from_a_file_and_written_for_people(tmp_path: Path) -> None:
    files = apartgen.export(EXAMPLE / "walkable.json", tmp_path / "out", ["svg"])
    assert files.files and all((tmp_path / "out" / file.path).exists() for file in files.files)
    values = apartgen.metrics(str(EXAMPLE / "walkable.json"), metric=["collision"]).values
    assert {value.name for value in values} >= {"Col_obj"}


def test_what_a_user_can_get_wrong_is_said(tmp_path: Path) -> None:
    handmade_plan = tmp_path / "plan.json"
    handmade_plan.write_text(json.dumps({"apartgen": "plan", "version": 1, "made": {"by": "hand", "seed": 0},
                                         "body": handmade.plan().model_dump(mode="json")}))
    for call, words in (
        (lambda: apartgen.plan(" "), "empty"),
        (lambda: apartgen.plan("studio", heigth=3), "'heigth' is unknown"),
        (lambda: apartgen.plan("studio", height=-3), "height -3"),
        (lambda: apartgen.load(tmp_path / "none.json"), "none.json"),
        (lambda: apartgen.retrieve(handmade_plan), "layout"),
        (lambda: apartgen.export(handmade_plan, tmp_path / "o", ["obj8"]), "obj8"),
        (lambda: apartgen.make("studio", tmp_path / "m", settings={"planing": {}}), "planing"),
    ):
        with pytest.raises(BadInput, match=words):
            call()


def test_every_function_is_typed_and_says_what_it_gives() -> None:
    assert (Path(apartgen.__file__).parent / "py.typed").exists()
    for name in apartgen.__all__:
        function = getattr(apartgen, name)
        assert function.__doc__ and "return" in function.__annotations__, name
        assert all(p.annotation is not p.empty for p in inspect.signature(function).parameters.values()), name
