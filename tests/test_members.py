"""Every member of every registry keeps its folder's contract; a new one is tested by being there."""

import inspect

import pytest

from apartgen.stages import registry

CONTRACTS = {
    "apartgen.stages.export": ("write", ["scene", "out"]),
    "apartgen.stages.layout.guidance": ("energy", ["boxes", "room"]),
    "apartgen.stages.layout.datasets": ("homes", ["root"]),
    "apartgen.stages.metrics": ("measure", ["home", "against"]),
    "apartgen.stages.retrieve": ("assets", ["root"]),
}
"""A registry's function and its first arguments."""
NOT_MEMBERS = {"apartgen.stages.retrieve": {"matching", "preview", "reading", "shape", "furniture"}}
"""Packages of a stage that are no libraries."""
ALTERNATIVES = {"apartgen.stages.metrics": "compare"}


def names(package: str) -> list[str]:
    try:
        return sorted(set(registry.members(package)) - NOT_MEMBERS.get(package, set()))
    except ModuleNotFoundError:
        return []


MEMBERS = [(package, name) for package in CONTRACTS for name in names(package)]


@pytest.mark.parametrize("package, name", MEMBERS)
def test_a_member_keeps_the_contract(package, name):
    wanted, arguments = CONTRACTS[package]
    member = registry.load(package, name)
    assert registry.members(package)[name], f"{package}.{name} has no docstring; its first line is its help"
    if package in ALTERNATIVES and not hasattr(member, wanted):
        assert callable(getattr(member, ALTERNATIVES[package]))
        return
    function = getattr(member, wanted)
    assert list(inspect.signature(function).parameters)[: len(arguments)] == arguments
    assert function.__module__ == member.__name__, f"{name} is one file; its {wanted} is defined in it"


def test_commands_are_a_registry_too():
    from apartgen_cli.main import WORDS

    helps = registry.members("apartgen_cli")
    assert all(helps.values())
    for word in WORDS:
        assert callable(registry.load("apartgen_cli", word).commands)
