"""Every member of every registry keeps its folder's protocols; a new one is tested by being there."""

import re
import types
from pathlib import Path
from typing import Union, get_args, get_origin, get_type_hints

import pytest

from apartgen.schemas.errors import BadInput
from apartgen.schemas.plan import Plan
from apartgen.stages import registry
from apartgen.stages.registry import contract
from apartgen.stages.retrieve.matching.indexing import PACKAGES

ROOT = Path(__file__).parent.parent
INSTALLED = {"stages": "apartgen.stages"}
NOT_MEMBERS = {"apartgen.stages.retrieve": PACKAGES}
"""Packages of a stage that are no libraries."""


def registries() -> list[str]:
    """The packages of all folders that say what their members are."""
    files = [file for part in ("stages", "apartgen_cli") for file in (ROOT / part).glob("**/_protocol.py")]
    folders = [file.parent.relative_to(ROOT) for file in files]
    return sorted(".".join([INSTALLED.get(folder.parts[0], folder.parts[0]), *folder.parts[1:]]) for folder in folders)


def words(package: str) -> set[str]:
    """Modules beside the commands that are none."""
    from apartgen_cli.main import WORDS

    return set(registry.members(package)) - set(WORDS) if package == "apartgen_cli" else set()


MEMBERS = [(package, name) for package in registries() for name in registry.members(package)
           if name not in NOT_MEMBERS.get(package, words(package))]


def test_the_registries_are_those_of_the_documents():
    assert {"apartgen_cli", "apartgen_cli.bench", "apartgen.stages.export", "apartgen.stages.metrics",
            "apartgen.stages.layout.guidance", "apartgen.stages.layout.datasets",
            "apartgen.stages.retrieve", "apartgen.stages.layout.choice"} <= set(registries())


@pytest.mark.parametrize("package, name", MEMBERS)
def test_a_member_keeps_the_contract(package, name):
    member = registry.load(package, name)
    assert registry.members(package)[name], f"{package}.{name} has no docstring; its first line is its help"
    assert not contract.fault(member, contract.protocols(package))


@pytest.mark.parametrize("package, name", MEMBERS)
def test_a_member_says_the_types_of_its_protocol(package, name):
    """Arguments and results are annotated as the protocol has them."""
    member = registry.load(package, name)
    for protocol in contract.protocols(package):
        for called, wanted in contract.functions(protocol).items():
            if hasattr(member, called):
                found, asked = get_type_hints(getattr(member, called)), get_type_hints(wanted)
                assert found["return"] == asked.pop("return")
                narrow = {key for key in asked if not accepts(found.get(key)) >= accepts(asked[key])}
                assert not narrow, f"{called} of {package}.{name}"


def accepts(hint) -> set:
    """The types that an argument may be of."""
    return set(get_args(hint)) if get_origin(hint) in (types.UnionType, Union) else {hint}


def module(**values):
    made = types.ModuleType("made")
    vars(made).update(values)
    return made


def measure(home, against=None):
    return []


@pytest.mark.parametrize("values, fault", [
    ({}, r"has no measure\(home, against\) or compare\(homes, real\)"),
    ({"measure": measure}, "has no NEEDS.*; write `NEEDS = Layout`"),
    ({"measure": measure, "NEEDS": 3}, "has no NEEDS.*; write `NEEDS = Layout`"),
    ({"measure": measure, "NEEDS": int}, "has no NEEDS.*; write `NEEDS = Layout`"),
    ({"measure": lambda home: [], "NEEDS": Plan}, r"has measure\(home\) where measure\(home, against\) is called"),
    ({"measure": measure, "NEEDS": Plan, "compare": 3}, r"has no compare\(homes, real\)"),
    ({"measure": measure, "NEEDS": Plan}, "^$"),
    ({"compare": lambda homes, real, network: []}, "^$"),
])
def test_what_a_metric_lacks_is_said(values, fault):
    assert re.search(fault, contract.fault(module(**values), contract.protocols("apartgen.stages.metrics")))


def test_a_member_without_its_contract_is_an_error_that_says_so(tmp_path, monkeypatch):
    """A metric without NEEDS is told by name; nothing crashes."""
    from apartgen.stages import metrics

    (tmp_path / "lame.py").write_text('"""Lame."""\n\n\ndef measure(home, against=None):\n    return []\n')
    monkeypatch.setattr(metrics, "__path__", [*metrics.__path__, str(tmp_path)])
    monkeypatch.setattr(registry, "_folders", lambda package: tuple(map(Path, metrics.__path__)))
    with pytest.raises(BadInput, match="metrics 'lame' has no NEEDS.*lame.py"):
        registry.load("apartgen.stages.metrics", "lame")
