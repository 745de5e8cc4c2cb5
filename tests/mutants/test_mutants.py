"""Changes of a few lines by hand, and a project of three functions: one tested, one badly, one not at all."""

import os
import subprocess
import sys
from types import ModuleType

import pytest
from mutants import __main__ as mutants
from mutants import covered, swift, trying
from mutants.changes import changes

SOURCE = '''
"""Words stay: 1 < 2."""
NEAR, FAR = 0.5, 3


@njit(cache=True)
def fast(x):
    return -x


def wide(a: int, b: int = 4) -> bool:
    text = f"é {a - b}" + "…"
    return not a < len(b) and max(
        a, b) == place(a, b)


def alike(a):
    return place(a, a)
'''


def seen(source: str) -> dict[tuple[str, str], str]:
    """Kinds of change by what becomes of which line."""
    return {change.lines(source.encode()): change.kind for change in changes("x.py", source.encode())}


def test_changes_by_hand() -> None:
    near, last = "NEAR, FAR = 0.5, 3", "a, b) == place(a, b)"
    first = "return not a < len(b) and max("
    assert seen(SOURCE) == {
        (near, "NEAR, FAR = 1.0, 3"): "number", (near, "NEAR, FAR = 0.5, 4"): "number",
        ("return -x", "return x"): "sign",
        (first, first.replace("not ", "")): "dropped not", (first, first.replace("<", ">=")): "comparison",
        (first, first.replace("<", "<=")): "off by one", (first, first.replace("and", "or")): "and, or",
        (first, first.replace("max", "min")): "other function",
        (last, last.replace("==", "!=")): "comparison", (last, "a, b) == place(b, a)"): "swapped",
        ('text = f"é {a - b}" + "…"', 'text = f"é {a + b}" + "…"'): "sign",
    }


def test_what_is_compiled_is_marked_and_statements_are_whole() -> None:
    found = {change.kind: change for change in changes("x.py", SOURCE.encode()) if change.function}
    assert found["sign"].function in ("fast", "wide")
    assert {change.function for change in changes("x.py", SOURCE.encode()) if change.compiled} == {"fast"}
    assert (found["swapped"].line, found["swapped"].first, found["swapped"].last) == (14, 13, 14)
    assert all(change.is_code(SOURCE.encode()) for change in changes("x.py", SOURCE.encode()))


CODE = '''"""Three functions."""


def larger(a, b):
    return a if a > b else b


def near(a, b):
    return abs(a - b) < 1


def alone(a):
    return a + 1
'''
TESTS = '''from apartgen.stages.sizes import larger, near
def test_larger():
    assert larger(1, 2) == 2 and larger(2, 1) == 2
def test_near():
    assert near(1, 1)
def test_fails():
    assert not near(1, 1)
'''


@pytest.fixture(scope="module")
def bench(tmp_path_factory) -> trying.Bench:
    root = tmp_path_factory.mktemp("project")
    empty = '"""A package."""\n'
    files = {"apartgen/__init__.py": empty, "schemas/__init__.py": empty, "stages/sizes/__init__.py": CODE,
             "tests/test_sizes.py": TESTS}
    for name, text in files.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text)
    git = ["git", "-c", "user.name=x", "-c", "user.email=x@x"]
    for command in (["init", "-q"], ["add", "."], ["commit", "-qm", "x"]):
        subprocess.run([*git, *command], cwd=root, check=True)
    commit = subprocess.run(["git", "rev-parse", "HEAD"], cwd=root, check=True, capture_output=True, text=True)
    at = tmp_path_factory.mktemp("at")
    work = covered.clone(root, at / "clone", commit.stdout.strip())
    around = dict(os.environ)
    covered.measure(work, at / "seen", at / "kernels", ["stages/sizes/__init__.py"], workers=2)
    assert dict(os.environ) == around, "it may be measured itself"
    return trying.Bench(work, covered.Seen(work, at / "seen"), at / "kernels", at / "results", 60.0)


def test_fates_of_changes(bench, monkeypatch) -> None:
    monkeypatch.setattr(sys, "dont_write_bytecode", False)  # what was compiled of one change is not run as another
    monkeypatch.delenv("PYTHONDONTWRITEBYTECODE", raising=False)
    file = "stages/sizes/__init__.py"
    source = (bench.work / file).read_bytes()
    by = {change.lines(source)[1]: change for change in changes(file, source)}
    larger, near, alone = (by[line] for line in (
        "return a if a <= b else b", "return abs(a + b) < 1", "return a - 1"))
    tests = {name: trying.ordered(bench, change) for name, change in (("l", larger), ("n", near), ("a", alone))}
    assert tests == {"l": ["tests/test_sizes.py::test_larger", "tests/test_sizes.py::test_near"],
                     "n": ["tests/test_sizes.py::test_near", "tests/test_sizes.py::test_larger"], "a": []}
    fate, first = trying.tried(bench, larger, tests["l"])
    assert fate == "killed" and "test_larger" in first
    assert trying.tried(bench, near, tests["n"])[0] == "killed", "1 and 1 are near, and 1 + 1 is not below 1"
    assert trying.tried(bench, by["return abs(a - b) < 2"], tests["n"]) == ("survived", "")
    assert trying.tried(bench, alone, tests["a"]) == ("not run", "")
    assert (bench.work / file).read_bytes() == source


def test_what_is_told(bench) -> None:
    rows = [{"part": part, "file": "f.py", "line": 3, "old": "a", "new": "b", "tests": 2, "fate": fate}
            for part, fate in (("plan", "killed"), ("plan", "too long"), ("plan", "survived"), ("space", "equivalent"),
                               ("space", "not run"))]
    lines = list(mutants.told(rows))
    assert [line.split() for line in lines[1:4]] == [
        ["plan", "2", "1", "0", "67%"], ["space", "0", "1", "1", "0%"], ["all", "2", "2", "1", "50%"]]
    assert sum("- a\n+ b" in line for line in lines) == 2


def test_changes_of_functions_are_tried_in_one_process(bench) -> None:
    """They end as those tried in a process each."""
    file = "stages/sizes/__init__.py"
    by = {change.lines((bench.work / file).read_bytes())[1]: change for change in changes(file, CODE.encode())}
    found = trying.quickly(bench, list(by.values()), workers=2)
    killed, survived = by["return a if a <= b else b"], by["return abs(a - b) < 2"]
    assert found[trying.key(killed)] == ("killed", "tests/test_sizes.py::test_larger")
    assert found[trying.key(survived)] == ("survived", "")
    assert trying.key(by["return a - 1"]) not in found, "no test runs it"
    assert not bench.seen.imports(killed)


def test_names_of_a_module_get_other_values_wherever_they_are_imported(monkeypatch) -> None:
    code = "NEAR, FAR = 0.5, 3\nSIDES = {'wide': 2 * NEAR}\ndef wide():\n    return SIDES['wide'] + FAR\n"
    one, other = ModuleType("apartgen.one"), ModuleType("apartgen.other")
    exec(code, vars(one))
    vars(other).update(FAR=one.FAR, SIDES=one.SIDES, NEAR=7.0)
    for module in (one, other):
        monkeypatch.setitem(sys.modules, module.__name__, module)
    assert swift._valued(one, compile(code.replace("0.5", "1.0"), "one.py", "exec"))
    assert (one.wide(), one.NEAR, other.SIDES, other.NEAR) == (5.0, 1.0, {"wide": 2.0}, 7.0)
    assert not swift._valued(one, compile(code.replace("0.5", "1.0"), "one.py", "exec")), "nothing is another value"
