"""What other packages' functions give is looked at where it is used, and told with the package that it is from."""

import re
from contextlib import nullcontext
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType, SimpleNamespace

import pytest
import torch

from apartgen.schemas.errors import BadInput
from apartgen.schemas.metrics import Value
from apartgen.schemas.plugins import Plugin
from apartgen.stages import export, metrics
from apartgen.stages.layout import choice, guided
from apartgen.stages.registry import contract
from apartgen.stages.retrieve import furniture
from apartgen.stages.retrieve.furniture import foreign
from apartgen.stages.retrieve.furniture.body import Body
from apartgen.stages.retrieve.furniture.designs import design
from apartgen.stages.retrieve.furniture.kit import Kit
from apartgen.stages.retrieve.matching import newcomers
from apartgen.stages.space import sweeps
from apartgen.stages.things import categories
from apartgen.stages.things.categories import TABLE, read

PAGE = Path(__file__).parent.parent / "docs/extending.md"
MINE = Plugin("mine", "mine.module", "my-home")
ROOMS = SimpleNamespace(filled=torch.ones(2, 5), center=torch.ones(2, 5, 3, requires_grad=True))


@pytest.fixture
def energy(monkeypatch):
    """An energy that gives a value, as another package's."""
    monkeypatch.setattr(guided.registry, "bringer", lambda package, name: MINE)

    def giving(value):
        monkeypatch.setattr(guided.registry, "load", lambda package, name: SimpleNamespace(energy=lambda *_: value))
        return guided._energy.__wrapped__("mine")

    return giving


def test_an_energy_may_want_nothing(energy):
    """Then it needs no gradient; what is less below 0 than it is rounded by is none."""
    assert energy(torch.tensor([0.0, -1e-7]))(ROOMS, None).tolist() == pytest.approx([0.0, 0.0], abs=1e-6)
    assert energy(ROOMS.center.sum((1, 2)))(ROOMS, None).requires_grad


@pytest.mark.parametrize("value, fault", [
    (torch.tensor(3.0), r"energy gave shape \(\); there is to be one for each of 2 rooms, shape \(2,\)"),
    (torch.zeros(2, 5), r"energy gave shape \(2, 5\)"), (torch.tensor([0.0, torch.nan]), "energy gave no number"),
    (torch.tensor([-1.5, 2.0]), "energy gave -1.5; it is to be at least 0"),
    (torch.tensor([0.0, 2.0]), "energy gave 2 without a gradient")])
def test_an_energy_that_is_none_is_an_error(energy, value, fault):
    with pytest.raises(BadInput, match=f"^my-home: mine = 'mine.module': {fault}"):
        energy(value)(ROOMS, None)


@pytest.mark.parametrize("value", [-1.0, float("nan"), float("inf")])
def test_a_term_of_choice_is_at_least_0(monkeypatch, value):
    monkeypatch.setattr(choice.registry, "bringer", lambda package, name: MINE)
    term, room = ModuleType("term"), SimpleNamespace(site=SimpleNamespace(id="study_1"))
    vars(term)["cost"] = lambda room: value
    with pytest.raises(BadInput, match=rf"^my-home: mine = 'mine.module': cost gave {value:g} for study_1; "):
        choice._cost("mine", term, room)


def box(kit, out=0.0, material="oak"):
    kit.base.box(material, (kit.x[0], kit.x[1] + out), kit.y, (0.0, kit.h))


def drawer(kit, travel):
    box(kit)
    part = Body()
    part.box("oak", (kit.x[1] - 0.3, kit.x[1]), kit.y, (0.1, 0.2))
    kit.slide("drawer", part, travel)


def sinks(kit):
    kit.base.box("oak", kit.x, kit.y, (-0.02, kit.h))


@pytest.mark.parametrize("builder, fault", [
    (lambda kit: box(kit, 0.04), r"draws 40 mm outside its box at the front; the box is 0.6 x 1.2 x 0.75 m deep"),
    (sinks, "draws 20 mm outside its box below the floor"), (lambda kit: None, "draws nothing"),
    (lambda kit: box(kit, material="ook"), "no material 'ook'; did you mean 'oak'"),
    (lambda kit: drawer(kit, 0.7), "its part drawer_0 comes, when it opens, 250 mm outside its box at the front; .* "
                                   "may come out 0.45 m at the front"),
    (lambda kit: 1 / 0, "failed, ZeroDivisionError"), (lambda kit: box(kit, float("nan")), "draws where there are no"),
])
def test_a_builder_keeps_to_its_box(builder, fault, monkeypatch):
    monkeypatch.setattr(foreign.plugins, "bringer", lambda group, module: MINE)
    with pytest.raises(BadInput, match=rf"^my-home: mine = 'mine.module': desk/mine/1: {fault}"):
        foreign.made(builder, Kit("desk", "mine", (0.6, 1.2, 0.75), 0), "desk/mine/1")


def trolley(kit, top):
    """Four posts as high as the box, and a tray lower."""
    for x in kit.x:
        for y in kit.y:
            dx, dy = -0.04 if x > 0 else 0.04, -0.04 if y > 0 else 0.04
            kit.base.box("oak", tuple(sorted((x, x + dx))), tuple(sorted((y, y + dy))), (0.0, kit.h))
    kit.base.box("oak", kit.x, kit.y, (top - 0.02, top))


def test_what_things_stand_on_has_its_top_at_that_of_its_box(monkeypatch):
    """A lamp is put on a side table's box, and would stand within the box of one whose tray is lower."""
    monkeypatch.setattr(foreign.plugins, "bringer", lambda group, module: MINE)
    kit = lambda kind: Kit(kind, "mine", (0.5, 0.6, 0.55), 0)  # noqa: E731
    with pytest.raises(BadInput, match="has its top 100 mm below that of its box, where things stand"):
        foreign.made(lambda one: trolley(one, 0.45), kit("side_table"), "side_table/mine/1")
    assert foreign.made(lambda one: trolley(one, 0.54), kit("side_table"), "side_table/mine/1")
    assert foreign.made(lambda one: trolley(one, 0.45), kit("stool"), "stool/mine/1"), "nothing is put there"


@pytest.mark.parametrize("builder", [box, lambda kit: drawer(kit, 0.45), lambda kit: box(kit, 0.0009)])
def test_a_builder_that_does_makes_what_it_drew(builder):
    assert foreign.made(builder, Kit("desk", "mine", (0.6, 1.2, 0.75), 0), "desk/mine/1").id == "desk/mine/1"


def test_the_lid_of_the_page_opens_within_its_box():
    """The example, run as it stands: it opens 80° about the back, and at both ends a few millimetres are free."""
    (lid,) = re.findall(r"```python\n(lid = .*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)

    def chest(kit):
        kit.base.box("oak", kit.x, kit.y, (0.0, kit.h - 0.02))
        exec(lid, {"kit": kit, "Body": Body})

    made = foreign.made(chest, Kit("sideboard", "mine", (0.4, 1.2, 0.75), 0), "sideboard/mine/1")
    (joint,) = made.joints
    low, high = sweeps.swept(joint)
    assert joint.part == "hinge_lid", "it is called a lid wherever it is spoken of"
    assert joint.range == (0.0, 1.4) and high[2] > 0.75 / 2 + 0.3 and high[1] < 0.6 - 0.003 and low[0] > -0.2 - 0.011


def test_what_opens_otherwise_than_its_like_needs_a_builder(monkeypatch):
    rows = {"tested_lidded": {"like": "sideboard", "opens": "lid"}, "tested_open": {"like": "sideboard", "opens": ""}}
    monkeypatch.setattr(categories, "TABLE", TABLE | read(rows, TABLE))
    style, size = furniture.styles("sideboard")[0], TABLE["sideboard"].size
    with pytest.raises(BadInput, match="^tested_lidded: opens is 'lid' and nothing here builds one; as a sideboard"):
        furniture.build("tested_lidded", style, size)
    for name, parts in (("sideboard", True), ("tested_open", False)):
        assert any(joint.range[1] > 0 for joint in furniture.build(name, style, size).joints) == parts


def test_of_several_styles_those_that_can_be_made_are_taken(monkeypatch):
    """Told are all that cannot."""
    def encoded(maker, category, styles):
        if wrong := [style for style in styles if style.startswith("bad")]:
            raise BadInput(wrong[0])
        return styles

    monkeypatch.setattr(newcomers, "encoded", encoded)
    found, wrong = newcomers.sound(None, "desk", ["a", "bad b", "c", "bad d"])
    assert found == [["a"], ["c"]] and [str(error) for error in wrong] == ["bad b", "bad d"]
    assert newcomers.sound(None, "desk", ["a", "c"]) == ([["a", "c"]], [])


def test_a_module_is_known_for_its_package(monkeypatch):
    from apartgen.schemas import plugins

    own = {name: Plugin(name, f"mine.{name}", "my-home") for name in ("desks", "chairs")}
    monkeypatch.setattr(plugins, "brought", lambda group: own)
    found = [plugins.bringer("apartgen.furniture", module) for module in ("mine.chairs", "mine.chairs.legs",
                                                                          "mine.other", "minecraft")]
    assert found == [own["chairs"], own["chairs"], own["desks"], None]
    assert re.match("my-home: chairs", own["chairs"].told("x"))


def test_what_is_written_is_there(monkeypatch, tmp_path):
    """A file that a format names lies below the folder that it was given."""
    (tmp_path / "in").mkdir()
    (tmp_path / "beside.txt").write_text("")
    (tmp_path / "in/good.txt").write_text("")
    monkeypatch.setattr(export.registry, "bringer", lambda package, name: MINE)
    for path, good in ((tmp_path / "in/good.txt", True), (tmp_path / "beside.txt", False), (tmp_path / "in/no", False)):
        writer = SimpleNamespace(write=lambda scene, folder, path=path: [path])
        with nullcontext() if good else pytest.raises(BadInput, match=f"^my-home: .* names {path.name}, "):
            assert export._written("mine", writer, None, tmp_path / "in") == [path]


def test_a_figure_is_of_a_room_or_of_all(monkeypatch):
    home = SimpleNamespace(rooms=[SimpleNamespace(id="study_1")])
    monkeypatch.setattr(metrics.registry, "bringer", lambda package, name: MINE)
    for of, good in (("study_1", True), ("apartment", True), ("study", False)):
        found = [Value(name="seats", value=1, of=of)]
        monkeypatch.setattr(metrics, "_member", lambda name, found=found: SimpleNamespace(measure=lambda *_: found))
        with nullcontext() if good else pytest.raises(BadInput, match="^my-home: .* a value of 'study'; of is"):
            assert metrics._measure("seats", home, None) == found


@pytest.mark.parametrize("given, said", [
    (Path("x"), "gave a PosixPath, not a list of Path"), (None, "gave nothing, not a list of Path"),
    (["x"], "gave a list with a str, not of Path"), ([], "gave an empty list")])
def test_a_format_of_a_checkout_is_named_with_what_it_is_to_give(given, said, tmp_path):
    writer = SimpleNamespace(write=lambda scene, folder: given)
    with pytest.raises(BadInput, match=rf"^format mine: write {said}; it is to give the paths of the files [^\n]*$"):
        export._written("mine", writer, None, tmp_path)


VALUE = Value(name="seats", value=1, of="apartment")


@pytest.mark.parametrize("given, said", [
    (VALUE, "gave a Value, not a list of Value"), (None, "gave nothing, not a list of Value"),
    ([VALUE, 3], "gave a list with a int, not of Value"),
    ([VALUE.model_copy(update={"of": "attic"})], "gave a value of 'attic'; of is one of apartment, study_1"),
    ([VALUE.model_copy(update={"name": ""})], "gave a value without a name; give it one, by which it is written")])
def test_a_metric_of_a_checkout_is_named_with_what_it_is_to_give(given, said, monkeypatch):
    home = SimpleNamespace(rooms=[SimpleNamespace(id="study_1")])
    monkeypatch.setattr(metrics, "_member", lambda name: SimpleNamespace(measure=lambda *_: given))
    with pytest.raises(BadInput, match=rf"^metric seats: measure {said}$"):
        metrics._measure("seats", home, None)


def test_what_compares_sets_gives_a_list_too(monkeypatch):
    monkeypatch.setattr(metrics, "_member", lambda name: SimpleNamespace(compare=lambda *_: VALUE))
    with pytest.raises(BadInput, match="^metric seats: compare gave a Value, not a list of Value$"):
        metrics.compare([None], [None], ["seats"])


@pytest.mark.parametrize("names", [(len,), ("desk",), ("desk", 3)])
def test_a_builder_is_entered_by_names(names):
    with pytest.raises(BadInput, match="a builder is entered by @design"):
        design(*names)


def test_a_fault_is_told_with_the_line_of_the_package(tmp_path):
    """Not with one of ours that it called; a type's complaint in plain words."""
    file = tmp_path / "mine.py"
    file.write_text("from apartgen.schemas.metrics import Value\n\n\ndef measure(home, against):\n    return [\n"
                    "        Value(name='a', value='many')]\n")
    spec = spec_from_file_location("mine", file)
    member = module_from_spec(spec)
    spec.loader.exec_module(member)
    with pytest.raises(BadInput, match=rf"^measure failed, Value.value: 'many' is no number \({file}:6\)$"):
        contract.guarded(member, contract.protocols("apartgen.stages.metrics")[:1], str).measure(None, None)
