"""What is asked of pictures is beyond doubt: by views made up by hand of a flat of two rooms."""

from math import pi

import handmade as h
import numpy as np
import pytest

from apartgen.schemas.render import Instance, Render, View, Visible
from apartgen.schemas.retrieve import Joint
from apartgen.stages import qa, seeds
from apartgen.stages.qa import fronts, plain
from apartgen.stages.qa.config import QaConfig
from apartgen.stages.qa.facts import Facts
from apartgen.stages.qa.kinds import appearance_order, count, direction, in_front, left_of, nearer, route, where
from apartgen.stages.retrieve.furniture import looks as looks_of_furniture
from apartgen.stages.things.categories import TABLE
from apartgen.stages.things.names import alike

SIDE = 100
LEVEL = ((1, 0, 0, 2), (0, 0, 1, 1.5), (0, -1, 0, 1.2), (0, 0, 0, 1))


def facts(shown, objects, kind="eye", room=h.LIVING):
    """Facts of views, each told as pixels and rectangles by id; `floor_ROOM` is a room's own."""
    ids = [*(o.id for o in objects), f"floor_{h.LIVING}", f"floor_{h.BEDROOM}"]
    rooms = {o.id: o.room for o in objects} | {f"floor_{room}": room for room in (h.LIVING, h.BEDROOM)}
    boxed = {o.id: (*o.center, *o.size, o.yaw) for o in objects}
    things = [Instance(number=k, id=id, category="", label=1, room=rooms[id], box=boxed.get(id))
              for k, id in enumerate(ids, 1)]
    views = [View(name=f"{kind}_{k}", kind=kind, room=room, width=SIDE, height=SIDE, pose=LEVEL,
                  intrinsics=None if kind == "panorama" else (60, 60, 50, 50),
                  visible=[Visible(number=ids.index(id) + 1, pixels=pixels, rectangle=rectangle)
                           for id, (pixels, rectangle) in one.items()]) for k, one in enumerate(shown)]
    return Facts(h.home(*objects), Render(views=views, instances=things))


ALL = (0, 0, SIDE, SIDE)
BED = h.thing("double_bed", 5.5, 1.5, room=h.BEDROOM)
SOFA, CURTAIN = h.thing("sofa", 1, 1), h.thing("curtain", 2, 2.9)


@pytest.mark.parametrize(("own", "yes"), [(9000, True), (5000, False), (0, False)])
def test_a_picture_is_of_the_room_that_it_shows(own, yes):
    found = facts([{f"floor_{h.LIVING}": (own, ALL), f"floor_{h.BEDROOM}": (10_000 - own, ALL)}], [SOFA])
    assert plain.in_its_room(found, found.views["eye_0"]) == yes
    asked = qa.run(found.home, found.render, QaConfig(kind=["where", "doors_between", "route"]), seeds.drawn(0, "qa"))
    assert not asked, "one view has no others to be told from"


def test_a_picture_may_be_of_every_room_that_may_have_what_it_shows():
    """A hundredth of it tells."""
    found = facts([{CURTAIN.id: (900, ALL)}, {CURTAIN.id: (900, ALL), BED.id: (900, ALL)}, {BED.id: (90, ALL)},
                   {BED.id: (110, ALL)}], [BED, CURTAIN])
    could = [plain.could_be(found, view) for view in found.eyes]
    assert could == [{"living room", "bedroom"}, {"bedroom"}, {"living room", "bedroom"}, {"bedroom"}]


@pytest.mark.parametrize(("pixels", "rectangle", "yes"), [
    (400, (10, 10, 20, 20), True), (4, (10, 10, 2, 2), False), (400, (0, 10, SIDE, 20), False)])
def test_what_is_counted_is_seen_well_and_in_one_piece(pixels, rectangle, yes):
    found = facts([{SOFA.id: (pixels, rectangle)}], [SOFA], "panorama")
    assert plain.countable(found, "panorama_0", [SOFA.id]) == yes


@pytest.mark.parametrize(("before", "after", "way"), [(10, 60, 1), (60, 10, -1), (40, 42, 0)])
def test_what_stays_in_sight_tells_how_a_camera_turned(before, after, way):
    shown = [{o.id: (900, (x, 10, 30, 30)) for o in (SOFA, CURTAIN)} for x in (before, after)]
    found = facts(shown, [SOFA, CURTAIN])
    move = plain.shifted(found, *found.eyes)
    assert (move is None) if way == 0 else move is not None and np.sign(move) == way
    assert plain.shifted(found, found.eyes[0], found.eyes[0].model_copy(update={"visible": []})) is None


def test_tables_and_curtains_have_no_front():
    things = [BED, SOFA, CURTAIN, *(h.thing(name, 1, 2) for name in ("dining_table", "coffee_table", "chest", "desk"))]
    found = facts([], things)
    assert {TABLE[o.category].name for o in things if plain.fronted(found, o.id)} == {"sofa", "chest", "desk"}


def flap(k):
    return Joint(name=f"flap_{k}", type="hinge", axis=(0, 1, 0), origin=(0, 0, 0), range=(0, pi / 3), part="hinge_door")


def test_what_looks_like_what_opens_otherwise_is_not_asked_for_it():
    leaf = Joint(name="leaf", type="hinge", axis=(0, 0, 1), origin=(0, 0, 0), range=(0, pi / 2), part="hinge_door")
    cases = [("shoe_cabinet", (flap(0), flap(1)), True), ("dishwasher", (flap(0),), True), ("oven", (flap(0),), False),
             ("wardrobe", (leaf,), True), ("sliding_wardrobe", (), True), ("fridge", (leaf,), False)]
    for name, joints, yes in cases:
        assert plain.hides_how(h.thing(name, 1, 1, joints=joints)) == yes, name


@pytest.mark.parametrize(("one", "other", "yes"), [
    ("vanity", "kitchen_sink", True), ("desk", "dining_table", True), ("sofa", "double_bed", False),
    ("mirror", "picture", True), ("mirror", "wall_shelf", False), ("plant", "succulent", True)])
def test_things_of_one_look_are_not_told_apart_by_name(one, other, yes):
    assert alike(one, other) == yes == alike(other, one)


def test_nobody_turns_to_what_hangs_overhead(monkeypatch):
    some = [h.thing(name, x, y) for name, x, y in (("sofa", 0.6, 0.6), ("bookshelf", 3.4, 0.6), ("plant", 0.6, 2.4))]
    lamp = h.thing("ceiling_lamp", 2, 1.5)
    monkeypatch.setattr(Facts, "uncut", lambda self, view, least: set(self.shares[view]) & set(self.objects))
    found = facts([{o.id: (900, ALL) for o in (*some, lamp)}], [*some, lamp])
    monkeypatch.setattr(direction, "shared", lambda drafts, rng, most: drafts)
    asked = [draft.evidence for draft in direction.ask(found, np.random.default_rng(0), 99)]
    assert asked and not any(one["facing"] == lamp.id for one in asked)
    assert any(one["of"] == lamp.id for one in asked), "where it is one may be asked"


def test_mirrors_are_not_counted(monkeypatch):
    some = [h.thing("mirror", 1, 1), h.thing("plant", 3, 2)]
    found = facts([{o.id: (900, (10, 10, 30, 30)) for o in some}], some, "panorama")
    monkeypatch.setattr(count, "shared", lambda drafts, rng, most: drafts)
    assert {draft.evidence["kind"] for draft in count.ask(found, np.random.default_rng(0), 99)} == {"plant"}


def test_only_what_is_large_is_named():
    large, small = h.thing("plant", 1, 1, size=(0.4, 0.4, 0.9)), h.thing("plant", 2, 1, size=(0.2, 0.2, 0.2))
    assert facts([], [large]).names and not facts([], [small]).names


def test_numbers_are_on_what_one_can_mean_by_them():
    """Not on a curtain, whose halves hang apart, nor on lamps side by side on a table that look like one."""
    table = h.thing("dining_table", 2, 1.5, id="table")
    lamps = [h.thing("table_lamp", 2 + 0.3 * k, 1.5, size=(0.2, 0.2, 0.3), id=f"lamp_{k}") for k in (0, 1, 3)]
    for lamp in lamps:
        lamp.on = table.id
    chairs = [h.thing("chair", 1 + 0.5 * k, 2.5, size=(0.5, 0.5, 0.9), id=f"chair_{k}") for k in range(2)]
    assert plain.told_apart(h.home(CURTAIN, table, *lamps, *chairs)) == ["table", "lamp_3", "chair_0", "chair_1"]


def test_styles_whose_fronts_one_cannot_count_are_those_that_the_furniture_has():
    blank = {style for style, looks in looks_of_furniture._LOOKS.items()
             if any(look.profile == "fluted" and look.handle == "none" for look in looks)}
    assert blank == set(plain.BLANK)


@pytest.mark.parametrize(("category", "id", "yes"), [
    ("tv_stand", "tv_stand/midcentury/400x1400x400/0", True), ("tv_stand", "tv_stand/modern/400x1400x400/0", False),
    ("dishwasher", "dishwasher/modern/600x600x900/0", True), ("oven", "oven/modern/600x600x900/0", False)])
def test_how_it_opens_is_not_asked_of_what_does_not_show_it(category, id, yes):
    joint = Joint(name="a", type="hinge", axis=(0, 0, 1), origin=(0, 0, 0), range=(0, 1), part="hinge_door")
    o = h.thing(category, 1, 1, joints=(joint,))
    o.asset = o.asset.model_copy(update={"library": "parametric", "id": id})
    assert plain.hides_how(o) == yes


def _ahead(*more):
    """A sofa that looks east, a table before it, two things aside, and what else is in the picture."""
    sofa = h.thing("sofa", 0.5, 1, size=(0.9, 1.6, 0.8), id="sofa")
    table = h.thing("coffee_table", 2, 1, size=(0.8, 1.8, 0.4), id="table")
    aside = [h.thing("plant", 3.5, 2.5, id="plant"), h.thing("bookshelf", 3.5, 0.2, id="shelf")]
    return [sofa, table, *aside, *more]


@pytest.mark.parametrize(("share", "asked"), [(0.4, True), (0.2, False)])
def test_what_is_met_is_no_rug_and_no_scrap_at_the_edge(monkeypatch, share, asked):
    """All is seen whole but the table, of which this share is in sight."""
    things = _ahead(h.thing("rug", 2, 1, size=(2.0, 2.4, 0.01), id="rug"))
    monkeypatch.setattr(Facts, "uncut", lambda self, view, least: {
        o.id for o in things if o.id != "table" or share > least})
    found = facts([{o.id: (800, ALL) for o in things}], things)
    found = Facts(found.home, found.render, {"eye_0": {o.id: k for k, o in enumerate(things, 1)}})
    drafts = [d for d in in_front.ask(found, np.random.default_rng(0), 8) if d.evidence["object"] == "sofa"]
    assert bool(drafts) == asked
    assert all(d.answer == "the thing marked 2" and "the thing marked 5" not in d.wrong for d in drafts)


@pytest.mark.parametrize(("further", "met"), [(0.0, None), (0.04, None), (-0.04, None), (0.08, "table")])
def test_what_is_met_first_is_met_first_beyond_doubt(further, met):
    """A lamp before the sofa's side as near as the table before its middle, or a little nearer or further."""
    things = _ahead(h.thing("floor_lamp", 1.7 + further, 1.65, size=(0.2, 0.2, 1.6), id="lamp"))
    things[1].size = (0.8, 0.9, 0.4)
    ahead = fronts.before(facts([{o.id: (800, ALL) for o in things}], things), "sofa", (0.0,))
    assert (ahead and ahead[1]) == met
    assert ahead is None or ahead[0] == pytest.approx(0.65)


@pytest.mark.parametrize(("pixels", "seen"), [(50, True), (5, False)])
def test_a_way_is_asked_for_where_the_entrance_is_seen_from_above(pixels, seen):
    entrance = next(o for o in h.openings() if o.kind == "entrance")
    view = View(name="above", kind="above", room="", width=SIDE, height=SIDE, pose=LEVEL,
                visible=[Visible(number=1, pixels=pixels, rectangle=(0, 0, 9, 9))])
    things = [Instance(number=1, id=entrance.id, category="", label=1, room=h.LIVING)]
    assert route._seen(Facts(h.home(SOFA), Render(views=[view], instances=things)), entrance) == seen


def test_a_place_is_told_by_two_things_of_its_room(monkeypatch):
    shelf = h.thing("bookshelf", 3, 1.5, size=(0.3, 0.8, 1.8), id="shelf")
    monkeypatch.setattr(Facts, "uncut", lambda self, view, least: set(self.shares[view]) & set(self.objects))
    one = {f"floor_{h.LIVING}": (5000, ALL), SOFA.id: (800, ALL)}
    found = facts([one, one | {"shelf": (800, ALL)}], [SOFA, shelf])
    assert [plain.tells_its_place(found, view) for view in found.eyes] == [False, True]


@pytest.mark.parametrize(("goal", "turns"), [
    ((6.5, 1.45), ["straight on", "straight on"]), ((5.0, 2.0), []), ((4.4, 2.95), ["straight on", "left"])])
def test_a_way_leads_to_where_a_picture_may_have_been_taken(goal, turns):
    """From the entrance through the door at (4.05, 1.45): ahead of it, aside, and neither for sure."""
    entrance, door = (next(o for o in h.openings() if o.kind == kind) for kind in ("entrance", "door"))
    found = Facts(h.home(SOFA), Render(views=[], instances=[]))
    assert route._sure(found, [entrance, door], goal, h.LIVING) == turns


def test_how_far_a_thing_is_from_the_camera_by_hand():
    """The eye at (2, 1.5, 1.2); a block over x 2.5-3.5 and y .3-1.3 whose top is at .5 m."""
    block = h.thing("coffee_table", 3.0, 0.8, size=(1.0, 1.0, 0.5))
    found = facts([{block.id: (500, ALL)}], [block])
    assert nearer._far(found, found.eyes[0], block.id) == pytest.approx(np.sqrt(0.5**2 + 0.2**2 + 0.7**2))


def test_left_and_right_are_each_others_mirror_images():
    turns = {name: (low, high) for name, low, high in route.SIDES}
    for name, other in (("left", "right"), ("straight on", "straight on")):
        assert turns[name] == tuple(-end for end in turns[other][::-1])


def test_the_words_do_not_tell_in_what_kind_of_picture_a_room_is(monkeypatch):
    """Panoramas are of every room, other pictures of few bathrooms: words that told them apart would tell the room."""
    shown = {SOFA.id: (900, ALL), f"floor_{h.LIVING}": (9000, ALL)}
    monkeypatch.setattr(where, "shared", lambda drafts, rng, most: drafts)
    texts = {draft.text for kind in ("eye", "panorama")
             for draft in where.ask(facts([shown], [SOFA], kind), np.random.default_rng(0), 9)}
    assert len(texts) == 1


@pytest.mark.parametrize(("y", "far", "yes"), [(1.45, 2.6, True), (2.6, 2.6, False), (1.45, 1.0, False)])
def test_how_far_it_is_to_a_wall_is_not_asked_where_a_door_is(y, far, yes):
    """The door at (4.05, 1.45) in the east wall, from a cabinet that looks east."""
    cabinet = h.thing("sideboard", 1.2, y, size=(0.4, 0.6, 0.8), id="cabinet")
    assert fronts.parted(facts([{"cabinet": (900, ALL)}], [cabinet]), "cabinet", far) == yes


@pytest.mark.parametrize(("x", "yes"), [(2.0, True), (2.9, True), (3.6, False)])
def test_what_stands_on_a_rug_is_not_asked_what_carries_it(x, yes):
    """A rug over x 1 to 3; half of a table that is .8 m deep is .4."""
    table, rug = h.thing("coffee_table", x, 1, size=(0.8, 0.8, 0.4), id="table"), h.thing("rug", 2, 1, id="rug")
    rug.size = (2.0, 2.0, 0.01)
    assert plain.on_a_rug(facts([{"table": (900, ALL)}], [table, rug]), "table") == yes


@pytest.mark.parametrize(("rectangle", "yes"), [
    ((10, 10, 80, 80), False), ((1, 1, 80, 80), False), ((0, 10, 80, 80), True), ((10, 0, 80, 80), True),
    ((20, 10, 80, 80), True), ((10, 20, 80, 80), True)])
def test_lengths_are_asked_of_what_no_edge_of_the_picture_cuts(rectangle, yes):
    assert plain.at_edge(facts([{SOFA.id: (900, rectangle)}], [SOFA]), SOFA.id, "eye_0") == yes


def test_a_number_among_books_could_mean_one_of_them():
    shelf = h.thing("bookshelf", 3, 1.5, size=(0.3, 0.8, 1.8), id="shelf")
    assert plain.told_apart(h.home(SOFA, shelf)) == [SOFA.id]


@pytest.mark.parametrize(("known", "found"), [
    ({"a": {"bed", "desk", "sofa"}, "b": {"bed"}}, ["a"]), ({"a": {"bed", "desk"}, "b": {"sofa", "desk"}}, ["a", "b"]),
    ({"a": {"bed", "desk"}, "b": {"sofa"}}, []), ({"a": {"bed"}, "b": {"desk"}, "c": {"sofa"}}, [])])
def test_two_pictures_have_a_thing_in_common(known, found):
    assert direction._pictures(known, ("bed", "desk", "sofa")) == found


@pytest.mark.parametrize(("desk", "lamp", "yes"), [
    ((0, 40), (60, 90), True), ((10, 50), (45, 95), True), ((0, 90), (60, 85), False),
    ((0, 40), (12, 52), False), ((0, 40), (18, 58), True)])
def test_left_is_asked_of_what_is_left_at_both_ends_by_a_seventh_of_the_picture(monkeypatch, desk, lamp, yes):
    things = [h.thing("desk", 1, 1, id="desk"), h.thing("floor_lamp", 3, 1, id="lamp")]
    spans = {"desk": desk, "lamp": lamp}
    monkeypatch.setattr(Facts, "alone", lambda self, view: {"the desk": things[0], "the floor lamp": things[1]})
    monkeypatch.setattr(left_of, "either_way", lambda drafts, rng, most: drafts)
    found = facts([{id: (900, (low, 10, high - low, 50)) for id, (low, high) in spans.items()}], things)
    assert bool(left_of.ask(found, np.random.default_rng(0), 8)) == yes


@pytest.mark.parametrize(("doors", "asked"), [(1, True), (3, True), (4, False)])
def test_a_way_has_three_doors_at_most_behind_the_entrance(monkeypatch, doors, asked):
    """Of two places in pictures, to the left and to the right, so that each answer is the other's wrong one."""
    found = facts([{SOFA.id: (900, ALL)}, {SOFA.id: (900, ALL)}], [SOFA])
    door = next(o for o in h.openings() if o.kind == "door")
    turns = iter(["left", "right"])
    monkeypatch.setattr(route, "_seen", lambda facts, entrance: True)
    monkeypatch.setattr(route, "tells_its_place", lambda facts, view: True)
    monkeypatch.setattr(route, "_sure", lambda facts, way, goal, room: [next(turns)])
    monkeypatch.setattr(Facts, "above", lambda self: ["above"])
    monkeypatch.setattr(Facts, "way", lambda self, a, b: [door] * doors)
    assert bool(route.ask(found, np.random.default_rng(0), 8)) == asked


@pytest.mark.parametrize(("low", "high", "asked"), [(0.3, 1.7, True), (0.3, 1.1, False), (0.9, 1.1, False)])
def test_what_is_ahead_is_ahead_of_every_third_of_a_front(low, high, asked):
    """A cabinet from y .4 to 1.6 looks east at a block; a third that is free shows what is behind."""
    cabinet = h.thing("sideboard", 0.5, 1, size=(0.4, 1.2, 0.8), id="cabinet")
    block = h.thing("dining_table", 2, (low + high) / 2, size=(0.6, high - low, 0.7), id="block")
    found = fronts.before(facts([{"cabinet": (900, ALL)}], [cabinet, block]), "cabinet")
    assert (found == (pytest.approx(1.0), "block")) if asked else found is None


@pytest.mark.parametrize(("category", "yes"), [
    ("sofa", True), ("double_bed", True), ("rug", False), ("plant", False), ("kitchen_base", False),
    ("dishwasher", False)])
def test_lengths_are_not_asked_of_what_goes_on_unseen(category, yes):
    assert plain.bounded(facts([], [h.thing(category, 1, 1, id="it")]), "it") == yes


@pytest.mark.parametrize(("category", "yes"), [
    ("sofa", False), ("dining_table", False), ("mirror", True), ("table_lamp", True), ("radiator", True)])
def test_how_it_opens_is_not_asked_of_what_one_may_think_opens(category, yes):
    assert plain.may_open(h.thing(category, 1, 1)) == yes
    joint = Joint(name="a", type="hinge", axis=(0, 0, 1), origin=(0, 0, 0), range=(0, 1), part="hinge_door")
    assert not plain.may_open(h.thing(category, 1, 1, joints=(joint,)))


@pytest.mark.parametrize(("category", "row", "yes"), [
    ("double_bed", 70, False), ("double_bed", 60, True), ("double_bed", 40, True), ("sofa", 60, False)])
def test_a_number_on_a_pillow_does_not_mean_the_bed(category, row, yes):
    """From (2, 1.5, 1.2) northward a bed from y 3.5 to 5.5, its foot ahead: rows 70 and 60 meet it at 3.55 and 5.5."""
    bed = h.thing(category, 2, 4.5, yaw=-pi / 2, size=(2.0, 1.6, 0.6), id="it")
    found = facts([{"it": (900, ALL)}], [bed])
    assert plain.on_pillow(bed, found.eyes[0], (50, row)) == yes


def test_what_lies_on_another_is_not_compared_with_it():
    stand, tv, chair = h.thing("tv_stand", 1, 1), h.thing("tv", 1, 1, id="tv"), h.thing("chair", 3, 1, id="chair")
    tv.on = stand.id
    found = facts([], [stand, tv, chair])
    assert plain.rests_on(found, [stand.id, "tv"]) and not plain.rests_on(found, ["tv", "chair"])


@pytest.mark.parametrize(("wide", "yes"), [(0.3, True), (1.9, False)])
def test_a_direction_is_that_of_all_of_a_thing(monkeypatch, wide, yes):
    """From a plant towards a shelf due east, a desk over y 1.95 to 2.25, or one well over the line at 1.5."""
    things = [h.thing("floor_lamp", 0.6, 1.5, id="lamp"), h.thing("bookshelf", 3.4, 1.5, id="shelf"),
              h.thing("desk", 2.6, 2.1, size=(0.5, wide, 0.7), id="desk")]
    monkeypatch.setattr(Facts, "uncut", lambda self, view, least: set(self.objects))
    monkeypatch.setattr(direction, "shared", lambda drafts, rng, most: drafts)
    found = facts([{o.id: (900, ALL) for o in things}], things)
    asked = [draft.answer for draft in direction.ask(found, np.random.default_rng(0), 99)
             if draft.evidence == {"at": "lamp", "facing": "shelf", "of": "desk"}]
    assert asked == ["ahead to the left"] * yes


@pytest.mark.parametrize(("eye", "share"), [((0.5, 0.5), 1.0), ((3.5, 0.5), 0.82)])
def test_floor_round_a_corner_is_not_in_sight(eye, share):
    """An L of 4 x 1 m and, north of its west end, 1 x 1 m more; from the east end the corner at (1, 1) hides a part:
    what lies north of the line from (3.5, .5) through it, which meets the west wall at y 1.2.
    """
    found = facts([{SOFA.id: (900, ALL)}], [SOFA])
    room = found.rooms[h.LIVING].model_copy(update={"polygon": [(0, 0), (4, 0), (4, 1), (1, 1), (1, 2), (0, 2)]})
    found.__dict__["rooms"] = {h.LIVING: room}
    pose = ((1, 0, 0, eye[0]), (0, 0, 1, eye[1]), (0, -1, 0, 1.2), (0, 0, 0, 1))
    view = found.eyes[0].model_copy(update={"pose": pose})
    assert plain.in_sight(found, h.LIVING, view) == pytest.approx(share, abs=0.02)


@pytest.mark.parametrize(("on", "x", "yes"), [("wall", 2.5, False), ("wall", 0.3, True), ("floor", 0.3, False)])
def test_what_hangs_is_known_from_before_it(on, x, yes):
    """On a wall at y 1.9 that looks south to an eye at (2, 1.5), .4 m before it."""
    found, mirror = facts([{SOFA.id: (900, ALL)}], [SOFA]), h.thing("mirror", x, 1.9, yaw=-pi / 2)
    mirror.on = on
    assert plain.edgewise(mirror, found.eyes[0]) == yes


@pytest.mark.parametrize(("x", "yes"), [(2.0, True), (3.6, False)])
def test_a_place_in_a_doorway_is_in_no_room(monkeypatch, x, yes):
    """The door is at (4.05, 1.45)."""
    some = [h.thing(name, 1 + k, 1) for k, name in enumerate(("sofa", "plant", "bookshelf"))]
    monkeypatch.setattr(Facts, "uncut", lambda self, view, least: set(self.objects))
    found = facts([{f"floor_{h.LIVING}": (9000, ALL)} | {o.id: (300, ALL) for o in some}], some)
    pose = ((1, 0, 0, x), (0, 0, 1, 1.5), (0, -1, 0, 1.2), (0, 0, 0, 1))
    assert plain.tells_its_place(found, found.eyes[0].model_copy(update={"pose": pose})) == yes


def test_what_sofas_have_of_their_own_has_no_name():
    cushion = h.thing("plant", 2, 1, size=(0.5, 0.5, 0.2), id="cushion")
    cushion.category = "cushion"
    assert set(facts([], [SOFA, cushion]).names) == {SOFA.id}


@pytest.mark.parametrize(("gap", "yes"), [(0.01, True), (0.1, False)])
def test_shelves_side_by_side_may_be_one(gap, yes):
    shelves = [h.thing("bookshelf", 0.2, y, size=(0.3, 0.8, 1.8), id=f"shelf_{y}") for y in (1.0, 1.8 + gap)]
    assert plain.side_by_side(facts([], shelves), [o.id for o in shelves]) == yes


@pytest.mark.parametrize("pixels, first", [([0, 80, 400], 1), ([0, 50, 400], None), ([0, 10, 400], 2), ([70, 0, 0], 0)])
def test_a_thing_appears_where_it_covers_six_thousandths_of_a_picture(monkeypatch, pixels, first):
    """Of 10,000 pixels 60; what was seen by more than a fifth of that before it appeared may have been noticed."""
    monkeypatch.setattr(Facts, "known", lambda self, view: {SOFA.id})
    shown = [{SOFA.id: (some, (40, 40, 20, 20))} if some else {} for some in pixels]
    found = facts(shown, [SOFA], "route")
    assert appearance_order._first(found, list(found.views), SOFA.id) == first
