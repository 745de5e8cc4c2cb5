"""`apartgen metrics` over sets of apartments: tables, and comparisons with real ones."""

import hashlib
import json

import commandline
import handmade as h
import pytest

from apartgen.schemas import artifact
from apartgen.schemas.artifact import Made
from apartgen.schemas.metrics import Metrics


@pytest.fixture
def cli(capsys, monkeypatch):
    return lambda *args: commandline.run(capsys, monkeypatch, "metrics", *args)


@pytest.fixture
def scenes(tmp_path):
    """Two homes, and a folder of two real ones."""
    sofa, stand, wardrobe = h.thing("sofa", 1, 1), h.thing("tv_stand", 3, 2), h.thing("wardrobe", 6, 1, room=h.BEDROOM)
    homes = {"one": [sofa], "two": [sofa, stand], "real/a": [sofa, stand, wardrobe], "real/b": [sofa, stand]}
    (tmp_path / "real").mkdir()
    for name, things in homes.items():
        text, _ = artifact.finish(h.home(*things), Made(by="test", seed=5))
        (tmp_path / f"{name}.json").write_text(text)
    return tmp_path


def cells(text: str, figure: str, of: str = "apartment") -> list[str]:
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in text.splitlines()]
    return next(row for row in rows if row[0] == figure and of in row)


def test_a_table_has_means_and_intervals_over_all_inputs(cli, scenes):
    args = (scenes / "one.json", scenes / "two.json", "--table", "--metric", "relations")
    done = cli(*args)
    assert done.code == 0
    # 1 and 2 objects in two rooms: 0.5 and 1 a room.
    assert cells(done.out, "objects_a_room") == [
        "objects_a_room", "ours", "apartment", "0.750", "0.500 - 1.000", "2"]
    assert cli(*args).out == done.out
    cli(*args, "-o", scenes / "table.md")
    assert (scenes / "table.md").read_text() == done.out


def test_a_bad_input_leaves_the_table_to_the_others_and_shows_in_the_status(cli, scenes):
    (scenes / "bad.json").write_text("{}")
    done = cli(scenes / "bad.json", scenes / "two.json", "--table", "--metric", "relations")
    assert done.code == 2 and "bad.json" in done.err and "1 of 2" in done.err
    assert cells(done.out, "objects_a_room")[-1] == "1"


def test_sets_are_compared_with_the_real_ones_of_a_folder(cli, scenes):
    done = cli(scenes / "one.json", scenes / "two.json", "--real", scenes / "real")
    read = artifact.parse(done.out.encode(), "out", Metrics)
    found = {(v.name, v.version, v.of): v.value for v in read.body.values}
    assert found["objects_a_room", "real", "bedroom"] == 0.5 and found["objects_a_room", "generated", "bedroom"] == 0
    assert found["CKL", "published", "apartment"] > 0
    assert list(read.made.inputs) == ["generated 1", "generated 2", "real 1", "real 2"]
    table = cli(scenes / "one.json", "--real", scenes / "real/a.json", "--real", scenes / "real/b.json", "--table").out
    found = cells(table, "objects_a_room", "living_room")
    assert found[2:4] == ["1.000 (1)", "2.000 [2.000, 2.000] (2)"]


def test_a_set_compared_with_itself_does_not_differ(cli, scenes):
    both = sorted((scenes / "real").iterdir())
    values = json.loads(cli(*both, "--real", scenes / "real", "--metric", "frequencies").out)["body"]["values"]
    ckl = [v["value"] for v in values if v["name"] == "CKL"]
    assert ckl and all(value is None or abs(value) < 1e-9 for value in ckl)
    both = {(v["name"], v["of"]): {} for v in values if v["name"].startswith("frequency/")}
    for v in values:
        both.get((v["name"], v["of"]), {})[v["version"]] = v["value"], v["low"], v["high"]
    assert both["frequency/wardrobe", "bedroom"]["real"][0] == 0.5
    assert all(found["generated"] == found["real"] for found in both.values())


def test_what_cannot_be_compared_is_refused(cli, scenes):
    one, real = scenes / "one.json", scenes / "real"
    (scenes / "empty").mkdir()
    plan = scenes / "plan.json"
    plan.write_text(artifact.finish(h.plan(), Made(by="test", seed=5))[0])
    for args, said in [
        ([one, "--real", scenes / "empty"], "no .json file"),
        ([one, "--real", scenes / "none.json"], "none.json"),
        ([one, "--real", real, "--against", one], "one of the two"),
        ([plan, "--real", real], "plan artifact where layout"),
        ([one, "--real", real, "--metric", "graph"], "does not compare"),
        ([one, "--table", "-o", f"{scenes}/"], "table.md"),
    ]:
        done = cli(*args)
        assert done.code == 2 and said in done.err and done.out == "", (args, done)


def test_figures_of_single_rooms_stand_beside_those_of_real_ones(cli, scenes):
    sofa = h.thing("sofa", 1, 1)
    doubled, _ = artifact.finish(h.home(sofa, h.thing("armchair", 1, 1)), Made(by="test", seed=5))
    (scenes / "crossed.json").write_text(doubled)
    args = (scenes / "one.json", scenes / "crossed.json", "--real", scenes / "real", "--metric", "collision")
    table = cli(*args, "--table").out
    # One of three sofas and armchairs' scenes: 2 of 3 objects collide, none of the real ones.
    assert cells(table, "Col_obj/ours")[2:4] == ["0.667 [0.000, 1.000] (2)", "0.000 [0.000, 0.000] (3)"]
    assert cells(table, "Col_scene/ours")[2].startswith("0.500 [") and "seed 0" in table and "bootstrap" in table


def room(type, desc, x):
    """A 4 x 4 m room of a foreign data set with one thing in it."""
    corners = [[0, 0, 0], [4, 0, 0], [4, 0, 4], [0, 0, 4]]
    thing = {"desc": desc, "pos": [x, 0, 2], "rot": [0, 0, 0, 1], "size": [1.0, 0.8, 0.5]}
    return {"scene": {"room_type": type, "bounds_bottom": corners, "bounds_top": [[x, 2.6, z] for x, _, z in corners],
                      "objects": [thing]}}


def test_real_rooms_in_their_own_format(cli, scenes):
    rows = [room("bedroom", "double bed", 1), room("bedroom", "wardrobe", 2)]
    (scenes / "rooms.jsonl").write_text("\n".join(map(json.dumps, rows)))
    done = cli(scenes / "one.json", "--real", scenes / "rooms.jsonl", "--as", "ssr", "--metric", "relations")
    read = artifact.parse(done.out.encode(), "out", Metrics)
    found = {(v.name, v.version, v.of): v for v in read.body.values}
    assert found["objects_a_room", "real", "bedroom"].value == 1 and ("objects_a_room", "real", "study") not in found
    assert list(read.made.inputs) == ["real 1", "generated 1"] and read.made.config["real_as"] == "ssr"
    for args, said in [
        (["--real", scenes / "rooms.jsonl", "--as", "single_rooms"], "makes its rooms up"),
        (["--real", scenes / "rooms.jsonl", "--as", "sr"], "there are"),
        (["--real", scenes / "none.jsonl", "--as", "ssr"], "does not exist"),
        (["--as", "ssr"], "only with --real"),
        (["--inception-weights", "w.pt"], "only with --real"),
        (["--real", scenes / "real", "--metric", "fid", "--inception-weights", "w.pt"], "no such file"),
    ]:
        done = cli(scenes / "one.json", *args)
        assert done.code == 2 and said in done.err and done.out == "", (args, done)


def asked(kitchen, area):
    """A programme of the flat, with a kitchen or without, as people write it."""
    rooms = [{"id": "living_room_1", "type": "living_room", "area": 12.0}, {"id": "bedroom_1", "type": "bedroom"}]
    more = [{"id": "kitchen_1", "type": "kitchen", "area": area}] if kitchen else []
    return {"rooms": rooms + more, "links": [["living_room_1", room["id"]] for room in (rooms + more)[1:]]}


def test_a_programme_as_people_write_it_is_a_reference(cli, scenes):
    file = scenes / "programme.json"
    file.write_text(json.dumps(asked(kitchen=True, area=6.0)))
    read = artifact.parse(cli(scenes / "one.json", "--against", file, "--metric", "graph").out.encode(), "out", Metrics)
    # Of three rooms and two links there are two and one; the bedroom's area is left open.
    assert {v.name: v.value for v in read.body.values} == {
        "S_node": pytest.approx(2 / 3, abs=1e-6), "S_constraint": None, "S_edge": 0.5}
    assert read.made.inputs["against"] == "sha256:" + hashlib.sha256(file.read_bytes()).hexdigest()
    of_plan = cli(scenes / "one.json", "--against", scenes / "two.json", "--metric", "graph").out
    assert [v.value for v in artifact.parse(of_plan.encode(), "out", Metrics).body.values] == [1, 1, 1]


def test_references_that_are_none(cli, scenes):
    file = scenes / "programme.json"
    drawn = {"rooms": [{"id": "a", "type": "bedroom", "polygon": [[0, 0], [3, 0], [3, 3], [0, 3]]}]}
    lost = asked(kitchen=False, area=6.0) | {"links": [["living_room_1", "attic_1"]]}
    for content, said in [(drawn, "apartgen plan --from"), (lost, "no room 'attic_1'"), ({"rooms": []}, "rooms"),
                          ([], "programme")]:
        file.write_text(json.dumps(content))
        done = cli(scenes / "one.json", "--against", file)
        assert done.code == 2 and said in done.err and done.out == "", (content, done)
