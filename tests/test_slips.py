"""Slips that people make in packages are told where they are made, in words that say what to write."""

import re
from contextlib import nullcontext
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest

from apartgen.schemas import plugins
from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Box, Layout
from apartgen.schemas.metrics import Metrics, Value
from apartgen.schemas.plan import AskedRoom, Plan, Program, Room
from apartgen.schemas.plugins import Plugin
from apartgen.stages import export, metrics, registry
from apartgen.stages.layout.relations import elbowroom
from apartgen.stages.registry import contract
from apartgen.stages.retrieve import furniture
from apartgen.stages.retrieve.furniture import foreign
from apartgen.stages.retrieve.furniture.body import Body
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.things import categories
from apartgen.stages.things.categories import TABLE, read
from apartgen.stages.use import kinds, room

MINE = Plugin("mine", "mine.module", "my-home")
TOLD = "^my-home: mine = 'mine.module': "
MEASURES = contract.protocols("apartgen.stages.metrics")


def member(**given) -> ModuleType:
    module = ModuleType("mine")
    vars(module).update(given)
    return module


def measure(home, against=None):
    return []


@pytest.fixture
def warned(monkeypatch):
    """What is warned of."""
    said: list[str] = []
    for module in (metrics, furniture, plugins):
        log = "LOG" if module is metrics else "log"
        monkeypatch.setattr(module, log, SimpleNamespace(warning=lambda form, *text: said.append(form % text)))
    return said


@pytest.fixture
def newcomers(monkeypatch):
    """A category like pianos, one like that, and one like tables, which need floor before them but for the second."""
    rows = {"pinball": {"like": "piano", "stands": {"before": 0.8}}, "flipper": {"like": "pinball", "stands": {}},
            "altar": {"like": "dining_table", "stands": {"before": 1.0}}}
    table = TABLE | read(rows, TABLE)
    for module in (categories, kinds, room, elbowroom):
        monkeypatch.setattr(module, "TABLE", table)
    cached = (kinds.basic, room._newcomers, elbowroom._own, elbowroom._bars)
    for function in cached:
        function.cache_clear()
    yield table
    monkeypatch.undo()
    for function in cached:
        function.cache_clear()


@pytest.mark.parametrize("needs", [{}, {"NEEDS": int}, {"NEEDS": None}, {"NEEDS": "Layout"}])
def test_a_metric_needs_an_artifact(needs):
    fault = contract.fault(member(measure=measure, **needs), MEASURES)
    said = r"has no NEEDS( that will do)?; write `NEEDS = Layout`; Plan, Layout, Retrieve or Walkable"
    assert re.fullmatch(said, fault)
    assert contract.fault(member(measure=measure, NEEDS=Layout), MEASURES) == ""


@pytest.fixture
def measured(monkeypatch):
    """Two metrics, of which one is another package's and does as it is told."""
    def one(home, against):
        return [Value(name="one", value=1)]

    def setting(theirs):
        theirs.__name__ = "measure"
        guarded = contract.guarded(member(measure=theirs, NEEDS=Plan), MEASURES[:1], MINE.told)
        found = {"mine": guarded, "one": SimpleNamespace(measure=one, NEEDS=Plan)}
        monkeypatch.setattr(metrics, "_sound", lambda: found)
        monkeypatch.setattr(metrics, "_member", found.__getitem__)

    monkeypatch.setattr(metrics.registry, "bringer", lambda package, name: MINE if name == "mine" else None)
    return setting


@pytest.mark.parametrize("theirs, fault", [
    (lambda home, against=None: 1 / 0, "measure failed, ZeroDivisionError"),
    (lambda home, against=None: exit(3), "measure failed, SystemExit: 3"),
    (lambda home, against=None: [Value(name="", value=1)], "measure gave a value without a name"),
    (lambda home, against=None: [Value(name="a", value=1, units="m")],
     "measure failed, TypeError: Value has no field 'units'; did you mean 'unit'"),
])
def test_a_metric_that_fails_ends_what_asked_for_it_by_name_alone(measured, warned, theirs, fault):
    measured(theirs)
    home = Layout(program=Program(rooms=[AskedRoom(id="study_1", type="study")]), openings=[], objects=[],
                  rooms=[Room(id="study_1", type="study", polygon=[(0, 0), (3, 0), (3, 3), (0, 3)])])
    assert [value.name for value in metrics.run(home).values] == ["one"]
    assert len(warned) == 1 and re.match(TOLD + fault, warned.pop())
    with pytest.raises(BadInput, match=TOLD + fault):
        metrics.run(home, ["mine"])
    assert warned == []


def test_files_of_newer_versions_are_read_over():
    """What is refused in code."""
    text = '{"values": [{"name": "a", "value": 1.0, "shade": "blue"}, {"name": "", "value": null}]}'
    assert [value.name for value in Metrics.model_validate_json(text).values] == ["a", ""]
    assert Value(name="a", value=1).model_copy(update={"n": 2}).n == 2


def test_a_format_writes_something(monkeypatch, tmp_path):
    monkeypatch.setattr(export.registry, "bringer", lambda package, name: MINE)
    with pytest.raises(BadInput, match=f"{TOLD}write gave an empty list; it is to give the paths"):
        export._written("mine", SimpleNamespace(write=lambda scene, folder: []), None, tmp_path)


@pytest.mark.parametrize("x, good", [((0.1, 0.2), True), ((0.2, 0.1), False), ((0.1, 0.1), False)])
@pytest.mark.parametrize("draw", [
    lambda body, x: body.box("chrome", x, (0, 0.1), (0, 0.1)), lambda body, x: body.block((0, 0.1), x, (0, 0.1)),
    lambda body, x: body.pillow("chrome", (0, 0.1), (0, 0.1), x),
    lambda body, x: body.rounded("chrome", x, (0, 0.1), (0, 0.1), 0.01)])
def test_what_is_drawn_has_an_extent(draw, x, good):
    with nullcontext() if good else pytest.raises(BadInput, match=rf"draws from [xyz] = {x[0]} to 0.1; give \(least"):
        draw(Body(), x)


def test_a_builder_that_draws_from_right_to_left_is_named(monkeypatch):
    monkeypatch.setattr(foreign.plugins, "bringer", lambda group, module: MINE)
    with pytest.raises(BadInput, match=f"{TOLD}desk/mine/1: draws from x = 0.3 to -0.3"):
        foreign.made(lambda kit: kit.base.box("oak", kit.x[::-1], kit.y, (0, kit.h)),
                     Kit("desk", "mine", (0.6, 1.2, 0.75), 0), "desk/mine/1")


@pytest.mark.parametrize("most, told", [
    (9.0, None), (TABLE["desk"].max[1], TABLE["desk"].max), (0.0, TABLE["desk"].size)])
def test_a_preview_tries_the_smallest_and_the_largest(monkeypatch, most, told):
    """Of desks that fail as soon as they have some width the first is told with its size, the usual one before all."""
    def builder(kit):
        kit.base.box("oak", kit.x, kit.y, (0.0, kit.h))
        assert kit.w < most, "too wide"

    kind, tried = TABLE["desk"], []
    monkeypatch.setattr(furniture, "_designs", lambda: {"desk": {"mine": builder}})
    monkeypatch.setattr(furniture, "build", lambda category, style, size, seed: tried.append(size) or foreign.made(
        builder, Kit(category, style, size, seed), f"{category}/{size}"))
    with pytest.raises(BadInput, match=re.escape(f"desk/{told}: ") + ".*too wide") if told else nullcontext():
        furniture.tried("desk", 3)
    assert told or (tried[0] == kind.size and set(tried[1:3]) == {kind.min, kind.max} and len(set(tried)) == 9)


def test_a_style_without_a_builder_is_told(monkeypatch, warned):
    """A module that enters none, but not one that has it from elsewhere in its package."""
    from apartgen.stages.retrieve.furniture import designs

    def builder(kit):
        pass

    builder.__module__ = "mine.shared"
    monkeypatch.setitem(designs.DESIGNS, "desk", {"mine": builder})
    found = {"empty": member(Kit=Kit), "mine": member(builder=builder)}
    monkeypatch.setattr(furniture.registry, "sound", lambda package: found)
    monkeypatch.setattr(furniture.registry, "bringer", lambda package, name: Plugin(name, f"mine.{name}", "my-home"))
    furniture._designs.__wrapped__()
    assert len(warned) == 1 and re.match("my-home: empty = 'mine.empty': enters no builder; put @design", warned[0])


def test_a_file_of_facts_that_there_is_not_is_named(monkeypatch, warned, tmp_path):
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine/__init__.py").write_text("")
    monkeypatch.syspath_prepend(str(tmp_path))
    own = {"mine": Plugin("mine", "mine:categoris.toml", "my-home")}
    monkeypatch.setattr(plugins, "brought", lambda group: own)
    assert list(plugins.facts("apartgen.categories")) == []
    assert warned == [own["mine"].told("there is no file categoris.toml beside mine/__init__.py; left out")]


def test_a_module_that_ends_the_program_is_left_out(monkeypatch, tmp_path):
    (tmp_path / "leaves.py").write_text('"""Leaves."""\nraise SystemExit(1)\n')
    monkeypatch.syspath_prepend(str(tmp_path))
    with pytest.raises(BadInput, match="^my-home: leaves = 'leaves': cannot be imported, SystemExit: 1"):
        registry._brought_in.__wrapped__(Plugin("leaves", "leaves", "my-home"), ())


def furnished(*names: str) -> room.Furnished:
    return room.Furnished(None, [Box(id=f"a_{k}", room="a", category=name, center=(0, 0, 0.5), size=(1, 1, 1), yaw=0)
                                 for k, name in enumerate(names)])


def test_a_room_is_asked_for_categories(newcomers):
    """What is like others counts as these; by its own name it is found alone, with what is like it."""
    there = furnished("piano", "desk", "flipper", "pinball")
    assert there.which("piano") == there.which(frozenset({"piano"})) == [0, 2, 3]
    assert there.which("pinball") == [2, 3] and there.which("flipper") == [2]
    assert there.which(frozenset({"flipper", "desk"})) == [1, 2] and there.which("sofa") == []
    assert there.number(["pinball", "desk"]) == 3
    for asked in ("piaon", frozenset({"desk", "piaon"})):
        with pytest.raises(ValueError, match="no category 'piaon'; did you mean 'piano'"):
            there.which(asked)


def test_floor_before_a_newcomer_is_kept_free(newcomers):
    """As much as its facts ask for: from its front on, .8 m, where nothing else stands and no wall is."""
    space = SimpleNamespace(known={}, doors=SimpleNamespace(n=0))
    elsewhere = np.array([[0.0, 0.0, 0.0, 1.2, 0.7, 0.0, 1.8]], np.float32)
    far = np.array([[away, 0.0, 0.0, 0.4, 0.6, 0.0, 0.8] for away in (0.9, 1.5, 1.7, -1.0)], np.float32)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(elbowroom, "ahead", lambda boxes, space: np.full(boxes.n, 9.0))
        patch.setattr(elbowroom, "outside", lambda boxes, space: np.zeros(boxes.n))
        for name, bad in (("pinball", [True, True, False, False]), ("piano", [False] * 4), ("flipper", [False] * 4)):
            space.known.clear()
            assert elbowroom.taken("dishwasher", far, [name], elsewhere, space).tolist() == bad, name
            apart = [elbowroom.taken(name, elsewhere, ["dishwasher"], one[None], space).tolist() for one in far]
            assert [found for (found,) in apart] == bad, name
