"""Questions about films: what frames show by an independent cast, orders and rooms worked out anew, lines and card."""

import json
from itertools import combinations
from types import SimpleNamespace

import numpy as np
import pytest
from export import sample

from apartgen.schemas.qa import Question
from apartgen.schemas.render import Film, Instance, Render, Shown
from apartgen.stages import qa, seeds
from apartgen.stages.qa import card
from apartgen.stages.qa.config import QaConfig
from apartgen.stages.render import TILT, film
from apartgen.stages.render.config import RenderConfig
from apartgen.stages.render.labels import instances
from apartgen.stages.scene.scene import Scene
from apartgen.stages.scene.world import world

CONFIG = RenderConfig(film=48, rate=3, speed=0.8)
KINDS = ["first_seen", "room_order", "room_then"]


@pytest.fixture(scope="module")
def walks():
    """The small flat's film there and back: moments, cameras, and what is known of their frames."""
    scene = Scene(sample.home(), sample.load)
    around, found = world(scene), []
    for back in (False, True):
        config = CONFIG.model_copy(update={"back": back})
        some = film.moments(around, config)
        cameras = film.lenses(some, config, TILT)
        looked = list(film.looks(scene, around, some, cameras))
        rooms = [room.id for room in around.plan.rooms]
        frames = [Shown(seconds=k / 3, room=rooms[m.stand.room] if m.stand.room >= 0 else "", visible=look.visible)
                  for k, (m, look) in enumerate(zip(some, looked))]
        told = Film(file="walk.mp4", rate=3, width=cameras[0].columns, height=cameras[0].rows, frames=frames)
        found.append((some, cameras, Render(film=told, instances=instances(around))))
    return found


@pytest.fixture(scope="module")
def asked(walks):
    return [[one for seed in range(6) for one in qa.run(sample.home(), render, QaConfig(kind=KINDS),
                                                        seeds.drawn(seed, "qa"))] for _, _, render in walks]


def triangles(shares):
    """Corners (n, 3, 3) of the flat and the number of the thing of each, doors open by these shares of their range."""
    parts, owners = [], []
    for number, body in enumerate(Scene(sample.home(), sample.load).bodies, 1):
        for link in body.links:
            share = shares.get(body.name, 0.0) if link.joint is not None else 0.0
            for mesh in link.visuals:
                points = mesh.vertices.astype(float)
                if share:
                    by = np.sign(link.joint.axis[2]) * share * link.joint.range[1]
                    points = turned(points - link.joint.origin, by) + link.joint.origin
                parts.append((turned(points, body.yaw) + body.position)[mesh.faces])
                owners.append(np.full(len(mesh.faces), number))
    return np.concatenate(parts), np.concatenate(owners)


def turned(points, by):
    x, y, z = points.T
    return np.stack([np.cos(by) * x - np.sin(by) * y, np.sin(by) * x + np.cos(by) * y, z], -1)


def cast(eye, ways, corners):
    """Which triangle each ray meets first, -1 for none, in plain double precision: signed volumes, plane by plane."""
    a, b, c = (corners[:, k] - eye for k in range(3))
    normal = np.cross(b - a, c - a)
    sides = [ways @ np.cross(p, q).T for p, q in ((a, b), (b, c), (c, a))]
    within = np.logical_or(np.minimum.reduce(sides) >= 0, np.maximum.reduce(sides) <= 0)
    with np.errstate(divide="ignore", invalid="ignore"):
        far = np.einsum("nd,nd->n", a, normal) / (ways @ normal.T)
    far = np.where(within & (far > 0), far, np.inf)
    return np.where(np.isfinite(far.min(1)), far.argmin(1), -1)


def test_frames_show_what_an_independent_cast_meets(walks):
    some, cameras, render = walks[0]
    told = render.film
    assert any(m.doors for m in some) and len(told.frames) == len(some)
    for k in np.linspace(0, len(some) - 1, 3).astype(int):
        corners, owners = triangles(dict(some[k].doors))
        u, v = np.meshgrid(np.arange(told.width) + 0.5, np.arange(told.height) + 0.5)
        fx, fy, cx, cy = cameras[k].intrinsics
        right, up, back = cameras[k].frame.astype(float)
        ways = ((u - cx) / fx)[..., None] * right - ((v - cy) / fy)[..., None] * up - back
        met = cast(np.asarray(cameras[k].eye, float), ways.reshape(-1, 3), corners)
        expected = np.bincount(owners[met[met >= 0]], minlength=len(render.instances) + 1)
        got = np.zeros_like(expected)
        for number, pixels in told.frames[k].visible:
            got[number] = pixels
        assert (np.abs(got - expected) <= np.maximum(3, 0.005 * expected)).all()


def test_things_come_in_the_order_in_which_frames_first_show_them(walks, asked):
    """By any threshold between a glimpse and a clear sight."""
    many = 0
    for (_, _, render), found in zip(walks, asked):
        told, numbers = render.film, {thing.id: thing.number for thing in render.instances if thing.box}
        shares = {id: np.array([dict(frame.visible).get(number, 0) for frame in told.frames]) / told.width / told.height
                  for id, number in numbers.items()}
        for one in (one for one in found if one.kind == "first_seen"):
            for share in (0.001, 0.003, 0.006):
                first = [int(np.argmax(shares[id] > share)) for id in one.evidence["order"]]
                assert all(a < b for a, b in zip(first, first[1:]))
            words = [id.rsplit("_", 1)[0].replace("_", " ") for id in one.evidence["order"]]
            assert one.value.lower() == ", ".join(f"the {word}" for word in words)
            many += 1
    assert many >= 12


def test_rooms_are_those_in_which_the_camera_stands(walks, asked):
    kinds = set()
    for (_, cameras, _), found in zip(walks, asked):
        places = np.array([camera.eye[:2] for camera in cameras])
        at = np.full(len(places), "", dtype=object)
        for kind, (x0, y0, x1, y1) in sample.ROOMS.values():
            inside = (places >= (x0, y0)).all(1) & (places <= (x1, y1)).all(1)
            at[inside] = kind.replace("_", " ")
        for one in found:
            if one.kind == "room_order":
                named = [name.removeprefix("the ") for name in one.value.split(", ")]
                first = [int(np.argmax(at == name)) for name in named]
                assert all(name in at for name in named) and first == sorted(first)
            if one.kind == "room_then":
                seconds = one.evidence["seconds"][0]
                assert f" {seconds:.0f} seconds " in one.text
                assert set(at[round(3 * seconds) + np.arange(-2, 3)]) == {one.value}
            kinds.add(one.kind)
    assert kinds == set(KINDS)


def test_there_and_back_are_told_apart(walks, asked):
    (there, _, _), (back, _, _) = walks
    assert np.linalg.norm(there[0].stand.place - back[-1].stand.place) < 0.3
    assert np.linalg.norm(there[0].stand.place - back[0].stand.place) > 1
    orders = [{frozenset(one.evidence["rooms"]): one.value for one in found if one.kind == "room_order"}
              for found in asked]
    both = set(orders[0]) & set(orders[1])
    assert both and all(orders[0][rooms] != orders[1][rooms] for rooms in both)


def drawn_film(rows, names):
    """A film whose frames, ten a second, show these numbers by these shares of 10,000 pixels."""
    frames = [Shown(seconds=k / 10, room="hallway_1", visible=[(n, p) for n, p in row.items() if p])
              for k, row in enumerate(rows)]
    things = [Instance(number=k, id=id, category=id, label=1) for k, id in enumerate(names, 1)]
    return Render(film=Film(file="walk.mp4", rate=10, width=100, height=100, frames=frames), instances=things)


@pytest.mark.parametrize("between, glimpse, wanted", [(10, 0, True), (1, 0, False), (10, 30, False)])
def test_what_appears_at_about_the_same_time_is_not_asked_for(between, glimpse, wanted):
    """Four things, each clear for good from its time on; and a glimpse of the last one at the very beginning."""
    names = ["sofa_1", "double_bed_9", "toilet_15", "plant_6"]
    rows = [{k + 1: 200 if frame >= k * between else 0 for k in range(4)} for frame in range(60)]
    rows[0][4] = max(rows[0][4], glimpse)
    found = qa.run(sample.home(), drawn_film(rows, names), QaConfig(kind=["first_seen"]), seeds.drawn(1, "qa"))
    assert bool(found) == wanted


@pytest.mark.parametrize("many", [0, 1, 3, 4])
def test_of_fewer_than_four_things_no_order_is_asked(many):
    names = ["sofa_1", "double_bed_9", "toilet_15", "plant_6"][:many]
    rows = [{k + 1: 200 if frame >= k * 10 else 0 for k in range(many)} for frame in range(60)]
    found = qa.run(sample.home(), drawn_film(rows, names), QaConfig(kind=["first_seen"]), seeds.drawn(1, "qa"))
    assert bool(found) == (many == 4)


@pytest.mark.parametrize("taken_for", ["corner_sofa", "armchair"])
def test_names_that_could_mean_another_are_not_asked_for(taken_for):
    """An armchair is drawn as a sofa is, and may be taken for one."""
    home = sample.home()
    sofa = next(o for o in home.objects if o.category == "sofa")
    more = home.model_copy(update={"objects": [*home.objects, sofa.model_copy(
        update={"id": "corner_sofa_90", "category": taken_for})]})
    names = ["sofa_1", "double_bed_9", "toilet_15", "plant_6"]
    rows = [{k + 1: 200 if frame >= k * 10 else 0 for k in range(4)} for frame in range(60)]
    asked = [qa.run(some, drawn_film(rows, names), QaConfig(kind=["first_seen"]), seeds.drawn(1, "qa"))
             for some in (home, more)]
    assert asked[0] and not asked[1]


def test_lines_name_the_film(asked):
    for row, one in zip(qa.lines(asked[0], "pictures").splitlines(), asked[0]):
        line = json.loads(row)
        assert line["images"] == [] and line["videos"] == ["pictures/walk.mp4"]
        assert line["messages"][0]["content"].startswith("<video>\n") and line["messages"][1]["content"] == one.answer
    with pytest.raises(ValueError, match="images or about videos"):
        Question(id="a", kind="a", text="a", options=["a", "b"], answer="A", value="a", difficulty="easy")


def test_without_a_film_nothing_is_asked_about_one(walks):
    bare = walks[0][2].model_copy(update={"film": None})
    assert not qa.run(sample.home(), bare, QaConfig(kind=KINDS), seeds.drawn(1, "qa"))


def test_orders_have_no_rank_among_their_options(asked):
    """No option is nearer to the others than the right one is: each order differs from the rest by what was drawn."""
    same = [SimpleNamespace(right=one.value, options=one.options) for found in asked for one in found
            if one.kind in ("first_seen", "room_order")]
    agree = {True: [], False: []}
    for one in same:
        for option in one.options:
            others = [other for other in one.options if other != option]
            agree[option == one.right].append(np.mean([shared_pairs(option, other) for other in others]))
    assert np.mean(agree[True]) - np.mean(agree[False]) < 0.1


def shared_pairs(one, other):
    """Of two orders of the same names, the share of pairs that come in the same order."""
    a, b = one.split(", "), other.split(", ")
    return np.mean([b.index(x) < b.index(y) for x, y in combinations(a, 2)])


def test_the_card_counts_what_the_files_hold(asked):
    files = {f"{k}.jsonl": [json.loads(row) for row in qa.lines(found, str(k)).splitlines()]
             for k, found in enumerate(asked)}
    page = card.text(files, "apartgen")
    rows = [row for some in files.values() for row in some]
    assert page.startswith("---\n") and card.MARK in page and f"\n{len(rows)} questions of 3 kinds" in page
    assert "2 films" in page and 'data_files: "*.jsonl"' in page
    for kind in KINDS:
        cells = next(line for line in page.splitlines() if line.startswith(f"| `{kind}`")).split(" | ")
        mine = [row for row in rows if row["kind"] == kind]
        assert int(cells[2]) == len(mine) == sum(int(n) for n in cells[4].rstrip(" |").split(", "))
        assert float(cells[3]) == pytest.approx(np.mean([1 / len(row["options"]) for row in mine]), abs=0.005)


@pytest.mark.parametrize("many, size", [(999, "n<1K"), (1000, "1K<n<10K"), (10_000, "10K<n<100K")])
def test_the_card_tells_hubs_how_many_questions_there_are(many, size):
    row = {"images": [], "videos": [], "kind": KINDS[0], "answer": "A", "options": ["1"], "evidence": {},
           "difficulty": "easy"}
    assert f"size_categories:\n- {size}\n" in card.text({"0.jsonl": [row] * many}, "apartgen")
