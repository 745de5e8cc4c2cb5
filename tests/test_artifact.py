"""Artifacts keep what they hold, are written whole or not at all, and nothing hostile gets past the reader."""

import copy
import json
import os
import random
import re
import stat

import handmade
import jsonschema
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from apartgen.schemas import artifact, consistency, migrations
from apartgen.schemas.artifact import (
    BODIES,
    Made,
    as_line,
    finish,
    json_schema,
    line_of,
    parse,
    read,
    settled,
    write,
)
from apartgen.schemas.errors import BadInput
from apartgen.schemas.export import Export, File
from apartgen.schemas.layout import Layout
from apartgen.schemas.metrics import Metrics, Value
from apartgen.schemas.plan import Plan
from apartgen.schemas.populate import Populate, Receptacle, Thing, without_things
from apartgen.schemas.render import Instance, Render
from apartgen.schemas.retrieve import Joint, Retrieve
from apartgen.schemas.walkable import Replaced, Report, Walkable

MADE = Made(by="apartgen 0.1.0", seed=7, config={"steps": 20}, inputs={"plan": "sha256:00"}, seconds=0.41)

THING = Thing.model_validate({
    "id": "mug_1", "stage": "populate", "room": handmade.LIVING, "category": "mug", "center": (1, 2, 0.9),
    "size": (0.12, 0.08, 0.09), "yaw": 0.5, "on": "floor", "in": {"object": "sofa_1", "receptacle": "top_0"},
    "asset": {"library": "parametric", "id": "mug/straight/120x80x90/1"},
    "grasps": [{"at": (0, 0, 0), "approach": (0, 0, -1), "close": (0, 1, 0), "width": 0.08}]})


def walkable() -> Walkable:
    hinge = Joint(name="door", type="hinge", axis=(0, 0, 1), origin=(0.3, 0.5, 0), range=(0, 1.57), part="hinge_door",
                  extent=((0.28, -0.5, -1), (0.3, 0.5, 1)))
    things = [handmade.thing("wardrobe", 5.5, 2.6, -1.57, handmade.BEDROOM, joints=(hinge,)),
              handmade.thing("sofa", 1, 2)]
    report = Report(target=0.7, before=0.6, after=0.8, rooms={"bedroom_1": 0.8},
                    replaced=[Replaced.model_validate({"object": things[0].id, "from": "a", "to": None})])
    return Walkable(**handmade.plan().model_dump(), objects=things, walkable=report)


def populated(home: Walkable) -> Populate:
    place = Receptacle(name="top_0", kind="top", polygon=[(0, 0), (1, 0), (1, 1)], z=0.2, clearance=3.0)
    fields = {name: getattr(home, name) for name in Walkable.model_fields}
    return Populate(**fields | {"objects": [*home.objects, THING]}, receptacles={"sofa_1": [place]},
                    states={"lamp_1": {"on": True}})


def every() -> dict[str, object]:
    home = walkable()
    return {
        "plan": handmade.plan(), "walkable": home,
        "layout": Layout.model_validate(home.model_dump(by_alias=True)),
        "retrieve": Retrieve.model_validate(home.model_dump(by_alias=True)),
        "export": Export(files=[File(path="a/b.glb", format="glb", sha256="0" * 64)]),
        "render": Render(labels={"wall": 1}, instances=[Instance(number=1, id="walls", category="wall", label=1)]),
        "populate": populated(home),
        "metrics": Metrics(values=[Value(name="R_acoll", value=None), Value(name="R_out", value=0.5, of="bedroom_1")]),
    }


TEXT, _ = finish(walkable(), MADE)
RAW = json.loads(TEXT)


def changed(edit) -> bytes:
    raw = copy.deepcopy(RAW)
    edit(raw)
    return json.dumps(raw).encode()


@pytest.mark.parametrize("kind", BODIES)
def test_what_is_written_is_read_back(kind):
    body = every()[kind]
    text, settled = finish(body, MADE)
    again = parse(text.encode(), "file", BODIES[kind])
    assert again == settled and again.kind == kind and again.made == MADE
    assert again.body.model_dump() == body.model_dump()
    assert finish(again.body, MADE)[0] == text


@pytest.mark.parametrize("kind", BODIES)
def test_the_schema_describes_what_is_written(kind):
    schema = json_schema(kind)
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.validate(json.loads(finish(every()[kind], MADE)[0]), schema)


def test_a_later_kind_is_read_where_an_earlier_is_asked_for():
    as_plan = parse(TEXT.encode(), "file", Plan)
    assert type(as_plan.body) is Plan and as_plan.kind == "walkable" and as_plan.body == handmade.plan()
    assert type(parse(TEXT.encode(), "file", Plan, whole=True).body) is Walkable


def test_numbers_are_rounded_once_and_for_all():
    plan = handmade.plan()
    plan.rooms[0].polygon = [(-0.0000001, 0.0), (4.00000049, 0.0), (4.0, 3.0), (0.0, 3.0)]
    text, settled = finish(plan, MADE)
    assert settled.body.rooms[0].polygon[:2] == [(0.0, 0.0), (4.0, 0.0)] and "-0.0," not in text
    assert finish(settled.body, MADE)[0] == text


def test_the_digest_leaves_out_the_seconds_and_nothing_else():
    digest = parse(TEXT.encode(), "file", Plan).digest
    slow = changed(lambda raw: raw["made"].update(seconds=9.9))
    other = changed(lambda raw: raw["made"].update(seed=8))
    more = changed(lambda raw: raw["body"].update(note="new field"))
    assert parse(slow, "file", Plan).digest == digest
    assert len({digest, parse(other, "file", Plan).digest, parse(more, "file", Plan).digest}) == 3


def room(index, **fields):
    return lambda raw: raw["body"]["rooms"][index].update(fields)


HOSTILE = {
    "not utf-8": (b"\xff\xfe\x00", "not UTF-8"),
    "empty": (b" \n", "empty"),
    "cut off": (TEXT.encode()[:700], "cut off"),
    "cut inside a word": (b'{"apartgen": "plan", "version": tr', "not JSON"),
    "a list": (b"[]", "not an apartgen artifact"),
    "other JSON": (b"{}", "not an apartgen artifact"),
    "nested": (b"[" * 100_000, "nested too deeply"),
    "not a number": (TEXT.replace('"seed": 7', '"seed": NaN').encode(), "NaN is not a number"),
    "infinite": (TEXT.replace("2.6", "1e999").encode(), r"body\.height"),
    "endless integer": (b'{"apartgen": ' + b"9" * 5000 + b"}", "not JSON"),
    "lone surrogate": (changed(lambda raw: raw["body"].update(prompt="\ud800")), "not UTF-8"),
    "unknown kind": (changed(lambda raw: raw.update(apartgen="palace")), "unknown kind 'palace'"),
    "kind of another type": (changed(lambda raw: raw.update(apartgen={"a": 1})), "unknown kind"),
    "too new": (changed(lambda raw: raw.update(version=99)), "version 99 is newer than version 2"),
    "no version": (changed(lambda raw: raw.pop("version")), "version: a whole number"),
    "true version": (changed(lambda raw: raw.update(version=True)), "version: a whole number"),
    "no body": (changed(lambda raw: raw.pop("body")), "body: field required"),
    "no made": (changed(lambda raw: raw.pop("made")), "made: field required"),
    "number as text": (changed(lambda raw: raw["body"].update(height="2.6")), r"body\.height"),
    "room type": (changed(room(1, type="dungeon")), r"body\.rooms\[1\]\.type"),
    "two corners": (changed(room(0, polygon=[[0, 0], [1, 0]])), r"body\.rooms\[0\]\.polygon"),
    "clockwise": (changed(room(0, polygon=[[0, 0], [0, 3], [4, 3], [4, 0]])), r"rooms\[0\]\.polygon: runs clockwise"),
    "crossing": (changed(room(0, polygon=[[0, 0], [4, 3], [4, 0], [0, 3]])), r"rooms\[0\]\.polygon: crosses"),
    "repeated first": (changed(room(0, polygon=[[0, 0], [4, 0], [4, 3], [0, 0]])), "first not repeated"),
    "no area": (changed(room(0, polygon=[[0, 0], [1, 0], [2, 0]])), r"rooms\[0\]\.polygon"),
    "millimetres": (changed(room(0, polygon=[[0, 0], [4000, 0], [4000, 3000]])), "coordinates are metres"),
    "room twice": (changed(room(1, id="living_room_1", type="living_room")), "there twice"),
    "room not asked for": (changed(room(1, id="bedroom_9")), "not among program.rooms"),
    "door to nowhere": (changed(lambda raw: raw["body"]["openings"][1].update(rooms=["bedroom_1", "attic_1"])),
                        r"openings\[1\]\.rooms\[1\]: there is no room 'attic_1'"),
    "door into one room": (changed(lambda raw: raw["body"]["openings"][1].update(rooms=["bedroom_1"])), "needs 2"),
    "object nowhere": (changed(lambda raw: raw["body"]["objects"][1].update(room="attic_1")), r"objects\[1\]\.room"),
    "flat object": (changed(lambda raw: raw["body"]["objects"][1].update(size=[1, 0, 1])), r"objects\[1\]\.size\[1\]"),
    "backward joint": (changed(lambda raw: raw["body"]["objects"][0]["joints"][0].update(range=[1, 0])),
                       r"objects\[0\]\.joints\[0\]\.range"),
    "no axis": (changed(lambda raw: raw["body"]["objects"][0]["joints"][0].update(axis=[0, 0, 0])), "no direction"),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_bad_files_are_refused_in_a_line_that_names_file_and_place(name):
    data, message = HOSTILE[name]
    with pytest.raises(BadInput, match=message) as caught:
        parse(data, "home.json", Walkable)
    assert str(caught.value).startswith("home.json: ") and "\n" not in str(caught.value)
    assert len(str(caught.value)) < 400


def paths(value, path=()):
    yield path
    children = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, child in children:
        yield from paths(child, (*path, key))


PATHS = [path for path in paths(RAW) if path]
JUNK = st.one_of(
    st.none(), st.booleans(), st.integers(), st.floats(), st.text(max_size=8), st.just([]), st.just({}),
    st.just([[0, 0]]), st.just({"id": 1}), st.integers(-(10**400), 10**400),
)


@given(st.sampled_from(PATHS), JUNK)
@settings(max_examples=300, deadline=None, suppress_health_check=list(HealthCheck))
def test_any_changed_value_is_read_or_refused(path, junk):
    raw = copy.deepcopy(RAW)
    place = raw
    for key in path[:-1]:
        place = place[key]
    place[path[-1]] = junk
    try:
        text = json.dumps(raw)
    except (ValueError, RecursionError):
        return
    try:
        parse(text.encode("utf-8", "surrogatepass"), "file", Walkable)
    except BadInput as error:
        assert str(error).count("\n") <= 1


def test_a_populated_home_read_as_an_earlier_kind_is_its_furniture():
    text, _ = finish(populated(walkable()), MADE)
    for kind in (Retrieve, Layout):
        assert [o.id for o in parse(text.encode(), "file", kind).body.objects] == [o.id for o in walkable().objects]
    whole = parse(text.encode(), "file", Plan, whole=True).body
    assert isinstance(whole, Populate) and whole.objects[-1] == THING
    assert without_things(whole) == parse(finish(walkable(), MADE)[0].encode(), "file", Walkable).body


def test_of_two_kinds_the_wrong_one_is_named():
    text, _ = finish(handmade.plan(), MADE)
    with pytest.raises(BadInput, match="a plan artifact where layout or retrieve or walkable or populate is needed"):
        parse(text.encode(), "file", Layout)


def test_what_a_stage_makes_inconsistent_is_not_written():
    plan = handmade.plan()
    plan.openings[0].rooms = ["attic_1"]
    with pytest.raises(RuntimeError, match="inconsistent"):
        finish(plan, MADE)


def test_old_versions_migrate_in_order():
    steps = (lambda raw: raw | {"trail": ["one"]}, lambda raw: raw | {"trail": [*raw["trail"], "two"]})
    assert migrations.migrate({"version": 1}, "file", steps) == {"version": 3, "trail": ["one", "two"]}
    assert migrations.migrate({"version": 3}, "file", steps) == {"version": 3}
    with pytest.raises(BadInput, match="version 4 is newer than version 3"):
        migrations.migrate({"version": 4}, "file", steps)


def test_a_file_is_replaced_whole_and_keeps_its_mode(tmp_path):
    file = tmp_path / "plan.json"
    write("old\n", file)
    file.chmod(0o640)
    write("new\n", file)
    assert file.read_text() == "new\n" and stat.S_IMODE(file.stat().st_mode) == 0o640
    assert os.listdir(tmp_path) == ["plan.json"]


def test_a_failed_write_leaves_the_old_file_and_no_litter(tmp_path, monkeypatch):
    file = tmp_path / "plan.json"
    write("old\n", file)

    def full(handle):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(BadInput, match="No space left"):
        write("new\n", file)
    assert file.read_text() == "old\n" and os.listdir(tmp_path) == ["plan.json"]


def test_a_link_is_written_through_and_a_device_is_not_replaced(tmp_path):
    file, link = tmp_path / "plan.json", tmp_path / "link.json"
    write("old\n", file)
    link.symlink_to(file)
    write("new\n", link)
    assert link.is_symlink() and file.read_text() == "new\n"
    write("gone\n", os.devnull)
    assert stat.S_ISCHR(os.stat(os.devnull).st_mode)


def test_a_new_file_is_for_those_whom_the_mask_lets(tmp_path):
    before = os.umask(0o027)
    try:
        write("new\n", tmp_path / "plan.json")
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "plan.json").stat().st_mode) == 0o640


def test_unreadable_sources_are_bad_input(tmp_path):
    for source in (tmp_path, tmp_path / "missing.json", "plan\0.json"):
        with pytest.raises(BadInput, match="cannot be read"):
            read(source, Plan)


def test_long_files_are_refused_without_reading_on(tmp_path, monkeypatch):
    monkeypatch.setattr(artifact, "LARGEST", 1000)
    file = tmp_path / "plan.json"
    file.write_text(" " * 5000)
    with pytest.raises(BadInput, match="larger than"):
        read(file, Plan)


def test_the_order_of_keys_in_a_file_does_not_matter():
    shuffled = list(RAW.items())
    random.Random(3).shuffle(shuffled)
    data = json.dumps(dict(shuffled)).encode()
    assert parse(data, "file", Walkable) == parse(TEXT.encode(), "file", Walkable)


@pytest.mark.parametrize("wrong", [1, 2, 3])
def test_the_first_complaint_is_told_and_how_many_more_there_are(wrong):
    def edit(raw):
        for k in range(wrong):
            raw["body"]["rooms"][k % 2]["type" if k < 2 else "id"] = 7

    with pytest.raises(BadInput) as told:
        parse(changed(edit), "file", Walkable)
    assert ("more)" in str(told.value)) == (wrong > 1)
    assert wrong == 1 or f"(and {wrong - 1} more)" in str(told.value)


@pytest.mark.parametrize("kind, rooms, words", [
    ("window", ["living_room_1", "bedroom_1"], "needs 1 different room$"),
    ("door", ["bedroom_1"], "2 different rooms$"),
    ("entrance", ["living_room_1", "bedroom_1"], "needs 1 different room$"),
    ("opening", ["bedroom_1", "bedroom_1"], "2 different rooms$")])
def test_openings_are_between_as_many_rooms_as_their_kind_says(kind, rooms, words):
    plan = handmade.plan()
    way = plan.openings[1].model_copy(update={"kind": kind, "rooms": rooms, "into": rooms[0]})
    (fault,) = consistency.faults(plan.model_copy(update={"openings": [plan.openings[0], way, plan.openings[2]]}))
    assert fault.where == "openings[1].rooms" and re.search(words, fault.what)


def test_what_stands_on_itself_is_told_where_it_is_said():
    lamp, table = handmade.thing("table_lamp", 1, 1, id="a"), handmade.thing("side_table", 1, 1, id="b")
    home = handmade.home(lamp.model_copy(update={"on": "b"}), table.model_copy(update={"on": "a"}))
    assert [(fault.where, fault.what) for fault in consistency.faults(home)] == [
        ("objects[0].on", "'a' would stand on itself by way of 'b'"),
        ("objects[1].on", "'b' would stand on itself by way of 'a'")]


@pytest.mark.parametrize("short, proper", [(0.0012, True), (0.0008, False)])
def test_corners_less_than_a_millimetre_apart_are_one(short, proper):
    """A corner cut off by so much; a coarser program's outlines are taken as they are."""
    home = handmade.home()
    ring = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (short, 3.0), (0.0, 3.0)]
    room = home.rooms[0].model_copy(update={"polygon": ring})
    told = [fault.what for fault in consistency.faults(home.model_copy(update={"rooms": [room, *home.rooms[1:]]}))
            if fault.where == "rooms[0].polygon"]
    assert (not told) == proper and all("coincide" in what for what in told)


@pytest.mark.parametrize("x, y, words", [
    (consistency.FARTHEST + 1, 0, "from the origin"), (0, -consistency.FARTHEST - 1, "from the origin"),
    (-consistency.FARTHEST - 1, 1, "from the origin"), (consistency.WIDEST + 1, 0, "m wide"),
    (0, consistency.WIDEST + 1, "m wide"), (consistency.WIDEST - 1, consistency.WIDEST - 1, "")])
def test_homes_are_neither_far_away_nor_wide_along_either_axis(x, y, words):
    told = consistency.too_wide([(0.0, 0.0), (x, y), (1.0, 1.0)])
    assert words in told and bool(told) == bool(words)


def test_an_artifact_without_its_text_is_the_one_with_it():
    """To six digits, no zero negative; on one line the same as on many."""
    made = Made(by="test", seed=1, config={"at": [1 / 3, -1e-9, 2.0, 7, True, None, "0.1234567890"],
                                           "": {"x": [[1e22]]}})
    text, there = finish(walkable(), made)
    assert settled(walkable(), made) == there
    line = line_of(walkable(), made)
    assert line == as_line(text) and line.count("\n") == 1
    at = json.loads(line)["made"]["config"]["at"]
    assert at == [0.333333, 0, 2.0, 7, True, None, "0.1234567890"] and "-0.0" not in line
    assert there.digest == parse(text.encode(), "file", Walkable).digest
