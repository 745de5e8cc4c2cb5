"""Where assets stand once their size is known."""

import numpy as np
import pytest
from shapely import Polygon
from shapely import box as rectangle

from apartgen.schemas.errors import BadInput
from apartgen.schemas.layout import Layout
from apartgen.schemas.retrieve import Retrieve
from apartgen.stages.retrieve import RetrieveConfig, furniture, run
from apartgen.stages.retrieve.matching import placing, supports
from apartgen.stages.space import boxes
from apartgen.stages.space.boxes import Boxes
from apartgen.stages.things import tops
from apartgen.stages.things.categories import CATEGORIES, TABLE

RNG = np.random.default_rng(0)
UNITS = ("kitchen_base", "kitchen_drawers", "kitchen_sink")


def retrieve(layout, libraries) -> Retrieve:
    return run(layout, RetrieveConfig(), np.random.default_rng(0), libraries)


def footprint(thing) -> Polygon:
    return boxes.footprints(boxes.of([thing]))[0]


@pytest.mark.parametrize("category", CATEGORIES)
def test_a_box_in_range_is_hit_exactly(category, flat, libraries):
    kind = TABLE[category]
    if kind.place == "top":
        pytest.skip("stands on something")
    thing = retrieve(
        flat({"category": category, "center": [2, 2.5, kind.size[2] / 2], "size": kind.size}), libraries
    ).objects[0]
    assert np.allclose(thing.size, kind.size, atol=1e-3) and np.allclose(thing.center[:2], [2, 2.5])
    assert (np.asarray(thing.size) <= np.asarray(kind.size) + 1e-9).all()


@pytest.mark.parametrize("yaw, back", [(0.0, (0, 2.5)), (np.pi / 2, (2, 0)), (np.pi, (4, 2.5)), (-np.pi / 2, (2, 5))])
def test_a_shrunk_box_keeps_its_back_at_the_wall(yaw, back, flat, libraries):
    deep = 0.95  # above the deepest real wardrobe, 0.70
    front = np.array([np.cos(yaw), np.sin(yaw)])
    center = np.asarray(back) + deep / 2 * front
    thing = retrieve(
        flat({"category": "wardrobe", "center": [*center, 1.05], "size": [deep, 1.5, 2.1], "yaw": yaw}), libraries
    ).objects[0]
    assert thing.size[0] == 0.7
    assert np.allclose(thing.center[:2] - thing.size[0] / 2 * front, back, atol=1e-6)


def test_a_shrunk_box_in_a_corner_keeps_both_walls(flat, libraries):
    thing = retrieve(
        flat(
            {"category": "wardrobe", "center": [0.5, 2.0, 1.2], "size": [1.0, 4.0, 2.4]},
        ),
        libraries,
    ).objects[0]
    assert thing.size[:2] == (0.7, 3.0)
    lo, hi = np.array(thing.center) - np.array(thing.size) / 2, np.array(thing.center) + np.array(thing.size) / 2
    assert np.isclose(lo[0], 0) and np.isclose(lo[1], 0.0) and hi[1] <= 5


def test_a_box_below_real_sizes_grows_away_from_wall_and_neighbour(flat, libraries):
    small = {"category": "wardrobe", "center": [0.2, 1.0, 1.0], "size": [0.4, 0.5, 2.0]}
    other = {"category": "chest", "center": [0.24, 1.75, 0.4], "size": [0.48, 0.9, 0.8]}
    home = retrieve(flat(small, other), libraries)
    a, b = home.objects
    assert a.size[:2] == (0.45, 0.7)
    assert footprint(a).intersection(footprint(b)).area < 0.02 * 0.7
    assert Polygon(home.rooms[0].polygon).buffer(0.0101, join_style="mitre").covers(footprint(a))


def test_what_no_room_is_left_for_is_left_out(flat, libraries):
    each = {"category": "chest", "size": [0.6, 1.6, 0.8], "yaw": 0.0}
    walls = [each | {"center": [x, y, 0.4]} for x in (0.3, 0.9 + 0.35) for y in (0.8, 2.4, 4.0)]
    squeezed = {"category": "wardrobe", "center": [0.775, 2.4, 1.0], "size": [0.34, 0.6, 2.0]}
    home = retrieve(flat(*walls, squeezed), libraries)
    assert [o.category for o in home.objects] == ["chest"] * 6


def test_things_stand_exactly_on_what_carries_them(flat, libraries):
    home = retrieve(
        flat(
            {"category": "tv_stand", "center": [0.25, 2.5, 0.3], "size": [0.5, 1.7, 0.6]},
            {"category": "tv", "center": [0.2, 2.5, 1.1], "size": [0.1, 1.2, 0.7]},
            {"category": "nightstand", "center": [3.7, 4.0, 0.3], "size": [0.42, 0.48, 0.5]},
            {"category": "table_lamp", "center": [3.9, 4.3, 1.0], "size": [0.25, 0.25, 0.45]},
        ),
        libraries,
    )
    stand, tv, night, lamp = home.objects
    for item, under in ((tv, stand), (lamp, night)):
        asset = libraries.load_asset(under.asset.library, under.asset.id)
        at = boxes.local(np.array([item.center[:2]]), boxes.of([under]))[0]
        top = tops.heights(asset, at)[0] + under.center[2]
        assert np.isclose(item.center[2] - item.size[2] / 2, top, atol=1e-6) and item.on == under.id
    assert stand.on == night.on == "floor"
    assert footprint(night).covers(footprint(lamp).centroid)


def test_two_things_on_one_top_stay_apart(flat, libraries):
    lamps = [{"category": "table_lamp", "center": [0.3, 2.5, 1.0], "size": [0.3, 0.3, 0.45]}] * 2
    home = retrieve(
        flat({"category": "sideboard", "center": [0.25, 2.5, 0.4], "size": [0.5, 1.6, 0.8]}, *lamps), libraries
    )
    a, b = home.objects[1:]
    assert not footprint(a).buffer(-1e-6).intersects(footprint(b))


def test_what_has_nothing_to_stand_on_is_left_out(flat, libraries):
    home = retrieve(flat({"category": "monitor", "center": [2, 2, 1], "size": [0.2, 0.5, 0.4]}), libraries)
    assert home.objects == []


def test_what_has_no_room_but_in_a_cupboard_beside_is_left_out(flat, libraries):
    """On a unit narrower than itself, between a wall and something high."""
    narrow = {"category": "kitchen_base", "center": [0.3, 0.2, 0.45], "size": [0.6, 0.4, 0.9], "yaw": 0.0}
    high = {"category": "fridge", "center": [0.3, 0.71, 0.9], "size": [0.6, 0.6, 1.8], "yaw": 0.0}
    item = {"category": "microwave", "center": [0.2, 0.2, 1.03], "size": [0.3, 0.44, 0.26], "yaw": 0.0}
    assert [o.category for o in retrieve(flat(narrow, high, item), libraries).objects] == ["kitchen_base", "fridge"]
    assert len(retrieve(flat(narrow, item), libraries).objects) == 2


def test_heights_by_place(flat, libraries):
    home = retrieve(
        flat(
            {"category": "ceiling_lamp", "center": [2, 2.5, 1.0], "size": [0.4, 0.4, 0.5]},
            {"category": "rug", "center": [2, 2.5, 0.3], "size": [1.6, 2.3, 0.02]},
            {"category": "mirror", "center": [0.02, 2.5, 1.5], "size": [0.04, 0.6, 0.8]},
            {"category": "double_bed", "center": [1.05, 4.0, 0.9], "size": [2.1, 1.6, 1.0]},
        ),
        libraries,
    )
    low = [o.center[2] - o.size[2] / 2 for o in home.objects]
    assert np.allclose(low, [home.height - 0.5, 0, 1.1, 0], atol=1e-5)


def test_same_layout_same_bytes_and_input_untouched(flat, libraries):
    layout = flat(
        {"category": "sofa", "center": [1, 2.5, 0.4], "size": [0.9, 2.0, 0.8], "latent": RNG.normal(size=32).tolist()}
    )
    before = layout.model_dump_json()
    assert retrieve(layout, libraries).model_dump_json() == retrieve(layout, libraries).model_dump_json()
    assert layout.model_dump_json() == before


def test_bad_layouts_are_refused_by_name(flat, libraries):
    layout = flat({"category": "throne", "center": [1, 1, 1], "size": [1, 1, 1]})
    with pytest.raises(BadInput, match=r"objects\[0\].category: no category 'throne'"):
        retrieve(layout, libraries)
    lost = flat({"category": "sofa", "center": [1, 1, 1], "size": [1, 1, 1], "room": "attic_1"})
    with pytest.raises(BadInput, match="attic_1"):
        retrieve(Layout.model_validate(lost.model_dump()), libraries)


def test_equal_things_of_a_room_look_equal_and_a_kitchen_shares_one_style(flat, libraries):
    rng = np.random.default_rng(3)
    table = libraries.embedded._index
    rows = [i for i, name in enumerate(table.category) if name == "chair" and table.style[i] == "legs"]

    def noisy(row: int) -> list[float]:
        return (table.latent[row] + 0.7 * rng.normal(size=32)).tolist()

    chairs = [{"category": "chair", "center": [1 + i, 1, 0.44], "size": [0.5 + i / 100, 0.47, 0.88],
               "latent": noisy(rows[i])} for i in range(3)]  # fmt: skip
    units = [{"category": name, "center": [0.3, 2 + 0.6 * i, 0.45], "size": [0.6 + i / 200, 0.6, 0.9],
              "latent": rng.normal(size=32).tolist()} for i, name in enumerate(UNITS)]  # fmt: skip
    home = retrieve(flat(*chairs, *units, type="kitchen"), libraries)
    made = [libraries.load_asset(o.asset.library, o.asset.id) for o in home.objects]
    assert {asset.style for asset in made[:3]} == {"legs"} and len({asset.id for asset in made[:3]}) == 1
    assert len({(asset.style, asset.id[-1]) for asset in made[3:]}) == 1
    assert len({(o.size[0], o.size[2]) for o in home.objects[3:]}) == 1, "one worktop"


def test_a_smaller_piece_of_the_same_latent_keeps_the_style(flat, libraries):
    latent = np.random.default_rng(1).normal(size=32).tolist()
    box = {"category": "wardrobe", "center": [2, 2.5, 1], "size": [0.6, 1.5, 2.1], "latent": latent}
    thing = retrieve(flat(box), libraries).objects[0]
    smaller = libraries.nearest("wardrobe", (0.5, 1.0, 2.0), thing.latent, (0.5, 1.0, 2.0))
    assert smaller.style == libraries.load_asset(thing.asset.library, thing.asset.id).style
    assert smaller.size == (0.5, 1.0, 2.0)


@pytest.mark.parametrize("seed", range(6))
def test_no_new_collision_and_nothing_new_outside(seed, flat, libraries):
    """Random rooms of separate boxes of any size, real or not."""
    rng = np.random.default_rng(seed)
    names = [c for c in CATEGORIES if TABLE[c].place == "floor"]
    objects = []
    for x in (0.7, 2.0, 3.3):
        for y in (0.7, 2.0, 3.3, 4.4):
            category = str(rng.choice(names))
            size = np.minimum(np.asarray(TABLE[category].size) * rng.uniform(0.6, 1.3, 3), (1.1, 1.1, 2.5))
            objects.append({"category": category, "center": [x, y, size[2] / 2], "size": size.tolist()})
    layout = flat(*objects)
    home = retrieve(layout, libraries)
    before = {o.id: o for o in layout.objects}
    room = Polygon(layout.rooms[0].polygon).buffer(0.0101, join_style="mitre")
    after = boxes.penetration(boxes.of(home.objects))
    was = boxes.penetration(boxes.of([before[o.id] for o in home.objects]))
    assert len(home.objects) >= 6
    assert (after[was <= 0.01] <= 0.01 + 1e-6).all()
    for thing in home.objects:
        kind = TABLE[thing.category]
        assert (np.asarray(thing.size) >= np.asarray(kind.min) - 1e-6).all()
        assert (np.asarray(thing.size) <= np.maximum(before[thing.id].size, kind.min) + 1e-6).all()
        assert room.covers(footprint(thing)) or not room.covers(footprint(before[thing.id]))


def test_a_television_as_wide_as_its_stand_stays_there_between_shelves(flat, libraries):
    """One shelf stands a centimetre into the television's end, a nightstand 2 m off would carry a third of it."""
    stand, tv, *rest = retrieve(flat(
        {"category": "tv_stand", "center": [0.2, 2.5, 0.2], "size": [0.36, 1.2, 0.4]},
        {"category": "tv", "center": [0.2, 2.5, 0.76], "size": [0.1, 1.2, 0.72]},
        {"category": "bookshelf", "center": [0.16, 1.61, 0.75], "size": [0.28, 0.6, 1.5]},
        {"category": "nightstand", "center": [0.2, 4.5, 0.25], "size": [0.4, 0.44, 0.5]},
    ), libraries).objects
    assert tv.on == stand.id and np.hypot(*np.subtract(tv.center, stand.center)[:2]) < 0.05
    assert boxes.penetration(boxes.of([tv]), boxes.of(rest[:1])).max() < 1e-6


def test_a_television_said_to_hang_stays_on_the_wall_and_any_other_finds_its_stand(flat, libraries):
    things = ({"category": "tv_stand", "center": [0.3, 2.5, 0.25], "size": [0.5, 2.0, 0.5]},
              {"category": "tv", "center": [0.2, 2.5, 1.3], "size": [0.1, 1.2, 0.7], "yaw": 0.0})
    for on, carrier in (("wall", "wall"), (None, "stand"), ("stand", "stand")):
        layout = flat(*things)
        stand, tv = layout.objects
        tv = tv.model_copy(update={"on": stand.id if on == "stand" else on})
        stand, tv = retrieve(layout.model_copy(update={"objects": [stand, tv]}), libraries).objects
        assert tv.on == (stand.id if carrier == "stand" else carrier)
        assert (abs(tv.center[2] - 1.3) < 0.1) == (carrier == "wall")


def test_a_television_exactly_as_wide_as_the_gap_between_cabinets_stands_on_its_stand(flat, libraries):
    """Turned by -1.5708, which is no quarter turn to the last digit: its ends touch both by 4e-8 m."""
    tall = {"category": "display_cabinet", "size": [0.36, 0.8, 1.54], "yaw": -1.5708}
    stand, tv, *_ = retrieve(flat(
        {"category": "tv_stand", "center": [2.225, 4.81, 0.2], "size": [0.36, 1.2, 0.4], "yaw": -1.5708},
        {"category": "tv", "center": [2.225, 4.81, 0.76], "size": [0.1, 1.2, 0.72], "yaw": -1.5708},
        tall | {"center": [1.225, 4.81, 0.77]}, tall | {"center": [3.225, 4.82, 0.77]},
    ), libraries).objects
    assert tv.on == stand.id


@pytest.mark.parametrize("away, hung", [(0.0, True), (0.3, True), (1.2, False)])
def test_a_television_without_a_stand_hangs_on_the_wall_behind_it_or_is_left_out(away, hung, flat, libraries):
    things = retrieve(flat(
        {"category": "tv", "center": [2.0, 5.0 - 0.05 - away, 1.2], "size": [0.1, 1.2, 0.72], "yaw": -np.pi / 2},
    ), libraries).objects
    assert [thing.on for thing in things] == ["wall"] * hung
    for thing in things:
        assert np.allclose(thing.center[:2], (2.0, 5.0 - thing.size[0] / 2), atol=1e-6)


def test_what_outgrew_its_box_goes_to_the_nearest_place_there_is() -> None:
    """4 cm in the wall behind it: 5 cm forward will do; 8 cm in a neighbour as well: 10 cm aside, too."""
    site = placing.Site(Polygon([(0, 0), (4, 0), (4, 4), (0, 4)]), Polygon())
    deep = boxes.Boxes(np.array([[0.46, 2.0, 0.5]]), np.array([[1.0, 1.0, 1.0]]), np.zeros(1))
    nothing = placing.Others(deep.take(np.zeros(1, bool)), np.zeros(0))
    found = placing.grown(deep, deep, site, nothing)
    assert found is not None and found.center[0] == pytest.approx([0.51, 2.0, 0.5])
    beside = placing.Others(boxes.Boxes(np.array([[0.5, 3.0, 0.5]]), np.ones((1, 3)), np.zeros(1)), np.array([0.01]))
    close = deep._replace(center=np.array([[0.46, 2.08, 0.5]]))
    moved = placing.grown(close, close, site, beside)
    assert moved is not None and moved.center[0] == pytest.approx([0.51, 1.98, 0.5])


@pytest.mark.parametrize("wide, least, most", [(0.40, -0.01, 0.01), (0.48, -0.026, -0.004)])
def test_what_is_wider_than_its_top_stands_away_from_the_wall(wide, least, most):
    """A unit .45 m wide ends a centimetre before the wall: a microwave of .48 m would reach 5 mm into it."""
    unit = furniture.build("kitchen_base", "shaker", (0.6, 0.45, 0.9), 1)
    wall = 0.225 + 0.01
    floor = rectangle(-1, -2, 1, wall)
    under = supports.top(unit, Boxes(np.array([[0, 0, 0.45]]), np.array([[0.6, 0.45, 0.9]]), np.zeros(1)))
    item = Boxes(np.array([[0.0, 0.0, 1.04]]), np.array([[0.36, wide, 0.28]]), np.zeros(1))
    none = Boxes(np.zeros((0, 3)), np.zeros((0, 3)), np.zeros(0))
    placed = supports.stand(item, under, none, floor)
    assert placed is not None and least < placed.center[0, 1] < most
    assert placed.center[0, 1] + wide / 2 <= wall + 1e-9
