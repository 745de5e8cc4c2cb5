"""Episodes of navigation by words: ways are free, lengths true, words about what is there, turns to the right side."""

import gzip
import json
import re
from itertools import pairwise

import handmade
import networkx
import numpy as np
import pytest
from export import sample
from scipy.spatial.transform import Rotation
from shapely.geometry import LineString, Polygon
from shapely.ops import unary_union

from apartgen.schemas.errors import BadInput
from apartgen.stages import export
from apartgen.stages.export import _legs, _told_ways, vln
from apartgen.stages.robot import reach
from apartgen.stages.space import polygons
from apartgen.stages.things.categories import TABLE

CELL = 0.036
"""Half of a cell's diagonal: between two cells a way may come so much nearer to something."""
WALL = 0.1
NAMES = "|".join(sorted({kind.called for kind in TABLE.values()}, key=len, reverse=True))


def read(home, load, out):
    export.run(home, ["vln"], out, load)
    return json.loads(gzip.decompress((out / vln.FILE).read_bytes()))


@pytest.fixture(scope="module")
def home():
    return sample.home()


@pytest.fixture(scope="module")
def held(home, tmp_path_factory):
    return read(home, sample.load, tmp_path_factory.mktemp("vln") / "scene")


@pytest.fixture(scope="module")
def episodes(held):
    return held["episodes"]


def ground(points):
    """Points of Habitat on the floor of the world: its x, and its z turned round."""
    return np.array([[x, -z] for x, _, z in points])


def free(home):
    """Floor that nothing stands on, from the artifact's corners and boxes, and doors open."""
    floors = [Polygon(room.polygon) for room in home.rooms]
    holes = [LineString(o.segment).buffer(WALL, cap_style="flat") for o in home.openings if len(o.rooms) == 2]
    things = [polygons.leaf(o, home).buffer(reach.LEVER) for o in home.openings if o.kind == "door"]
    for o in home.objects:
        low, high = o.center[2] - o.size[2] / 2, o.center[2] + o.size[2] / 2
        if low < 1.5 and high > 0.03 and o.category != "rug":
            c, s, (x, y, _), (d, w, _) = np.cos(o.yaw), np.sin(o.yaw), o.center, o.size
            things.append(Polygon([(x + c * a * d / 2 - s * b * w / 2, y + s * a * d / 2 + c * b * w / 2)
                                   for a, b in ((1, 1), (-1, 1), (-1, -1), (1, -1))]))
    return unary_union([*floors, *holes]).difference(unary_union(things))


def test_every_episode_has_what_habitat_reads(held, home):
    names = {"episode_id", "trajectory_id", "scene_id", "scene_dataset_config", "start_position", "start_rotation",
             "goals", "reference_path", "instruction", "info"}
    episodes = held["episodes"]
    assert len(episodes) >= 12 and [e["episode_id"] for e in episodes] == list(range(len(episodes)))
    for e in episodes:
        assert set(e) == names and set(e["instruction"]) == {"instruction_text", "instruction_tokens"}
        assert e["start_position"] == e["reference_path"][0] and e["goals"][0]["position"] == e["reference_path"][-1]
        assert all(len(p) == 3 and p[1] == 0 for p in e["reference_path"])
    told = {}
    for e in episodes:
        told.setdefault(e["trajectory_id"], set()).add(e["instruction"]["instruction_text"])
    assert {len(texts) for texts in told.values()} == {len(_told_ways.STYLES)}


def test_the_scene_that_is_named_is_the_one_that_the_habitat_format_writes(tmp_path, home):
    out = tmp_path / "scene"
    export.run(home, ["habitat", "vln"], out, sample.load)
    e = json.loads(gzip.decompress((out / vln.FILE).read_bytes()))["episodes"][0]
    assert (out / e["scene_id"]).is_file() and (out / e["scene_dataset_config"]).is_file()


def test_ways_lie_on_free_floor(episodes, home):
    area = free(home)
    for e in episodes:
        line = LineString(ground(e["reference_path"]))
        assert area.contains(line) and line.distance(area.boundary) > reach.RADIUS - CELL


def shortest(area, start, end):
    """Length of the shortest way over an area, from corner to corner of it; inf where there is none."""
    corners = [p for part in getattr(area, "geoms", [area]) for ring in (part.exterior, *part.interiors)
               for p in ring.coords[:-1]]
    every, loose, seen = [*corners, tuple(start), tuple(end)], area.buffer(1e-6), networkx.Graph()
    seen.add_weighted_edges_from(
        (a, b, np.hypot(every[a][0] - every[b][0], every[a][1] - every[b][1]))
        for a in range(len(every)) for b in range(a) if loose.contains(LineString([every[a], every[b]])))
    ends = len(every) - 2, len(every) - 1
    return networkx.dijkstra_path_length(seen, *ends) if all(n in seen for n in ends) else np.inf


def test_the_distance_is_the_way_s_length_and_that_of_the_shortest(episodes, home):
    """For a robot little thinner there is no shorter way, and for one little thicker none much shorter."""
    thin, thick = (free(home).buffer(-reach.RADIUS + by, quad_segs=4) for by in (CELL, -CELL))
    bounded = 0
    for e in episodes[4 * len(_told_ways.STYLES) :: 12 * len(_told_ways.STYLES)]:
        points, told = np.array(e["reference_path"]), e["info"]["geodesic_distance"]
        assert np.linalg.norm(np.diff(points, axis=0), axis=1).sum() == pytest.approx(told, abs=2e-3)
        ends = ground(points)[[0, -1]]
        assert shortest(thin, *ends) - 1e-4 <= told    # it is rounded
        most = shortest(thick, *ends)
        assert told <= 1.04 * most
        bounded += np.isfinite(most)
    assert bounded


def test_one_starts_facing_the_first_step(episodes):
    for e in episodes:
        ahead = Rotation.from_quat(e["start_rotation"]).apply([0, 0, -1])
        step = np.subtract(e["reference_path"][1], e["reference_path"][0])
        assert ahead == pytest.approx(step / np.linalg.norm(step), abs=1e-3)


def test_words_name_what_is_there_in_the_order_of_the_way(episodes, home):
    objects, types = {o.id: o for o in home.objects}, {room.id: room.type for room in home.rooms}
    for e in episodes:
        text, info = e["instruction"]["instruction_text"], e["info"]
        sentences = text.removesuffix(".").split(". ")
        assert len(sentences) == len(info["rooms"]) == len(info["openings"]) + 1
        for k, (here, there) in enumerate(pairwise(info["rooms"])):
            named = (there,) if k else (here, there)
            assert all(types[room].replace("_", " ") in sentences[k] for room in named)
        said = re.findall(rf"\b({NAMES})\b", text)
        known = [TABLE[objects[id].category].called for id in (*info["passed"], info["goal"])]
        assert said == known or said == known[-1:]
        assert objects[info["goal"]].room == info["rooms"][-1]
        inside = [o.category for o in home.objects if o.room == info["rooms"][-1]]
        assert inside.count(objects[info["goal"]].category) == 1


def test_what_is_passed_lies_on_the_side_that_is_told(episodes, home):
    objects, seen = {o.id: o for o in home.objects}, 0
    for e in episodes:
        line = LineString(ground(e["reference_path"]))
        for id in e["info"]["passed"]:
            middle = np.array(objects[id].center[:2])
            at = line.project(LineString([middle, middle + 1e-6]).centroid)
            a, b = (np.array(line.interpolate(at + d).coords[0]) for d in (-0.1, 0.1))
            side = "left" if np.cross([*(b - a), 0], [*(middle - a), 0])[2] > 0 else "right"
            name = TABLE[objects[id].category].called
            text = e["instruction"]["instruction_text"]
            assert name not in text or f"the {name} on your {side}" in text
            seen += f"the {name} on your" in text
    assert seen


def _mirrored(home):
    """The home seen in a mirror along y."""
    turned = home.model_copy(deep=True)
    for room in turned.rooms:
        room.polygon = [(-x, y) for x, y in reversed(room.polygon)]
    for o in turned.openings:
        o.segment = ((-o.segment[0][0], o.segment[0][1]), (-o.segment[1][0], o.segment[1][1]))
    for thing in turned.objects:
        thing.center, thing.yaw = (-thing.center[0], *thing.center[1:]), np.pi - thing.yaw
    return turned


def test_in_a_mirror_left_is_right(episodes, home, tmp_path):
    swapped = {"left": "right", "right": "left"}
    mirrored = read(_mirrored(home), sample.load, tmp_path / "scene")["episodes"]
    assert len(mirrored) == len(episodes)
    compared = set()
    for one, other in zip(episodes, mirrored):
        if abs(one["info"]["geodesic_distance"] - other["info"]["geodesic_distance"]) < 0.15:  # else another way round
            text, there = (e["instruction"]["instruction_text"] for e in (one, other))
            assert text == re.sub("left|right", lambda found: swapped[found[0]], there)
            compared.add(text)
    assert len(compared) >= 15 and any("left" in text for text in compared)


@pytest.mark.parametrize("y, side", [(0.5, "left"), (0.4, None), (0.0, None), (-0.4, None), (-0.5, "right")])
def test_what_is_passed_is_aside_by_a_hand_and_more(y, side):
    """A way 3 m to the east, and beside its middle a stool of 40 cm: 30, 20 and no centimetres from it."""
    home = handmade.home(handmade.thing("stool", 2.0, 1.5 + y, size=(0.4, 0.4, 0.5), id="stool"))
    leg = _legs.Leg(handmade.LIVING, np.array([[0.5, 1.5], [3.5, 1.5]]), None, None, [], 0.0)
    found = [("left" if one.left else "right", one.at) for one in _legs.passed(home, leg, ["stool"])]
    assert found == ([(side, pytest.approx(1.5))] if side else [])


def test_two_rooms_by_hand(tmp_path):
    """From the middle of the living room, looking east, through the door at y 1.45 to a bookshelf at the north wall."""
    home = handmade.home(handmade.thing("bookshelf", 5.9, 2.7, -np.pi / 2, handmade.BEDROOM))
    found = read(home, sample.load, tmp_path / "scene")["episodes"]
    texts = [e["instruction"]["instruction_text"] for e in found]
    assert texts[0].startswith("Leave the living room through the door straight ahead into the bedroom. ")
    assert texts[0].endswith("top in front of the bookshelf.") and len(texts) == 3


def test_numbers_are_those_of_the_words_and_all_homes_have_one_vocabulary(held):
    words = held["instruction_vocab"]["word_list"]
    assert words == _told_ways.vocabulary() and words[0] == "<pad>" and len(set(words)) == len(words)
    for e in held["episodes"]:
        numbers = e["instruction"]["instruction_tokens"]
        assert len(numbers) == _told_ways.LENGTH
        text = " ".join(words[n] for n in numbers if n)
        assert text == re.sub(r"([.])", r" \1", e["instruction"]["instruction_text"].lower().replace(",", ""))


def test_the_same_home_gives_the_same_bytes(home, tmp_path):
    for name in "ab":
        export.run(home, ["vln"], tmp_path / name, sample.load)
    assert (tmp_path / "a" / vln.FILE).read_bytes() == (tmp_path / "b" / vln.FILE).read_bytes()


BARE = sample.home().model_copy(update={"objects": []})


@pytest.mark.parametrize("home", [handmade.plan(), BARE], ids=["plan", "bare"])
def test_a_home_without_furniture_is_refused_by_name(home, tmp_path):
    with pytest.raises(BadInput, match="format vln: .*furnished"):
        export.run(home, ["vln"], tmp_path / "scene", sample.load)
    assert not (tmp_path / "scene").exists()


def test_no_way_is_asked_for_that_is_short_or_ends_where_one_does_not_see_its_goal(home, monkeypatch):
    monkeypatch.setattr(vln, "_shows", lambda *_: False)
    assert not list(vln._ways(home, None))
    monkeypatch.setattr(vln, "_shows", lambda *_: True)
    ways = [vln.length(way) for way, _, _ in vln._ways(home, None)]
    monkeypatch.setattr(vln, "SHORTEST", sorted(ways)[1])
    assert len(list(vln._ways(home, None))) == len(ways) - 1 > 3
