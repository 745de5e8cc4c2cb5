"""Registries list their members without importing them, and load one by name."""

import re
import sys
from collections.abc import Iterator
from types import ModuleType
from typing import Protocol

import pytest

from apartgen.schemas.errors import BadInput
from apartgen.stages import registry
from apartgen.stages.registry import contract


@pytest.fixture
def package(tmp_path, monkeypatch):
    folder = tmp_path / "zoo"
    (folder / "owl").mkdir(parents=True)
    (folder / "__init__.py").write_text("")
    (folder / "cat.py").write_text('"""Purrs.\n\nMore."""\nsound = "meow"\n')
    (folder / "broken.py").write_text('"""Never imported by listing."""\nraise RuntimeError\n')
    (folder / "owl" / "__init__.py").write_text('"""Hoots."""\n')
    (folder / "newt.py").write_text('# Of ponds.\n\n"""Swims.\n"""\n')
    (folder / "silent.py").write_text('sound = "none"\n')
    (folder / "_private.py").write_text('"""Hidden."""\n')
    monkeypatch.syspath_prepend(str(tmp_path))
    registry._folders.cache_clear()
    yield "zoo"
    for name in [name for name in sys.modules if name.partition(".")[0] == "zoo"]:
        del sys.modules[name]
    registry._folders.cache_clear()


def test_members_are_listed_with_help_and_not_imported(package):
    assert registry.members(package) == {
        "broken": "Never imported by listing.", "cat": "Purrs.", "newt": "Swims.", "owl": "Hoots.", "silent": ""}
    assert not any(name.startswith("zoo.") for name in sys.modules)


def test_a_member_is_loaded_by_name(package):
    assert registry.load(package, "cat").sound == "meow"


def test_an_unknown_name_says_which_there_are(package):
    with pytest.raises(BadInput, match="did you mean 'cat'.*broken, cat, newt, owl, silent"):
        registry.load(package, "cap")
    with pytest.raises(BadInput, match="no zoo '_private'; there are: broken"):
        registry.load(package, "_private")


def test_a_fact_is_read_without_an_import(package, tmp_path):
    """Of a member that says nothing it is what it is of most."""
    (tmp_path / "zoo/tame.py").write_text('"""Tame."""\nBITES: bool = False\nif BITES:\n    BITES = True\n')
    assert not registry.stated(package, "tame", "BITES", True)
    assert registry.stated(package, "owl", "BITES", True) and registry.stated(package, "broken", "BITES", True)
    assert not any(name.startswith("zoo.") for name in sys.modules)
    with pytest.raises(BadInput, match="did you mean 'tame'"):
        registry.stated(package, "tam", "BITES", True)


@pytest.mark.parametrize("text", ["'no'", "not True", "1", "[]", "open"])
def test_a_fact_is_written_out_and_of_its_type(package, tmp_path, text):
    (tmp_path / "zoo/wild.py").write_text(f'"""Wild."""\nBITES = {text}\n')
    with pytest.raises(BadInput, match=f"^zoo wild: BITES = {re.escape(text)} is no bool; write it as True or False$"):
        registry.stated(package, "wild", "BITES", True)


class Doubles(Protocol):
    """A contract of one function."""

    def double(self, number: int) -> int:
        """Twice as much."""


def inner_fault(number: int) -> int:
    raise ZeroDivisionError("inside")


def test_a_guarded_member_is_itself_until_it_fails() -> None:
    member = ModuleType("stranger", "Doubles numbers.")
    vars(member).update(double=lambda number: 2 * number, OTHER="stays")
    guard = contract.guarded(member, (Doubles,), str)
    assert (guard.__name__, guard.__doc__, guard.OTHER, guard.double(4)) == ("stranger", "Doubles numbers.", "stays", 8)


def test_a_fault_is_told_with_the_line_that_raised_it() -> None:
    """Not with a line on the way there."""
    member = ModuleType("stranger")
    vars(member)["double"] = lambda number: inner_fault(inner_fault(number))
    line = inner_fault.__code__.co_firstlineno + 1
    with pytest.raises(BadInput, match=rf"theirs: .*ZeroDivisionError: inside \({re.escape(__file__)}:{line}\)"):
        contract.guarded(member, (Doubles,), "theirs: {}".format).double(1)


def test_what_gives_another_type_is_told() -> None:
    member = ModuleType("stranger")
    vars(member)["double"] = str
    with pytest.raises(BadInput, match="gave a str, not a int"):
        contract.guarded(member, (Doubles,), str).double(1)


class Halves(Protocol):
    """A contract of numbers with a fraction."""

    def half(self, number: int) -> float:
        """Half as much."""


def test_a_whole_number_is_a_number() -> None:
    member = ModuleType("stranger")
    vars(member)["half"] = lambda number: number // 2
    assert contract.guarded(member, (Halves,), str).half(8) == 4
    vars(member)["half"] = lambda number: number > 2
    with pytest.raises(BadInput, match="gave a bool, not a float"):
        contract.guarded(member, (Halves,), str).half(8)


class Both(Protocol):
    """A contract of two functions."""

    def double(self, number: int) -> int:
        """Twice as much."""

    def half(self, number: int) -> int:
        """Half as much."""


def test_a_member_that_keeps_part_of_a_contract_is_told_the_rest() -> None:
    member = ModuleType("stranger")
    vars(member)["double"] = lambda number: 2 * number
    said = contract.fault(member, (Both,))
    assert "half" in said and "double" not in said
    vars(member)["half"] = lambda number: number // 2
    assert contract.fault(member, (Both,)) == ""
    assert "double" in contract.fault(ModuleType("other"), (Both,)) and contract.fault(ModuleType("other"), ()) == ""


class Configured(Protocol):
    """A contract with a type and a value."""

    Config: type[int]
    LEAST: float


def test_a_type_that_is_asked_for_is_a_type_and_a_value_any() -> None:
    member = ModuleType("stranger")
    vars(member).update(Config=bool, LEAST=3)
    assert list(contract._lacks(member, Configured)) == []
    vars(member).update(Config=3)
    assert list(contract._lacks(member, Configured)) == ["has no Config that will do"]
    vars(member).update(Config=bool, LEAST=None)
    assert list(contract._lacks(member, Configured)) == ["has no LEAST"]


class Many(Protocol):
    """A contract of several values at once."""

    def some(self, number: int) -> list[int]:
        """So many."""

    def each(self, number: int) -> Iterator[int]:
        """So many, one after another."""


@pytest.mark.parametrize(("name", "gives", "words"), [
    ("some", [1, 2], ""), ("some", [], ""), ("some", (1, 2), "gave a tuple, not a list of int"),
    ("some", None, "gave nothing, not a list of int"),
    ("some", [1, "2"], "gave a list with a str, not of int"), ("each", (1, 2), ""), ("each", [], ""),
    ("each", [1, "2"], "gave a str, not a int")])
def test_of_several_values_each_is_of_its_type(name, gives, words) -> None:
    member = ModuleType("stranger")
    vars(member)[name] = lambda number: gives
    guard = contract.guarded(member, (Many,), "theirs: {}".format)
    assert not hasattr(guard, "each" if name == "some" else "some"), "what is not there is not guarded"
    if words:
        with pytest.raises(BadInput, match=f"^theirs: <lambda> {words}$"):
            list(getattr(guard, name)(2))
    else:
        assert list(getattr(guard, name)(2)) == list(gives)


def test_what_fails_between_values_is_told_and_what_we_refuse_passes() -> None:
    def broken(number):
        yield number
        raise BadInput("as we say it") if number else KeyError("gone")

    member = ModuleType("stranger")
    vars(member)["each"] = broken
    guard = contract.guarded(member, (Many,), "theirs: {}".format)
    with pytest.raises(BadInput, match="^theirs: broken failed, KeyError: 'gone'"):
        list(guard.each(0))
    with pytest.raises(BadInput, match="^as we say it$"):
        list(guard.each(1))


@pytest.mark.parametrize(("function", "said"), [
    (lambda number: 0, ""), (lambda number, further=1: 0, ""), (3, "has no double(number)"),
    (lambda: 0, "has double() where double(number) is called"),
    (lambda count: 0, "has double(count) where double(number) is called")])
def test_arguments_are_called_as_the_contract_calls_them(function, said) -> None:
    member = ModuleType("stranger")
    vars(member)["double"] = function
    assert contract.fault(member, (Doubles,)) == said


def test_a_member_that_a_package_brings_is_loaded_from_there(package, monkeypatch):
    brought = {(package, "emu"): "theirs"}
    monkeypatch.setattr(registry, "bringer", lambda folder, name: brought.get((folder, name)))
    monkeypatch.setattr(registry, "_source", lambda folder, name: None)
    monkeypatch.setattr(registry, "_brought_in", lambda plugin, protocols: plugin)
    assert registry.load(package, "emu") == "theirs"
    assert registry.load(package, "cat").sound == "meow"
