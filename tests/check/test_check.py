"""The judge: right homes are certified, every kind of fault is found and named, whatever a file holds."""

import ast
import copy
import json
import math
from pathlib import Path

import handmade as h
import numpy as np
import pytest
import shapely
from check import injections
from scipy.spatial.transform import Rotation
from syntax import tree_of

from apartgen import checking
from apartgen.schemas.errors import ApartgenError
from apartgen.schemas.migrations import migrate
from apartgen.schemas.plan import Plan
from apartgen.schemas.retrieve import Joint
from apartgen.schemas.walkable import Report, Walkable
from apartgen.stages import check
from apartgen.stages.check import opening as opens
from apartgen.stages.check import shapes

ROOT = Path(__file__).parents[2]
EXAMPLES = sorted(ROOT.glob("examples/*/*.json"))
GOLDEN = sorted(file for stage in ("plan", "layout", "retrieve", "walkable")
                for file in ROOT.glob(f"tests/golden/*/{stage}.json"))
SMALL, FLAT = ROOT / "tests/golden/v1/walkable.json", ROOT / "examples/two-bedroom-flat/walkable.json"
JUDGES = ("shapes", "building", "furniture", "opening", "robot")


def read(body_or_text) -> Plan:
    text = body_or_text if isinstance(body_or_text, bytes) else json.dumps(body_or_text).encode()
    found = checking.parsed(text, "home.json")
    assert found is not None
    return found.home


def refusing(home: Plan) -> list[check.Fault]:
    return [fault for fault in check.run(home) if fault.refuses]


def walked(*objects) -> Walkable:
    return Walkable(**dict(h.home(*objects)), walkable=Report(target=0.7, before=1, after=1))


def injected(raw, name, seed, tries=5):
    """A copy of an artifact with a fault, and what must be named; None where there is no place for it."""
    raw = migrate(raw, "home.json")
    for k in range(tries):
        other = copy.deepcopy(raw)
        ids = injections.KINDS[name][1](other["body"], np.random.default_rng([seed, k]))
        if ids is not None:
            return other, ids
    return None


def is_named(name, found, ids) -> bool:
    codes = injections.KINDS[name][0]
    return any(f.refuses and f.code in codes and (not ids or not set(ids).isdisjoint(f.of)) for f in found)


@pytest.mark.parametrize("file", [*EXAMPLES, *GOLDEN], ids=lambda file: f"{file.parent.name}/{file.stem}")
def test_right_homes_are_certified(file):
    assert [str(fault) for fault in refusing(read(file.read_bytes()))] == []


@pytest.mark.parametrize("name", injections.KINDS)
def test_a_fault_is_found_and_named(name):
    made = injected(json.loads(SMALL.read_text()), name, 7) or injected(json.loads(FLAT.read_text()), name, 7)
    if made is None:
        pytest.skip("no place for it in these homes")
    found = check.run(read(made[0]))
    assert is_named(name, found, made[1]), [str(fault) for fault in found]


def test_every_code_is_put_to_the_test():
    beside = {"not-between"}  # by a test of its own below
    assert set().union(*(codes for codes, _ in injections.KINDS.values())) == set(check.WHAT) - beside


@pytest.mark.slow
def test_a_thousand_faults_in_fifty_homes(tmp_path, capsys, monkeypatch):
    """Twenty kinds and more in each of fifty flats, made from as many sentences."""
    import commandline

    rows = [json.loads(line) for line in (ROOT / "tests/sentences/sentences.jsonl").read_text().splitlines()]
    prompts = [row["prompt"] for row in rows if not row["prompt"].startswith("-")][::10]
    places = [f"{tmp_path}/{word}/" for word in ("plan", "layout", "retrieve", "walkable")]
    assert commandline.run(capsys, monkeypatch, "-q", "plan", *prompts, "--seed", 3, "-o", places[0]).code == 0
    for word, before, after in zip(("layout", "retrieve", "walkable"), places, places[1:]):
        commandline.run(capsys, monkeypatch, "-q", word, *sorted(Path(before).glob("*.json")), "-o", after)
    texts = [json.loads(file.read_text()) for file in sorted(Path(places[-1]).glob("*.json"))]
    homes = [raw for raw in texts if not refusing(read(raw))][:50]
    assert len(homes) == 50
    made = [(name, injected(raw, name, i)) for i, raw in enumerate(homes) for name in injections.KINDS]
    put = [(name, one) for name, one in made if one is not None]
    missed = [name for name, (raw, ids) in put if not is_named(name, check.run(read(raw)), ids)]
    assert len(put) >= 1000 and missed == []


# What is measured, by hand


def test_depth_is_the_least_shift_that_parts_two_boxes():
    a = h.thing("chest", 1, 1, size=(0.5, 1.0, 0.8))
    beside = h.thing("chest", 1.4, 1.2, size=(0.5, 1.0, 0.8))
    above = h.thing("chest", 1, 1, size=(0.5, 1.0, 0.8), bottom=0.75)
    corner = h.thing("chest", 1 + 0.25 + 0.5 * math.sqrt(2) - 0.1, 1, math.pi / 4, size=(1.0, 1.0, 0.8))
    apart = h.thing("chest", 2, 1, size=(0.5, 1.0, 0.8))
    found = shapes.depth(shapes.boxes([a]), shapes.boxes([beside, above, corner, apart]))[0]
    assert found == pytest.approx([0.1, 0.05, 0.1, -0.5])


def test_the_witness_of_an_overlap():
    sofa = h.thing("sofa", 2, 2, id="a", size=(0.9, 2.0, 0.8))
    (fault,) = refusing(h.home(sofa, h.thing("chest", 2.6, 2, id="b", size=(0.5, 0.8, 0.8))))
    assert (fault.code, fault.of) == ("overlap", ("a", "b"))
    assert fault.value == pytest.approx(0.1) and fault.at == pytest.approx((2.4, 2.0, 0.4))


def test_contacts_of_use_are_noted_and_refused_beyond_it():
    bed = h.thing("double_bed", 1.5, 1, id="bed", size=(2.0, 1.6, 0.9))
    for gap, verdict in ((0.0, []), (-0.03, [False]), (-0.12, [True])):
        stand = h.thing("nightstand", 0.7, 1.8 + 0.25 + gap, id="stand", size=(0.4, 0.5, 0.5))
        assert [f.refuses for f in check.run(h.home(bed, stand)) if f.code == "overlap"] == verdict


def test_seats_go_under_tables_but_not_their_backs():
    table = h.thing("dining_table", 2, 1.5, id="table", size=(0.9, 1.6, 0.75))
    for x, yaw, refused in ((1.45, 0, False), (1.45, math.pi, True), (2.0, 0, True)):
        chair = h.thing("chair", x, 1.5, yaw, id="chair", size=(0.5, 0.45, 0.9))
        assert bool([f for f in refusing(h.home(table, chair)) if f.code == "overlap"]) == refused, (x, yaw)
    disc = h.thing("round_table", 2, 1.5, id="table", size=(1.1, 1.1, 0.75))
    for x, y, yaw, refused in ((1.48, 0.98, math.pi / 4, False), (1.55, 1.05, -3 * math.pi / 4, True)):
        chair = h.thing("chair", x, y, yaw, id="chair", size=(0.5, 0.45, 0.9))
        assert bool([f for f in refusing(h.home(disc, chair)) if f.code == "overlap"]) == refused, (x, yaw)
    away = h.thing("chair", 1.42, 0.92, -3 * math.pi / 4, id="chair", size=(0.5, 0.45, 0.9))  # in its box's corner only
    assert refusing(h.home(disc, away)) == []
    stool = h.thing("stool", 2, 1.5, size=(0.35, 0.35, 0.5))
    assert refusing(h.home(table, stool)) == []


def test_soft_and_flat_things_are_in_nobodys_way():
    rug = h.thing("rug", 2, 1.5, size=(1.6, 2.3, 0.01), bottom=0)
    curtain = h.thing("curtain", 0.06, 2.2, size=(0.12, 1.2, 2.3), bottom=0.1)
    assert refusing(walked(rug, curtain, h.chest(0.3, 2.46))) == []


def test_what_stands_on_something_and_what_is_said_of_it():
    low = h.chest(2, 1.5, id="low")
    lamp = h.thing("table_lamp", 2, 1.5, id="lamp", bottom=0.8)
    assert refusing(h.home(low, lamp)) == []
    floating = h.thing("table_lamp", 2, 1.5, id="lamp", bottom=0.9)
    assert [f.code for f in refusing(h.home(low, floating))] == ["unsupported"]
    for said, codes in (("low", []), ("floor", ["not-on"]), ("ceiling", ["not-on"]), ("attic", ["inconsistent"])):
        assert [f.code for f in refusing(h.home(low, lamp.model_copy(update={"on": said})))] == codes


def test_pictures_do_not_hang_on_windows():
    glass = h.thing("mirror", 5.5, 0.02, math.pi / 2, h.BEDROOM, size=(0.04, 0.6, 0.8), bottom=1.0)
    wall = h.thing("mirror", 6.6, 0.02, math.pi / 2, h.BEDROOM, size=(0.04, 0.6, 0.8), bottom=1.0)
    assert [[f.code for f in refusing(h.home(o))] for o in (glass, wall)] == [["unsupported"], []]


def test_parts_are_followed_all_the_way():
    """A door of 0.6 m at the left of a 0.6 m wide cabinet, and a box in its quarter circle or beyond its corner."""
    door = Joint(name="door", type="hinge", axis=(0, 0, 1), origin=(0.3, 0.3, 0), range=(0, math.pi / 2),
                 part="hinge_door", extent=((0.28, -0.3, -0.4), (0.3, 0.3, 0.4)))
    cabinet = h.thing("fridge", 0.3, 2.5, room=h.LIVING, id="cabinet", size=(0.6, 0.6, 0.85), joints=(door,))
    for x, y, met in ((0.6 + 0.45, 2.8 - 0.45, True), (0.6 + 0.6, 2.8 - 0.6, False), (0.6 + 0.1, 2.8 - 0.1, True)):
        post = h.thing("bin", x, y, id="post", size=(0.2, 0.2, 0.5))
        found = [f.of for f in refusing(walked(cabinet, post)) if f.code == "part-blocked"]
        assert found == ([("cabinet", "door", "post")] if met else []), (x, y)


def test_whether_all_opens_refuses_once_the_stage_for_it_has_run():
    objects = h.chest(0.25, 1.5, id="chest"), h.thing("sofa", 1.2, 2.0, size=(0.9, 1.8, 0.8))
    before, after = check.run(h.home(*objects)), check.run(walked(*objects))
    assert [f._replace(refuses=True) for f in before] == after and not any(f.refuses for f in before)
    assert any(f.code == "part-blocked" for f in after)
    assert check.run(h.home(*objects), strict=True) == after


@pytest.mark.parametrize("gap, codes", [(0.44, ["unreached"]), (0.56, [])])
def test_the_robot_needs_its_width(gap, codes):
    """A chest behind a row of shelves that leaves a gap."""
    wall = h.thing("bookshelf", 2.0, (3 - gap) / 2, size=(0.3, 3 - gap, 1.9), id="row")
    far = h.chest(3.75, 2.5, math.pi, id="chest", travel=0.2)
    found = refusing(walked(wall, far))
    assert [f.code for f in found if "chest" in f.of] == codes

@pytest.mark.parametrize("bottom, found", [(1.45, ["unreached"]), (1.55, [])])
def test_the_robot_passes_below_what_hangs_above_its_head(bottom, found):
    """It is 1.5 m high; a board across the room, before the only chest."""
    board = h.thing("wall_shelf", 2.0, 1.5, size=(0.3, 2.98, 0.2), bottom=bottom, id="board")
    chest = h.chest(3.75, 2.5, math.pi, id="chest", travel=0.2)
    assert [f.code for f in refusing(walked(board, chest)) if "chest" in f.of] == found


@pytest.mark.parametrize("axis", [(0, 0, 1), (0, 0, -1), (0, 1, 0), (0, -1, 0), (1, 0, 0), (0.6, 0, 0.8)])
def test_boxes_about_a_turning_part_hold_all_its_corners_and_no_more(axis):
    """Against scipy's rotations: of each position the box has the least and greatest height of the part's corners and,
    where the part turns about the vertical, these corners themselves."""
    lo, hi = np.array([0.1, -0.3, -0.4]), np.array([0.15, 0.25, 0.3])
    joint = Joint(name="d", type="hinge", axis=axis, origin=(0.15, -0.3, 0.1), range=(0.0, 1.3), part="hinge_door",
                  extent=(tuple(lo), tuple(hi)))
    piece = h.thing("fridge", 1.2, 0.9, 0.7, size=(0.4, 0.6, 0.9), joints=(joint,))
    found = opens._positions(piece, joint)
    corners = np.array(np.meshgrid(*zip(lo, hi))).reshape(3, -1).T
    for angle, ring, low, high in zip(np.linspace(0, 1.3, len(found.low)), *found):
        turned = Rotation.from_rotvec(angle * np.array(axis, float)).apply(corners - joint.origin) + joint.origin
        world = Rotation.from_euler("z", piece.yaw).apply(turned) + piece.center
        assert (low, high) == pytest.approx((world[:, 2].min(), world[:, 2].max()))
        mark, true = shapely.Polygon(ring), shapely.MultiPoint(world[:, :2]).convex_hull
        assert mark.buffer(1e-9).covers(true)
        local = shapely.MultiPoint(turned[:, :2]).envelope
        assert mark.area == pytest.approx(true.area if abs(axis[2]) == 1 else local.area)


def test_an_opening_between_rooms_is_between_them():
    home = h.plan()
    elsewhere = home.openings[0].model_copy(update={"rooms": [h.BEDROOM], "into": None})
    found = check.run(home.model_copy(update={"openings": [elsewhere, *home.openings[1:]]}))
    assert [f.of for f in found if f.code == "not-in-wall"] == [("entrance_1", h.BEDROOM)]
    both = [r.model_copy(update={"polygon": h.rectangle(0, 0, 4, 3)}) for r in home.rooms]
    found = check.run(home.model_copy(update={"rooms": both}))
    assert {"not-between", "rooms-overlap"} <= {f.code for f in found}


# Whatever a file holds


def moved(raw, angle, by):
    """A whole home turned and shifted."""
    c, s = math.cos(angle), math.sin(angle)

    def at(p):
        return [c * p[0] - s * p[1] + by[0], s * p[0] + c * p[1] + by[1], *p[2:]]

    other = copy.deepcopy(raw)
    for room in other["body"]["rooms"]:
        room["polygon"] = [at(p) for p in room["polygon"]]
    for opening in other["body"]["openings"]:
        opening["segment"] = [at(p) for p in opening["segment"]]
    for o in other["body"]["objects"]:
        o["center"], o["yaw"] = at(o["center"]), o["yaw"] + angle
    return other


@pytest.mark.parametrize("name", ["", "a_box_stands_before_what_opens", "a_thing_stands_in_another", "a_room_is_grown"])
def test_the_verdict_does_not_hang_on_where_north_is(name):
    raw = json.loads(FLAT.read_text())
    raw = injected(raw, name, 3)[0] if name else raw

    def told(home):
        return sorted((f.code, f.of) for f in check.run(home))

    assert told(read(raw)) == told(read(moved(raw, 0.7, (-31.0, 17.5))))


HOSTILE = [0.0, -1.0, 1e300, -1e300, 1e-300, 1e-9, 999.0, 0.05, 100.0]


def numbers(value, path=()):
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in items:
        yield from numbers(inner, (*path, key))
    if isinstance(value, float):
        yield path


@pytest.mark.filterwarnings("error")
def test_odd_numbers_are_read_or_refused():
    raw = json.loads(SMALL.read_text())
    places = [path for path in numbers(raw["body"]) if "latent" not in path and path[0] != "walkable"]
    rng = np.random.default_rng(5)
    for _ in range(50):
        other = copy.deepcopy(raw)
        for path in rng.choice(len(places), int(rng.integers(1, 4))):
            *way, last = places[path]
            inner = other["body"]
            for key in way:
                inner = inner[key]
            inner[last] = float(rng.choice(HOSTILE))
        try:
            home = read(other)
        except ApartgenError:
            continue
        found = check.run(home)
        json.dumps([(*fault, str(fault)) for fault in found], allow_nan=False)
        assert {f for f in check.quick(home)} <= set(found)


def test_as_many_faults_as_can_be_read():
    pile = walked(*(h.thing("chest", 1, 1, id=f"c{i}") for i in range(60)))
    assert len(check.run(pile)) == check.MOST


# What makes it a judge of its own


def test_it_shares_nothing_with_the_stages_but_facts():
    for file in (ROOT / "stages/check").glob("*.py"):
        for node in ast.walk(tree_of(file.read_text())):
            module = node.module or "" if isinstance(node, ast.ImportFrom) else ""
            known = ("apartgen.schemas", "apartgen.stages.check", "apartgen.stages.things.categories")
            assert not module.startswith("apartgen") or module.startswith(known), f"{file.name} imports {module}"


def test_it_is_short_enough_to_be_read():
    """Three hundred lines without imports, blank lines and docstrings."""
    assert sum(len(lines(ROOT / f"stages/check/{name}.py")) for name in JUDGES) <= 300


def lines(file):
    text = file.read_text()
    words = [node for node in ast.walk(tree_of(text)) if isinstance(node, ast.Import | ast.ImportFrom)
             or (isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant))]
    left_out = {i for node in words for i in range(node.lineno, node.end_lineno + 1)}
    return [line for i, line in enumerate(text.splitlines(), 1) if line.strip() and i not in left_out]
