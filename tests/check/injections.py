"""Faults to put into right homes: each takes a walkable home's body as JSON holds it, and a generator.

It changes the body and gives ids that the judge has to name, any of them; None where the home has no place for it.
What is placed anew is worked out here alone.
"""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from shapely.geometry import Polygon

from apartgen.stages.things.categories import TABLE

Body = dict[str, Any]
Inject = Callable[[Body, np.random.Generator], list[str] | None]
KINDS: dict[str, tuple[set[str], Inject]] = {}
"""Every kind of fault: the codes of which one must be found, and what makes it."""


def kind(*codes: str) -> Callable[[Inject], Inject]:
    def register(inject: Inject) -> Inject:
        KINDS[inject.__name__] = set(codes), inject
        return inject

    return register


def one(rows: list[Any], rng: np.random.Generator) -> Any:
    return rows[int(rng.integers(len(rows)))] if rows else None


def place(o: Body) -> str:
    return TABLE[o["category"]].place


def hard(body: Body, *places: str) -> list[Body]:
    """Objects that do not give way, of these places or all."""
    return [o for o in body["objects"] if not TABLE[o["category"]].soft and place(o) != "flat"
            and (not places or place(o) in places)]


def bottom(o: Body) -> float:
    return o["center"][2] - o["size"][2] / 2


def carries(body: Body, o: Body) -> bool:
    """Whether anything might stand on it."""
    return any(abs(bottom(p) - bottom(o) - o["size"][2]) < 0.05 for p in body["objects"])


def openings(body: Body, *kinds: str) -> list[Body]:
    return [o for o in body["openings"] if o["kind"] in kinds]


def inwards(body: Body, o: Body) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Middle of an opening, the direction along it, and the one into the room that its leaf, or it, opens to."""
    a, b = np.array(o["segment"])
    along = (b - a) / np.hypot(*(b - a))
    room = o.get("into") or o["rooms"][0]
    normal = np.array([-along[1], along[0]])
    polygon = Polygon(next(r["polygon"] for r in body["rooms"] if r["id"] == room))
    return (a + b) / 2, along, max((normal, -normal), key=lambda n: polygon.intersection(
        Polygon([a, b, b + n, a + n])).area)


def chest(body: Body, room: str, at: np.ndarray, side: float = 0.45) -> Body:
    """A box with nothing that moves."""
    it = {"id": "intruder_1", "room": room, "category": "pouffe", "center": [*map(float, at), 0.21],
          "size": [side, side, 0.42], "yaw": 0.0, "asset": {"library": "parametric", "id": "x"}, "joints": []}
    body["objects"].append(it)
    return it


# The plan


@kind("rooms-overlap")
def a_room_is_grown(body, rng):
    room = one([r for r in body["rooms"] if len(body["rooms"]) > 1], rng)
    if room is None:
        return None
    grown = Polygon(room["polygon"]).buffer(0.5, join_style="mitre")  # balconies stand a thick wall apart
    room["polygon"] = [list(p) for p in grown.exterior.coords[:-1]]
    if not grown.exterior.is_ccw:
        room["polygon"].reverse()
    return [room["id"]]


@kind("inconsistent")
def an_outline_crosses_itself(body, rng):
    polygon = one(body["rooms"], rng)["polygon"]
    polygon[0], polygon[1] = polygon[1], polygon[0]
    return None if Polygon(polygon).is_valid else []


@kind("inconsistent")
def an_outline_runs_clockwise(body, rng):
    one(body["rooms"], rng)["polygon"].reverse()
    return []


@kind("inconsistent")
def two_things_have_one_id(body, rng):
    a, b = rng.choice(len(body["objects"]), 2, replace=False)
    body["objects"][a]["id"] = body["objects"][b]["id"]
    return []


@kind("inconsistent")
def a_thing_is_in_no_room(body, rng):
    one(body["objects"], rng)["room"] = "attic_1"
    return []


@kind("inconsistent")
def a_door_leads_nowhere(body, rng):
    door = one(openings(body, "door"), rng)
    if door is None:
        return None
    door["rooms"][1] = "attic_1"
    return []


@kind("inconsistent")
def a_thing_is_miles_away(body, rng):
    one(body["objects"], rng)["center"][0] = 1e12
    return []


@kind("no-entrance")
def the_entrance_is_gone(body, rng):
    body["openings"] = [o for o in body["openings"] if o["kind"] != "entrance"]
    return []


@kind("opening-width")
def a_door_is_30_m_wide(body, rng):
    door = one(openings(body, "door", "entrance"), rng)
    mid, along, _ = inwards(body, door)
    door["segment"] = [list(mid - 15 * along), list(mid + 15 * along)]
    return [door["id"]]


@kind("opening-width")
def a_door_is_too_narrow(body, rng):
    door = one(openings(body, "door", "entrance"), rng)
    mid, along, _ = inwards(body, door)
    door["segment"] = [list(mid - 0.2 * along), list(mid + 0.2 * along)]
    return [door["id"]]


@kind("opening-height")
def a_door_is_too_low(body, rng):
    door = one(openings(body, "door", "entrance"), rng)
    door["head"] = float(rng.uniform(0.5, 1.8))
    return [door["id"]]


@kind("opening-height")
def an_opening_is_higher_than_the_storey(body, rng):
    it = one(body["openings"], rng)
    it["head"] = body["height"] + float(rng.uniform(0.05, 2))
    return [it["id"]]


@kind("opening-height")
def a_door_has_a_sill(body, rng):
    it = one(openings(body, "door", "entrance"), rng)
    it["sill"] = float(rng.uniform(0.15, 0.6))
    return [it["id"]]


@kind("not-in-wall")
def an_opening_stands_in_a_room(body, rng):
    it = one(body["openings"], rng)
    _, _, normal = inwards(body, it)
    it["segment"] = [list(np.array(p) + 0.8 * normal) for p in it["segment"]]
    return [it["id"]]


@kind("not-in-wall", "not-outside")
def an_opening_leads_to_another_room(body, rng):
    it = one(openings(body, "door", "opening"), rng)
    others = [r["id"] for r in body["rooms"] if it and r["id"] not in it["rooms"]]
    if not others:
        return None
    it["rooms"][1], it["into"] = one(others, rng), None
    return [it["id"]]


@kind("cut-off", "no-link")
def a_door_is_walled_up(body, rng):
    doors = openings(body, "door", "opening")
    links = {frozenset(link) for link in [*body["program"]["links"], *body["program"]["open_links"]]}
    pairs = [frozenset(o["rooms"]) for o in doors]
    door = one([o for o, pair in zip(doors, pairs) if pair in links and pairs.count(pair) == 1], rng)
    if door is None:
        return None
    body["openings"].remove(door)
    return door["rooms"]


@kind("openings-cross")
def two_openings_are_at_one_place(body, rng):
    it = one(body["openings"], rng)
    body["openings"].append(it | {"id": "second_1"})
    return [it["id"]]


@kind("not-outside")
def a_window_looks_into_a_room(body, rng):
    types = {r["id"]: r["type"] for r in body["rooms"]}
    doors = [o for o in openings(body, "door") if "balcony" not in [types[r] for r in o["rooms"]]]
    it = one(doors, rng)
    if it is None:
        return None
    more = {"id": "window_x", "kind": "window", "rooms": [it["rooms"][0]], "into": None, "sill": 2.15, "head": 2.5}
    body["openings"].append(it | more)
    return ["window_x"]


@kind("not-outside")
def the_entrance_leads_from_a_room(body, rng):
    it = one(openings(body, "door"), rng)
    if it is None:
        return None
    it["kind"], it["rooms"] = "entrance", [it["into"]]
    return [it["id"]]


@kind("ceiling")
def the_ceiling_is_15_m_high(body, rng):
    body["height"] = 15.0
    return []


@kind("not-built")
def a_room_is_missing(body, rng):
    body["program"]["rooms"].append({"id": "closet_9", "type": "closet"})
    return ["closet_9"]


@kind("area")
def a_room_is_a_cupboard(body, rng):
    room = one(body["rooms"], rng)
    x, y = room["polygon"][0]
    room["polygon"] = [[x, y], [x + 0.4, y], [x + 0.4, y + 0.4], [x, y + 0.4]]
    return [room["id"]]


# The furniture


@kind("storey")
def a_thing_is_under_the_floor(body, rng):
    o = one(body["objects"], rng)
    o["center"][2] = o["size"][2] / 2 - float(rng.uniform(0.05, 2))
    return [o["id"]]


@kind("storey")
def a_thing_is_above_the_ceiling(body, rng):
    o = one(body["objects"], rng)
    o["center"][2] = body["height"] - o["size"][2] / 2 + float(rng.uniform(0.05, 2))
    return [o["id"]]


@kind("outside")
def a_thing_is_in_the_wall(body, rng):
    o = one(body["objects"], rng)
    polygon = np.array(next(r["polygon"] for r in body["rooms"] if r["id"] == o["room"]))
    k = int(rng.integers(len(polygon)))
    a, b = polygon[k], polygon[(k + 1) % len(polygon)]
    o["center"][:2] = map(float, (a + b) / 2)
    return [o["id"]]


@kind("outside")
def a_thing_is_in_another_room(body, rng):
    o, room = one(body["objects"], rng), one(body["rooms"], rng)
    if room["id"] == o["room"]:
        return None
    at = Polygon(room["polygon"]).representative_point()
    o["center"][:2] = [at.x, at.y]
    return [o["id"]]


@kind("size")
def a_thing_is_a_giant(body, rng):
    o = one(body["objects"], rng)
    k = int(rng.integers(3))
    o["size"][k] = TABLE[o["category"]].max[k] * float(rng.uniform(3.2, 10))
    return [o["id"]]


@kind("size")
def a_thing_is_a_toy(body, rng):
    o = one(body["objects"], rng)
    k = int(rng.integers(3))
    o["size"][k] = TABLE[o["category"]].min[k] / float(rng.uniform(3.2, 10))
    return [o["id"]]


@kind("overlap")
def a_thing_is_there_twice(body, rng):
    o = one(hard(body), rng)
    body["objects"].append(o | {"id": "twin_1", "center": [o["center"][0] + 0.02, *o["center"][1:]]})
    return [o["id"]]


@kind("overlap")
def a_thing_stands_in_another(body, rng):
    o = one(hard(body, "floor"), rng)
    others = [p for p in hard(body, "floor") if o and p["room"] == o["room"] and p is not o
              and o["category"] not in TABLE[p["category"]].belongs
              and p["category"] not in TABLE[o["category"]].belongs]
    other = one(others, rng)
    if other is None:
        return None
    o["center"][:2] = [c + float(rng.uniform(-0.05, 0.05)) for c in other["center"][:2]]
    return [o["id"]]


@kind("overlap")
def a_partner_is_pushed_too_far(body, rng):
    pairs = [(o, p) for o in hard(body, "floor") for p in hard(body, "floor")
             if o["room"] == p["room"] and p["category"] in TABLE[o["category"]].belongs
             and TABLE[p["category"]].back and not TABLE[p["category"]].kneehole]
    pair = one(pairs, rng)
    if pair is None:
        return None
    pair[0]["center"][:2] = pair[1]["center"][:2]
    return [pair[0]["id"]]


@kind("overlap")
def a_chair_stands_the_wrong_way_round(body, rng):
    pairs = [(o, p) for o in hard(body, "floor") for p in hard(body, "floor") if o["room"] == p["room"]
             and o["category"] in ("chair", "office_chair") and p["category"] in TABLE[o["category"]].belongs
             and o["size"][2] > p["size"][2] + 0.02]
    pair = one(pairs, rng)
    if pair is None:
        return None
    chair, table = pair
    way = np.array([math.cos(chair["yaw"]), math.sin(chair["yaw"])]) * 0.42 * chair["size"][0]
    chair["center"][:2] = map(float, np.array(table["center"][:2]) + way)  # its back is in the table's middle
    return [chair["id"]]


@kind("unsupported")
def a_thing_floats(body, rng):
    o = one(hard(body, "floor"), rng)
    o["center"][2] += float(rng.uniform(0.03, 0.2))
    return None if stands_by_chance(body, o) else [o["id"]]


@kind("unsupported")
def a_lamp_floats_over_its_table(body, rng):
    o = one([o for o in hard(body, "top") if bottom(o) > 0.1], rng)
    if o is None or not TABLE[o["category"]].place == "top" or at_a_wall(body, o):
        return None
    o["center"][2] += float(rng.uniform(0.03, 0.2))
    return None if stands_by_chance(body, o) else [o["id"]]


@kind("unsupported")
def a_picture_leaves_its_wall(body, rng):
    o = one([o for o in hard(body, "wall") if bottom(o) > 0.1], rng)
    if o is None:
        return None
    way = np.array([math.cos(o["yaw"]), math.sin(o["yaw"])]) * float(rng.uniform(0.08, 0.3))
    o["center"][:2] = map(float, np.array(o["center"][:2]) + way)
    return None if stands_by_chance(body, o) or at_a_wall(body, o) else [o["id"]]


@kind("unsupported")
def a_ceiling_lamp_falls(body, rng):
    o = one(hard(body, "ceiling"), rng)
    if o is None:
        return None
    o["center"][2] -= float(rng.uniform(0.05, 0.5))
    return None if stands_by_chance(body, o) else [o["id"]]


@kind("not-on")
def what_carries_a_thing_is_untrue(body, rng):
    o = one(body["objects"], rng)
    others = {"floor", "ceiling", *(p["id"] for p in body["objects"])} - {o["on"], o["id"]}
    if bottom(o) < 0.1 or o["center"][2] + o["size"][2] / 2 > body["height"] - 0.1:
        others -= {"floor", "ceiling"}
    o["on"] = one(sorted(others), rng)
    return [o["id"]]


def stands_by_chance(body: Body, o: Body) -> bool:
    """Whether it has come upon something, or below the ceiling."""
    tops = [p["center"][2] + p["size"][2] / 2 for p in body["objects"] if p is not o and p["room"] == o["room"]]
    high = o["center"][2] + o["size"][2] / 2
    return any(abs(top - bottom(o)) < 0.03 for top in tops) or high > body["height"] - 0.03


def at_a_wall(body: Body, o: Body) -> bool:
    """Whether any wall is nearer than a hand."""
    polygon = Polygon(next(r["polygon"] for r in body["rooms"] if r["id"] == o["room"]))
    c, s = math.cos(o["yaw"]), math.sin(o["yaw"])
    d, w = o["size"][0] / 2, o["size"][1] / 2
    x, y = o["center"][:2]
    signs = ((1, 1), (-1, 1), (-1, -1), (1, -1))
    mark = Polygon([(x + c * i * d - s * j * w, y + s * i * d + c * j * w) for i, j in signs])
    return mark.distance(polygon.exterior) < 0.05


# What opens, and ways


@kind("door-blocked")
def a_door_meets_a_box(body, rng):
    it = one([o for o in openings(body, "door", "entrance") if o.get("into")], rng)
    mid, along, normal = inwards(body, it)
    width = math.dist(*it["segment"])
    pivot, other = np.array(it["segment"])[[it["hinge"], 1 - it["hinge"]]]
    turn = float(rng.uniform(0.2, 1.37))
    at = pivot + 0.15 * normal + 0.7 * width * (math.cos(turn) * (other - pivot) / width + math.sin(turn) * normal)
    chest(body, it["into"], at)
    return ["intruder_1"]


@kind("way-blocked", "door-blocked")
def a_box_stands_in_a_doorway(body, rng):
    it = one(openings(body, "door", "entrance"), rng)
    mid, _, normal = inwards(body, it)
    chest(body, it["into"], mid + 0.25 * normal)
    return ["intruder_1"]


@kind("part-blocked")
def a_box_stands_before_what_opens(body, rng):
    joints = [(o, j) for o in hard(body, "floor") for j in o["joints"] if j.get("extent") and bottom(o) < 0.1
              and j["part"] in ("hinge_door", "slider_drawer") and abs(j["axis"][1]) < 0.1
              and o["center"][2] + j["extent"][0][2] < 0.3]
    pair = one(joints, rng)
    if pair is None:
        return None
    o, joint = pair
    (x0, y0, _), (x1, y1, _) = joint["extent"]
    c, s = math.cos(o["yaw"]), math.sin(o["yaw"])
    x, y = x1 + 0.08 + 0.2, (y0 + y1) / 2
    chest(body, o["room"], np.array([o["center"][0] + c * x - s * y, o["center"][1] + s * x + c * y]), 0.4)
    return ["intruder_1"]


@kind("part-blocked")
def a_drawer_goes_through_the_wall(body, rng):
    pair = one([(o, j) for o in hard(body) for j in o["joints"] if j["type"] == "slide" and j.get("extent")
                and j["part"] == "slider_drawer"], rng)
    if pair is None:
        return None
    pair[1]["range"] = [0.0, 9.5]
    return [pair[0]["id"]]


@kind("joint")
def a_part_does_not_open(body, rng):
    pair = one([(o, j) for o in body["objects"] for j in o["joints"]], rng)
    if pair is None:
        return None
    pair[1]["range"] = [0.0, 0.0]
    return [pair[0]["id"]]


@kind("unreached")
def a_room_is_crammed(body, rng):
    """Stools a robot can't pass between, wherever there is floor."""
    rooms = {o["room"] for o in body["objects"] if o["joints"] and place(o) == "floor"}
    room = one(sorted(rooms), rng)
    if room is None:
        return None
    polygon = Polygon(next(r["polygon"] for r in body["rooms"] if r["id"] == room))
    x0, y0, x1, y1 = polygon.bounds
    for i, x in enumerate(np.arange(x0 + 0.25, x1, 0.55)):
        for j, y in enumerate(np.arange(y0 + 0.25, y1, 0.55)):
            stool = chest(body, room, np.array([x, y]), 0.35)
            stool["id"] = f"intruder_{i}_{j}"
    return [room, *(o["id"] for o in body["objects"] if o["room"] == room)]


# What was asked for


@kind("count")
def one_more_was_asked_for(body, rng):
    o = one(body["objects"], rng)
    have = sum(p["room"] == o["room"] and p["category"] == o["category"] for p in body["objects"])
    body["program"]["objects"].append({"room": o["room"], "category": o["category"], "count": have + 1})
    return [o["room"]]


@kind("count")
def none_was_asked_for(body, rng):
    o = one(body["objects"], rng)
    wishes = [w for w in body["program"]["objects"] if (w["room"], w["category"]) == (o["room"], o["category"])]
    if wishes:
        return None
    body["program"]["objects"].append({"room": o["room"], "category": o["category"], "count": 0})
    return [o["room"]]


@kind("count")
def another_number_was_asked_for(body, rng):
    room = one(body["rooms"], rng)["id"]
    have = sum(o["room"] == room for o in body["objects"])
    body["program"]["counts"] = {room: have + int(rng.choice([-1, 1])) if have else 1}
    return [room]
