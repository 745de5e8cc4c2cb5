"""What is put into a home: nothing in another thing, nothing in the air, nothing in the way, furniture as it was."""

import handmade
import numpy as np
import pytest
import shapely
from inhabited import corners, furnished, library, lived_in, things

from apartgen.schemas import carrying
from apartgen.schemas.populate import Populate
from apartgen.schemas.walkable import Walkable
from apartgen.stages import populate, seeds
from apartgen.stages.populate import arrange, rules, stage
from apartgen.stages.populate.boards import Board
from apartgen.stages.retrieve import furniture
from apartgen.stages.robot.wedged import wedged
from apartgen.stages.scene.scene import Scene
from apartgen.stages.space import sweeps
from apartgen.stages.things import small
from apartgen.stages.things.categories import TABLE
from apartgen.stages.things.receptacles import Receptacle

SEEDS = range(3)


def test_the_table_names_only_what_there_is():
    assert rules.unknown() == []
    assert {"kitchen", "living_room", "bedroom", "bathroom", "hallway"} <= set(rules.table())
    used = {name for lines in rules.table().values() for rule in lines for name in rule.put}
    assert len(used) >= 60


@pytest.mark.parametrize("seed", SEEDS)
def test_furniture_is_as_it_was(seed):
    before, after = furnished(), lived_in(seed)
    assert after.objects[: len(before.objects)] == before.objects
    assert after.walkable == before.walkable and isinstance(after, Populate) and not isinstance(after, Walkable)
    assert len({o.id for o in after.objects}) == len(after.objects)


@pytest.mark.parametrize("seed", SEEDS)
def test_nothing_stands_in_anything_else(seed):
    home = lived_in(seed)
    own = {o.id for o in things(home)}
    assert not {name: others for name, others in wedged(Scene(home, library().load_asset, False).bodies).items()
                if name in own}


@pytest.mark.parametrize("seed", SEEDS)
def test_every_thing_rests_on_what_it_says(seed):
    home = lived_in(seed)
    by_id = {o.id: o for o in home.objects}
    for o in things(home):
        low = o.center[2] - o.size[2] / 2
        if o.on in carrying.BUILDING:
            assert small.TABLE[o.category].fixed == (o.on == carrying.WALL)
            assert o.on == carrying.WALL or low < 2e-3
            continue
        below = by_id[o.on]
        assert below.room == o.room
        if hasattr(below, "stage"):
            assert below.in_ == o.in_ and below.category == o.category
            top = below.center[2] + below.size[2] * (small.TABLE[below.category].pitch - 0.5)
            assert low == pytest.approx(top, abs=2e-3)
        else:
            place = next(p for p in home.receptacles[below.id] if p.name == o.in_.receptacle)
            assert o.in_.object == below.id
            assert low == pytest.approx(below.center[2] + place.z, abs=2e-3)
            assert o.size[2] < place.clearance


@pytest.mark.parametrize("seed", SEEDS)
def test_things_keep_within_the_outline_of_their_place(seed):
    home = lived_in(seed)
    by_id = {o.id: o for o in home.objects}
    for o in things(home):
        if o.in_ is None:
            continue
        owner = by_id[o.in_.object]
        place = next(p for p in home.receptacles[owner.id] if p.name == o.in_.receptacle)
        c, s = np.cos(owner.yaw), np.sin(owner.yaw)
        outline = np.asarray(place.polygon) @ np.array([[c, s], [-s, c]]) + owner.center[:2]
        seen = o.model_copy(update={"yaw": owner.yaw}) if small.TABLE[o.category].round else o
        assert shapely.Polygon(outline).buffer(2e-3).contains(shapely.Polygon(corners(seen))), o.id


@pytest.mark.parametrize("seed", SEEDS)
def test_no_door_or_lid_meets_a_thing(seed):
    home = lived_in(seed)
    moving = [(o, joint) for o in furnished().objects for joint in o.joints if joint.type == "hinge"]
    for thing in things(home):
        inside = thing.in_.object if thing.in_ else ""
        for owner, joint in moving:
            if owner.room != thing.room or owner.id == inside and joint.part == "hinge_door":
                continue
            lo, hi = sweeps.swept(joint)
            c, s = np.cos(owner.yaw), np.sin(owner.yaw)
            seen = (corners(thing) - owner.center[:2]) @ np.array([[c, -s], [s, c]])
            z = thing.center[2] - owner.center[2] + np.array([-0.5, 0.5]) * thing.size[2]
            apart = (seen.min(0) > hi[:2] - 2e-3).any() or (seen.max(0) < lo[:2] + 2e-3).any()
            assert apart or z[0] > hi[2] - 2e-3 or z[1] < lo[2] + 2e-3, (thing.id, owner.id, joint.name)


def test_what_is_in_a_sliding_wardrobe_is_behind_its_tracks():
    for style in furniture.styles("sliding_wardrobe"):
        made = furniture.build("sliding_wardrobe", style, TABLE["sliding_wardrobe"].size, 1)
        key = handmade.AssetKey(library="parametric", id=made.id)
        robe = handmade.thing("sliding_wardrobe", 4.5, 2.0, room=handmade.BEDROOM, joints=made.joints).model_copy(
            update={"asset": key, "size": made.size, "center": (4.5, 2.0, made.size[2] / 2)})
        home = populate.run(handmade.home(robe), populate.PopulateConfig(density=3.0, walls=False),
                            seeds.drawn(1, style), library())
        inside = [o for o in things(home) if o.in_]
        assert inside
        for o in inside:
            lo, hi = np.min([sweeps.swept(j)[0] for j in made.joints], 0), np.max(
                [sweeps.swept(j)[1] for j in made.joints], 0)
            c, s = np.cos(robe.yaw), np.sin(robe.yaw)
            front = ((corners(o) - robe.center[:2]) @ np.array([[c, -s], [s, c]]))[:, 0].max()
            assert front <= lo[0] + 1e-3 and hi[0] > lo[0], o.id


@pytest.mark.parametrize("seed", SEEDS)
def test_what_hangs_is_on_a_wall_that_is_free_there(seed):
    home = lived_in(seed)
    rooms = {room.id: shapely.Polygon(room.polygon) for room in home.rooms}
    hung = [o for o in things(home) if o.on == carrying.WALL]
    assert {"light_switch", "socket", "picture"} <= {o.category for o in hung}
    for o in hung:
        outline = shapely.Polygon(corners(o))
        assert rooms[o.room].buffer(1e-4).contains(outline)
        back = corners(o)[[0, 3]]
        assert max(rooms[o.room].exterior.distance(shapely.Point(point)) for point in back) < 2e-3
        low, high = o.center[2] - o.size[2] / 2, o.center[2] + o.size[2] / 2
        for opening in (p for p in home.openings if o.room in p.rooms):
            beside = shapely.LineString(opening.segment).buffer(0.4, cap_style="flat").distance(outline) > 0.03
            assert beside or low > opening.head or high < opening.sill, (o.id, opening.id)
        for other in (p for p in home.objects if p is not o and p.room == o.room):
            over = low < other.center[2] + other.size[2] / 2 and high > other.center[2] - other.size[2] / 2
            assert not over or shapely.Polygon(corners(other)).intersection(outline).area < 1e-6, (o.id, other.id)


@pytest.mark.parametrize("seed", SEEDS)
def test_no_picture_hangs_twice_in_a_home_that_has_enough_of_them(seed):
    hung = [o.asset.id for o in things(lived_in(seed)) if o.category == "picture"]
    assert len(hung) > 2 and len(set(hung)) == len(hung)


@pytest.mark.parametrize("seed", SEEDS)
def test_no_two_pictures_of_a_home_look_alike(seed):
    """Prints of one composition in the same colours look alike, whatever they measure."""
    looks = [o.asset.id.split("/")[1::2] for o in things(lived_in(seed)) if o.category == "picture"]
    assert len(looks) == len({tuple(look) for look in looks})


@pytest.mark.parametrize("seed", SEEDS)
def test_no_wall_of_a_living_room_is_bare(seed):
    """Furniture taken away, there is a door, a window or something that hangs at every wall."""
    home = furnished()
    empty = home.model_copy(update={"objects": [o for o in home.objects if o.room != "living_room_1"]})
    home = populate.run(empty, populate.PopulateConfig(), seeds.drawn(seed, "walls"), library())
    ring = np.array(next(room.polygon for room in home.rooms if room.id == "living_room_1"))
    there = [shapely.Polygon(corners(o)) for o in things(home) if o.room == "living_room_1" and o.on == carrying.WALL]
    there += [shapely.LineString(o.segment) for o in home.openings if "living_room_1" in o.rooms]
    walls = [shapely.LineString([a, b]) for a, b in zip(ring, np.roll(ring, -1, axis=0))]
    long = [wall for wall in walls if wall.length > 1.8]
    assert len(long) > 2
    for wall in long:
        stretch = shapely.LineString([wall.interpolate(0.1), wall.interpolate(wall.length - 0.1)])
        assert min(one.distance(stretch) for one in there) < 0.35, list(wall.coords)


def test_the_same_seed_gives_the_same_and_another_another():
    home = furnished()
    lane = seeds.drawn(2, "populate", seeds.plan_digest(home))
    assert populate.run(home, populate.PopulateConfig(), lane, library()) == lived_in(2)
    assert things(lived_in(1)) != things(lived_in(2))


def test_a_room_draws_from_a_lane_of_its_own():
    home = furnished()
    bare = home.model_copy(update={"objects": [o for o in home.objects if o.room != "kitchen_1"]})
    lane = seeds.drawn(0, "populate", seeds.plan_digest(home))
    without = things(populate.run(bare, populate.PopulateConfig(), lane, library()))
    assert [o for o in things(lived_in(0)) if o.room != "kitchen_1"] == [o for o in without if o.room != "kitchen_1"]


@pytest.mark.parametrize("deep", [0.3, 0.21])
def test_books_at_the_front_stand_out_for_fingers_where_there_is_depth(deep):
    rng = np.random.default_rng(4)
    owner = next(o for o in furnished().objects if o.category == "bookshelf" or o.category == "sideboard")
    for _ in range(20):
        place = Receptacle("shelf_0", "shelf", (-deep / 2, -0.4), (deep / 2, 0.4), 0.0, 0.35)
        books = [small.drawn(small.TABLE["book"], rng) for _ in range(6)]
        row = arrange.row(books, False, Board(owner, place, np.zeros((0, 5))), "front", rng)
        fronts = np.array([put.spot.x + put.design.size[0] / 2 for put in row])
        backs = np.array([put.spot.x - put.design.size[0] / 2 for put in row])
        assert len(row) == 6 and fronts.max() <= deep / 2 and backs.min() >= -deep / 2
        ahead = fronts[1:-1] - np.maximum(fronts[:-2], fronts[2:])
        assert (ahead > 0.02).any() if deep > 0.25 else np.ptp(fronts) < 0.04 + 1e-9


def test_what_stands_at_the_back_is_on_no_rim_at_the_front_while_there_is_another_place():
    """A bottle of soap stands behind or beside the basin, not before it."""
    sink = next(o for o in furnished().objects if o.category == "kitchen_sink")
    rims = {"front": ((0.2, -0.3), (0.3, 0.3)), "back": ((-0.3, -0.3), (-0.2, 0.3)), "side": ((-0.2, 0.2), (0.2, 0.3))}
    (rule,) = (rule for rule in rules.table()["kitchen"] if rule.put == ("dish_soap",))
    home = stage.Home(stage._models(np.random.default_rng(0)), 1, 1.0)

    def used(names, seed):
        here = [Board(sink, Receptacle(name, "top", *rims[name], 0.46, 3.0), np.zeros((0, 5))) for name in names]
        return {put.board.place.name for put, in stage.furnished(here, [rule], home, np.random.default_rng(seed))}

    assert set().union(*(used(rims, seed) for seed in range(20))) == {"back", "side"}
    assert used(["front"], 0) == {"front"}


def test_density_says_how_much_there_is():
    counts = [len(things(lived_in(0, density))) for density in (0.0, 0.5, 1.0, 2.0)]
    assert counts == sorted(counts) and counts[3] > 1.3 * counts[2] > 1.6 * counts[1]
    empty = lived_in(0, 0.0, False)
    assert not things(empty)


def test_a_retrieve_artifact_will_do():
    from apartgen.schemas.retrieve import Retrieve

    home = furnished()
    plain = Retrieve(**{name: getattr(home, name) for name in Retrieve.model_fields})
    lane = seeds.drawn(0, "populate", seeds.plan_digest(home))
    made = populate.run(plain, populate.PopulateConfig(), lane, library())
    assert made.walkable is None and things(made) == things(lived_in(0))


def test_most_things_are_of_a_hands_size_and_free():
    home = lived_in(0)
    free = {body.id for body in Scene(home, library().load_asset, False).bodies if body.free}
    hand = [o for o in things(home) if max(o.size) <= 0.4
            and library().load_asset(o.asset.library, o.asset.id).links[0].mass <= 5]
    assert len(hand) > 0.8 * len(things(home))
    assert sum(o.id in free for o in hand) >= 0.9 * len(hand)


@pytest.mark.parametrize("rack", [False, True])
def test_a_hall_has_hooks_for_coats_unless_it_has_a_rack(rack):
    """The bathroom made a hall, empty or with a rack where one thing of it stood."""
    home = furnished()
    rooms = [room.model_copy(update={"type": "hallway"}) if room.id == "bathroom_1" else room for room in home.rooms]
    own = [o for o in home.objects if o.room == "bathroom_1"]
    others = [o for o in home.objects if o.room != "bathroom_1"]
    racks = [own[0].model_copy(update={"category": "coat_rack"})] if rack else []
    hall = home.model_copy(update={"rooms": rooms, "objects": others + racks})
    lane = seeds.drawn(0, "populate", seeds.plan_digest(hall))
    found = things(populate.run(hall, populate.PopulateConfig(), lane, library()))
    assert [o.category for o in found if o.room == "bathroom_1"].count("coat_hooks") == (not rack)
