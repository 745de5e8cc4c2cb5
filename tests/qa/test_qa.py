"""Every answer worked out anew from the artifact and the pictures, by other means; letters and answers are even."""

import json
import re
import shutil
from collections import Counter, defaultdict
from math import atan2, cos, degrees, hypot, sin
from pathlib import Path
from types import SimpleNamespace

import inhabited
import networkx
import numpy as np
import pytest
from PIL import Image

from apartgen.outputs import opened_libraries
from apartgen.schemas import artifact
from apartgen.schemas.retrieve import Retrieve
from apartgen.schemas.walkable import Report, Walkable
from apartgen.stages import qa, render, seeds
from apartgen.stages.qa import marks
from apartgen.stages.qa.config import QaConfig
from apartgen.stages.qa.drafts import Draft, asked, balanced, either_way, shared
from apartgen.stages.qa.facts import Facts
from apartgen.stages.render.config import RenderConfig
from apartgen.stages.things.categories import TABLE

HOME = Path(__file__).parent.parent / "golden/v2/walkable.json"
FLAT = Path(__file__).parent.parent / "digests/homes/flat.json"
ELSEWHERE = {"direction", "first_seen", "room_order", "room_then"}
"""Kinds of quarters and films, which have tests of their own."""


@pytest.fixture(scope="module")
def seen(tmp_path_factory):
    out = tmp_path_factory.mktemp("views") / "views"
    home = artifact.read(HOME, Walkable).body
    config = RenderConfig(width=200, height=150, views=12, frames=16, points=0)
    return home, render.run(home, config, seeds.drawn(3, "views"), out, opened_libraries().load_asset), out


@pytest.fixture(scope="module")
def asked_of(seen):
    return questions(*seen)


@pytest.fixture(scope="module")
def large(tmp_path_factory):
    """A flat of more rooms and things, of which more is asked; not all that is asked of the small one."""
    out = tmp_path_factory.mktemp("views") / "views"
    body = artifact.read(FLAT, Retrieve).body
    home = Walkable(**dict(body), walkable=Report(target=0.7, before=1, after=1))
    config = RenderConfig(width=160, height=120, views=48, frames=8, points=0)
    return home, render.run(home, config, seeds.drawn(3, "views"), out, opened_libraries().load_asset), out


@pytest.fixture(scope="module")
def asked_of_large(large):
    return questions(*large)


@pytest.fixture(scope="module")
def lived_in(tmp_path_factory):
    """The small one with things that people keep in it."""
    out = tmp_path_factory.mktemp("views") / "views"
    home = inhabited.lived_in(3)
    config = RenderConfig(width=320, height=240, views=16, frames=2, points=0)
    return home, render.run(home, config, seeds.drawn(3, "views"), out, inhabited.library().load_asset), out


@pytest.fixture(scope="module")
def asked_of_lived_in(lived_in):
    return questions(*lived_in)


def questions(home, views, out):
    found = [one for seed in range(4) for one in qa.run(home, views, QaConfig(), seeds.drawn(seed, "qa"))]
    qa.numbered(found, out)
    return found


def called(category):
    """Small things are called what they are, without a table."""
    return TABLE[category].called if category in TABLE else category.replace("_", " ")


class Anew:
    """The home and its pictures, and answers to questions by kind, worked out without the stage's code."""

    def __init__(self, home, views, out):
        self.met = {}
        self.home, self.views, self.out = home, {v.name: v for v in views.views}, out
        self.objects = {o.id: o for o in home.objects}
        self.rooms = {r.id: r for r in home.rooms}
        self.numbers = {thing.id: thing.number for thing in views.instances if thing.box}

    def corners(self, o):
        c, s = cos(o.yaw), sin(o.yaw)
        d, w = o.size[0] / 2, o.size[1] / 2
        own = ((d, w), (-d, w), (-d, -w), (d, -w))
        return [(o.center[0] + c * x - s * y, o.center[1] + s * x + c * y) for x, y in own]

    def flat(self, a, b):
        """Distance of two rectangles: every corner against every side, both ways; 0 where one has a corner within."""
        one, other = self.corners(a), self.corners(b)
        if any(self.holds(b, p) for p in one) or any(self.holds(a, p) for p in other):
            return 0.0
        pairs = [(p, q[k], q[k - 1]) for points, q in ((one, other), (other, one)) for p in points for k in range(4)]
        return min(self.to_side(*pair) for pair in pairs)

    @staticmethod
    def to_side(p, a, b):
        ax, ay, bx, by = *a, *b
        t = ((p[0] - ax) * (bx - ax) + (p[1] - ay) * (by - ay)) / ((bx - ax) ** 2 + (by - ay) ** 2)
        t = min(1, max(0, t))
        return hypot(p[0] - ax - t * (bx - ax), p[1] - ay - t * (by - ay))

    @staticmethod
    def holds(o, p):
        x, y = p[0] - o.center[0], p[1] - o.center[1]
        u, v = x * cos(o.yaw) + y * sin(o.yaw), y * cos(o.yaw) - x * sin(o.yaw)
        return abs(u) <= o.size[0] / 2 and abs(v) <= o.size[1] / 2

    def apart(self, a, b):
        low = max(o.center[2] - o.size[2] / 2 for o in (a, b))
        high = min(o.center[2] + o.size[2] / 2 for o in (a, b))
        return hypot(self.flat(a, b), max(0.0, low - high))

    def in_room(self, room, x, y):
        """Even-odd."""
        points, found = self.rooms[room].polygon, False
        for (ax, ay), (bx, by) in zip(points, [*points[1:], points[0]]):
            if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
                found = not found
        return found

    def room_of(self, place):
        return next(room for room in self.rooms if self.in_room(room, *place))

    def ahead(self, o):
        """First thing met on lines ahead of the whole front, and how far, by steps of half a centimetre."""
        if o.id not in self.met:
            self.met[o.id] = self.stepped(o)
        return self.met[o.id]

    def stepped(self, o):
        best, met = 12.0, ""
        solid = [p for p in self.home.objects if p.id != o.id and p.room == o.room
                 and p.center[2] + p.size[2] / 2 > max(o.center[2] - o.size[2] / 2, 0.1)
                 and p.center[2] - p.size[2] / 2 < o.center[2] + o.size[2] / 2]
        for v in np.linspace(-o.size[1] / 2 + 0.02, o.size[1] / 2 - 0.02, 61):
            for u in np.arange(0.002, best, 0.005):
                x = o.center[0] + cos(o.yaw) * (o.size[0] / 2 + u) - sin(o.yaw) * v
                y = o.center[1] + sin(o.yaw) * (o.size[0] / 2 + u) + cos(o.yaw) * v
                hit = next((p.id for p in solid if self.holds(p, (x, y))), None)
                if hit is None and self.in_room(o.room, x, y):
                    continue
                if u < best:
                    best, met = u, hit or ""
                break
        return best, met

    def image(self, view):
        return np.asarray(Image.open(self.out / f"{view}.instance.png"))

    def share(self, view, id):
        return float((self.image(view.removesuffix(".marks")) == self.numbers[id]).mean())

    def told(self, q, text=None):
        """Ids of the things that a text means by their numbers, by what is at the pixels of these."""
        ids, image = {number: id for id, number in self.numbers.items()}, self.image(q.images[0].removesuffix(".marks"))
        return [ids[image[q.marks[n][1], q.marks[n][0]]] for n in re.findall(r"marked (\d+)", text or q.text)]

    def it(self, q):
        (id,) = self.told(q)
        assert id == q.evidence["object"]
        return self.objects[id]

    def graph(self):
        found = networkx.MultiGraph()
        found.add_nodes_from(self.rooms)
        found.add_edges_from((*o.rooms, o.id) for o in self.home.openings if o.kind != "window" and len(o.rooms) == 2)
        return found

    def count(self, q):
        wanted = (self.views[q.images[0]].room, q.text.rsplit(": ", 1)[1][:-1])
        return str(sum((o.room, called(o.category)) == wanted for o in self.home.objects))

    def absolute_distance(self, q):
        a, b = (self.objects[id] for id in self.told(q))
        return f"{self.apart(a, b):.1f} m"

    def relative_distance(self, q):
        (anchor,) = (self.objects[id] for id in self.told(q))
        near = {option: self.objects[self.told(q, option)[0]] for option in q.options}
        return min(near, key=lambda option: self.apart(anchor, near[option]))

    def direction(self, q):
        """From the middle of the thing and from its four corners, which is where somebody beside it may stand."""
        there, of = (np.array(self.objects[q.evidence[k]].center[:2]) for k in ("facing", "of"))
        at, found = self.objects[q.evidence["at"]], set()
        for here in (at.center[:2], *self.corners(at)):
            ahead, way = there - np.array(here), of - np.array(here)
            side = "left" if ahead[0] * way[1] - ahead[1] * way[0] > 0 else "right"
            found.add(f"{'ahead' if ahead @ way > 0 else 'behind'} to the {side}")
        (answer,) = found
        return answer

    def object_size(self, q):
        return f"{5 * round(max(self.it(q).size) / 0.05)} cm"

    def room_size(self, q):
        points = np.array(self.rooms[self.views[q.images[0]].room].polygon)
        x, y = points.T
        return f"{abs(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2:.0f} m²"

    def route(self, q):
        openings = {o.id: o for o in self.home.openings}
        entrance = next(o for o in self.home.openings if o.kind == "entrance")
        end = np.array(self.views[q.images[0]].pose)[:2, 3]
        way = [entrance, *(openings[id] for id in q.evidence["doors"])]
        assert networkx.shortest_path_length(self.graph(), entrance.rooms[0], self.room_of(end)) == len(way) - 1
        goals = [np.mean(w.segment, axis=0) for w in way[1:]] + [end]
        room, words = None, []
        for opening, goal in zip(way, goals):
            room = opening.rooms[0] if room is None else next(r for r in opening.rooms if r != room)
            a, b = np.array(opening.segment)
            normal = np.array([-(b - a)[1], (b - a)[0]]) / np.linalg.norm(b - a)
            if not self.in_room(room, *((a + b) / 2 + 0.25 * normal)):
                normal = -normal
            assert self.in_room(room, *((a + b) / 2 + 0.25 * normal))
            way_ = goal - (a + b) / 2
            angle = degrees(atan2(normal[0] * way_[1] - normal[1] * way_[0], normal @ way_))
            words.append("straight on" if abs(angle) < 40 else "left" if angle > 0 else "right")
        return ", ".join(words)

    def appearance_order(self, q):
        first = {id: next(k for k, view in enumerate(q.images) if self.share(view, id) > 0.006)
                 for id in q.evidence["order"]}
        assert len(set(first.values())) == 4
        return sorted(first, key=first.get)

    def parts(self, q):
        return str(len(self.it(q).joints))

    def opens(self, q):
        return "yes" if self.it(q).joints else "no"

    def mechanism(self, q):
        ways = set()
        for j in self.it(q).joints:
            ways.add("slide" if j.type == "slide" else
                     f"turn about {'an upright' if abs(j.axis[2]) > 0.7 else 'a level'} hinge")
        return " and ".join(sorted(ways)) or "it has none"

    def reach_out(self, q):
        o, far = self.it(q), 0.0
        for j in (j for j in o.joints if j.extent):
            for x in (j.extent[0][0], j.extent[1][0]):
                for y in (j.extent[0][1], j.extent[1][1]):
                    for z in (j.extent[0][2], j.extent[1][2]):
                        p, axis = np.array([x, y, z]), np.array(j.axis) / np.linalg.norm(j.axis)
                        if j.type == "slide":
                            p = p + axis * j.range[1]
                        else:
                            arm, c, s = p - j.origin, cos(j.range[1]), sin(j.range[1])
                            p = j.origin + arm * c + np.cross(axis, arm) * s + axis * (axis @ arm) * (1 - c)
                        far = max(far, p[0] - o.size[0] / 2)
        return f"{5 * round(far / 0.05)} cm"

    def clearance(self, q):
        far, met = self.ahead(self.it(q))
        assert met == q.evidence["met"] and abs(far - q.evidence["metres"]) < 0.03
        return f"{q.evidence['metres']:.1f} m"

    def in_front(self, q):
        met = self.ahead(self.it(q))[1]
        (option,) = (option for option in q.options if self.told(q, option) == [met])
        return option

    def doors_between(self, q):
        a, b = (self.room_of(np.array(self.views[name].pose)[:2, 3]) for name in q.images[:2])
        ways = list(networkx.all_shortest_paths(self.graph(), a, b))
        assert len(ways) == 1 or a == b
        return str(len(ways[0]) - 1)

    def doors(self, q):
        room = self.views[q.images[0]].room
        return str(sum(room in o.rooms and o.kind != "window" for o in self.home.openings))

    def windows(self, q):
        room = self.views[q.images[0]].room
        return str(sum(room in o.rooms and o.kind == "window" for o in self.home.openings))

    def lamps(self, q):
        return str(sum(o.room == self.views[q.images[0]].room and "lamp" in o.category for o in self.home.objects))

    def carried(self, q):
        on = self.it(q).on
        return f"the {on}" if on in ("floor", "wall", "ceiling") else "another thing"

    def seen(self, q):
        shown = {o.category for o in self.home.objects if self.share(q.evidence["view"], o.id) > 0}
        here = [w for w in q.options if any(re.sub("^an? ", "", w) == called(c) for c in shown)]
        assert len(here) == 1
        return here[0]

    def left_of(self, q):
        image = self.image(q.evidence["view"])

        def middle(id):
            columns = np.nonzero((image == self.numbers[id]).any(0))[0]
            return columns.min() + columns.max()

        return min(q.evidence["objects"], key=middle)

    def nearer(self, q):
        eye = np.array(self.views[q.images[0].removesuffix(".marks")].pose)[:3, 3]

        def far(id):
            o = self.objects[id]
            x, y = eye[:2] - o.center[:2]
            local = np.array([x * cos(o.yaw) + y * sin(o.yaw), y * cos(o.yaw) - x * sin(o.yaw), eye[2] - o.center[2]])
            return np.linalg.norm(np.maximum(np.abs(local) - np.array(o.size) / 2, 0))

        return min(q.options, key=lambda option: far(self.told(q, option)[0]))

    def taller(self, q):
        return max(q.options, key=lambda option: self.objects[self.told(q, option)[0]].size[2])

    def where(self, q):
        kind = self.rooms[self.room_of(np.array(self.views[q.images[0]].pose)[:2, 3])].type
        return {"utility": "utility room", "storage": "storage room"}.get(kind, kind.replace("_", " "))

    def turn(self, q):
        a, b = (np.array(self.views[name].pose)[:2, 2] for name in q.evidence["views"])
        return "to the left" if a[0] * b[1] - a[1] * b[0] > 0 else "to the right"

    def inside(self, q):
        """By every thing's own record of where it was put, or on what it stands."""
        it, held = self.it(q).id, set()
        for o in self.home.objects:
            put = getattr(o, "in_", None)
            if it == (put.object if put else o.on):
                held.add(called(o.category))
        return ", ".join(sorted(held))

    def gap(self, q):
        a, b = (self.objects[id] for id in self.told(q))
        return "yes" if self.flat(a, b) > 0.5 else "no"


def named(anew, value, options):
    """What an id or some are called among the options: the only one that names all their kinds, in order."""
    ids = [value] if isinstance(value, str) else value
    words = [called(anew.objects[id].category) for id in ids]
    fit = [option for option in options if len(parts := option.split(", ")) == len(words)
           and all(part == f"the {word}" or part.startswith(f"the {word} in ") for part, word in zip(parts, words))]
    return fit


@pytest.mark.parametrize("kind", sorted(qa.every_kind()))
def test_answers_worked_out_anew_are_the_same(seen, asked_of, large, asked_of_large, lived_in, asked_of_lived_in, kind):
    homes = [(Anew(*seen), asked_of), (Anew(*large), asked_of_large), (Anew(*lived_in), asked_of_lived_in)]
    pairs = [(anew, one) for anew, every in homes for one in every if one.kind == kind]
    for anew, question in pairs:
        value = getattr(anew, kind)(question)
        known = kind != "inside" and (not isinstance(value, str) or value in anew.objects)
        found = named(anew, value, question.options) if known else [value]
        assert question.value in found, (question, value)
        assert question.options[ord(question.answer) - 65] == question.value
    assert pairs or kind in ELSEWHERE


def test_what_is_inside_is_asked_where_all_of_it_is_seen(seen):
    """Things that a view shows side by side are said to hold one another."""
    home, views, _ = seen
    dealt = marks.dealt(views, (o.id for o in home.objects), seeds.lane(seeds.drawn(0, "qa"), "marks"))
    facts, holders = Facts(home, views, dealt), {}
    whole = {one.id for one in facts.marked if not TABLE[facts.objects[one.id].category].run}
    for view in facts.eyes:
        clear = [o for o in facts.clear(view.name) if o.id in facts.names and o.id not in {*holders, *holders.values()}]
        heads, rest = ([o for o in clear if (o.id in whole) == yes] for yes in (True, False))
        holders |= {held.id: holder.id for holder, held in zip(heads, rest)}
    put = [SimpleNamespace(**(vars(o) | {"in_": SimpleNamespace(object=holders[o.id])})) if o.id in holders else o
           for o in home.objects]
    stuffed = home.model_copy(update={"objects": put})
    found = qa.run(stuffed, views, QaConfig(kind=["inside"], each=12), seeds.drawn(0, "qa"))
    numbers = {thing.id: thing.number for thing in views.instances}
    shown = {view.name: {part.number for part in view.visible} for view in views.views}
    for one in found:
        held = [o for o in home.objects if holders.get(o.id, o.on) == one.evidence["object"]]
        assert one.value == ", ".join(sorted({called(o.category) for o in held}))
        assert all(any(numbers[o.id] in shown[name.removesuffix(".marks")] for name in one.images) for o in held)
    gone = {numbers[id] for id in holders}
    hidden = views.model_copy(update={"views": [view.model_copy(update={
        "visible": [part for part in view.visible if part.number not in gone]}) for view in views.views]})
    asked = qa.run(stuffed, hidden, QaConfig(kind=["inside"]), seeds.drawn(0, "qa"))
    assert found and not {one.evidence["object"] for one in asked} & set(holders.values())


def test_there_are_many_of_many_kinds(seen):
    home, views, _ = seen
    found = qa.run(home, views, QaConfig(), seeds.drawn(0, "qa"))
    assert len(found) >= 60 and len({one.kind for one in found}) >= 15


def test_what_is_asked_about_is_in_the_pictures(seen, asked_of):
    anew = Anew(*seen)
    for one in asked_of:
        ids = [v for value in one.evidence.values() for v in (value if isinstance(value, list) else [value])
               if v in anew.objects]
        for id in ids:
            assert any(anew.share(view, id) > 0 for view in one.images), (one, id)


def test_sizes_and_parts_are_asked_of_what_is_seen_nearly_whole_and_from_its_front(seen, asked_of):
    anew, many = Anew(*seen), 0
    for one in (one for one in asked_of if one.kind in ("object_size", "parts", "mechanism", "reach_out", "taller")):
        view = anew.views[one.images[0].removesuffix(".marks")]
        into = np.linalg.inv(np.array(view.pose))
        for o in (anew.objects[id] for id in anew.told(one)):
            heights = (o.center[2] - o.size[2] / 2, o.center[2] + o.size[2] / 2)
            points = np.array([(x, y, z, 1) for x, y in anew.corners(o) for z in heights]) @ into.T
            spans = np.ptp(points[:, :2] / points[:, 2:3], axis=0) * view.intrinsics[0]
            rows, columns = np.nonzero(anew.image(view.name) == anew.numbers[o.id])
            least = 0.71 if one.kind == "taller" else 0.84
            assert np.ptp(columns) + 1 > least * spans[0] and np.ptp(rows) + 1 > least * spans[1]
            way = np.array(view.pose)[:2, 3] - o.center[:2]
            assert one.kind == "taller" or not o.joints or cos(o.yaw) * way[0] + sin(o.yaw) * way[1] > o.size[0] / 2
            many += 1
    assert many > 20


def test_options_differ_and_letters_are_even(asked_of):
    for one in asked_of:
        assert len(set(one.options)) == len(one.options)
    kinds = defaultdict(Counter)
    for one in asked_of:
        kinds[one.kind, len(one.options)][one.answer] += 1
    right = sum(counts.most_common(1)[0][1] for counts in kinds.values())
    chance = sum(sum(counts.values()) / n for (_, n), counts in kinds.items())
    assert right / len(asked_of) <= chance / len(asked_of) + 0.09  # few of each kind: the largest of some draws


def test_the_same_seed_asks_the_same(seen):
    home, views, _ = seen
    first, again = (qa.lines(qa.run(home, views, QaConfig(), seeds.drawn(5, "qa")), "x") for _ in range(2))
    assert first == again


def test_lines_are_what_fine_tuning_reads(seen, asked_of):
    for row, one in zip(qa.lines(asked_of, "pictures").splitlines(), asked_of):
        line = json.loads(row)
        user, assistant = line["messages"]
        assert (user["role"], assistant["role"], assistant["content"]) == ("user", "assistant", one.answer)
        assert user["content"].count("<image>") == len(line["images"])
        assert {str(number): (x, y) for number, x, y in line["marks"]} == one.marks
        assert all((seen[2] / Path(path).name).is_file() for path in line["images"])


@pytest.mark.parametrize("seed", range(40))
def test_shared_answers_are_right_once_each(seed):
    rng = np.random.default_rng(seed)
    drafts = [Draft(f"q{k}", str(v), ["i"], {}) for k, v in enumerate(rng.integers(0, 6, 30))]
    found = asked("x", shared(drafts, rng, 8), rng)
    groups = defaultdict(list)
    for one in found:
        groups[tuple(sorted(one.options))].append(one.value)
    assert found and all(Counter(options) == Counter(set(values)) and len(set(Counter(values).values())) == 1
                         for options, values in groups.items())


@pytest.mark.parametrize("seed", range(40))
def test_balanced_answers_are_as_many_of_each(seed):
    rng = np.random.default_rng(seed)
    drafts = [Draft(f"q{k}", answer, ["i"], {}, ("no" if answer == "yes" else "yes",))
              for k, answer in enumerate(rng.choice(["yes", "no"], 20, p=[0.8, 0.2]))]
    counts = Counter(draft.answer for draft in balanced(drafts, rng, 6))
    assert not counts or counts["yes"] == counts["no"] > 0


@pytest.mark.parametrize("seed", range(40))
def test_each_of_what_is_compared_is_right_as_often_as_wrong(seed):
    rng = np.random.default_rng(seed)
    pairs = [rng.choice(6, 2, replace=False) for _ in range(40)]
    drafts = [Draft(f"{a} or {b}?", str(a), [f"view {k}"], {}, (str(b),)) for k, (a, b) in enumerate(pairs)]
    found = either_way(drafts, rng, 8)
    assert 2 <= len(found) <= 8 and len({id(draft) for draft in found}) == len(found)
    assert Counter(draft.answer for draft in found) == Counter(draft.wrong[0] for draft in found)
    ordered = [Draft("", str(max(a, b)), [], {}, (str(min(a, b)),)) for a, b in pairs]
    assert not either_way(ordered, rng, 8), "what always comes out the same is told by the words"


@pytest.mark.parametrize("seed", range(20))
def test_what_is_barred_is_no_answer(seed):
    rng = np.random.default_rng(seed)
    names = [str(k) for k in range(8)]
    drafts = [Draft(f"q{k}", str(a), ["i"], {}, barred=frozenset(rng.choice([n for n in names if n != str(a)], 2)))
              for k, a in enumerate(rng.integers(0, 8, 30))]
    found = shared(drafts, rng, 12)
    assert found and not [draft for draft in found if draft.barred & set(draft.wrong)]


def test_comparisons_and_fronts_are_even_in_a_home(asked_of):
    """What stands before a thing is never to be found by leaving out the thing itself."""
    right = Counter(one.value for one in asked_of if one.kind == "left_of")
    assert right == Counter(option for one in asked_of if one.kind == "left_of" for option in one.options
                            if option != one.value)
    for one in asked_of:
        if one.kind == "in_front":
            assert not [option for option in one.options if one.text.endswith(f"front of {option}?")]


NUMBERED = ("absolute_distance", "carried", "clearance", "gap", "mechanism", "object_size", "parts", "reach_out")
ROOMS = ("count", "doors", "doors_between", "lamps", "room_size", "route", "where", "windows")


def test_the_same_words_have_every_answer_as_often(seen):
    """But for the numbers in pictures, which are drawn."""
    home, views, _ = seen
    groups = defaultdict(Counter)
    for one in qa.run(home, views, QaConfig(kind=[*NUMBERED, *ROOMS, "seen"], each=20), seeds.drawn(7, "qa")):
        groups[one.kind, re.sub(r"marked \d+", "marked", one.text), frozenset(one.options)][one.value] += 1
    assert len({kind for kind, _, _ in groups}) >= 11
    for (_, _, options), right in groups.items():
        assert set(right) == options and len(set(right.values())) == 1


def test_numbers_are_drawn(seen):
    """So that the one of four things that is meant has each rank among them as often, within four errors."""
    home, views, _ = seen
    ranks = Counter()
    for seed in range(60):
        for one in qa.run(home, views, QaConfig(kind=["relative_distance"]), seeds.drawn(seed, "qa")):
            numbers = sorted(int(option.rsplit(" ", 1)[1]) for option in one.options)
            ranks[len(numbers), numbers.index(int(one.value.rsplit(" ", 1)[1]))] += 1
    for many in {many for many, _ in ranks}:
        counts = np.array([ranks[many, k] for k in range(many)])
        assert np.abs(counts - counts.mean()).max() <= 4 * np.sqrt(counts.sum() * (many - 1)) / many


def test_numbers_are_where_they_are_said_to_be(seen, tmp_path):
    """A mark lies on its thing, pictures differ at marks alone, and each number is there."""
    home, views, out = seen
    folder = tmp_path / "views"
    shutil.copytree(out, folder)
    asked = qa.run(home, views, QaConfig(), seeds.drawn(1, "qa"))
    qa.numbered(asked, folder)
    some = {one.images[0]: one.marks for one in asked if one.marks}
    assert some and all((folder / f"{name}.png").is_file() for name in some)
    anew = Anew(home, views, folder)
    for name, points in some.items():
        view = name.removesuffix(".marks")
        bare, drawn = (np.asarray(Image.open(folder / f"{n}.png")).astype(int) for n in (f"{view}.rgb", name))
        rows, columns = np.indices(bare.shape[:2])
        near = np.zeros(bare.shape[:2], bool)
        for x, y in points.values():
            disc = np.hypot(rows - y, columns - x) <= 4.7
            assert len(set(anew.image(view)[np.hypot(rows - y, columns - x) <= 3])) == 1
            assert (bare != drawn)[disc].any()
            near |= disc
        assert not (bare != drawn)[~near].any()
    assert all(line.split("  ")[1] for line in (folder / "SHA256SUMS").read_text().splitlines() if ".marks" in line)
