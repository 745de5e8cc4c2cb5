"""A bathroom in which no single piece can move for the way is planned anew, with all that it had."""

from types import SimpleNamespace

import boxes_library as fake
import handmade as h
import numpy as np
import pytest
from crowded import of_kind
from shapely.geometry import box

from apartgen.schemas.retrieve import Joint
from apartgen.stages.metrics import collision, doorways, outside
from apartgen.stages.walkable import WalkableConfig, rearrange, repair, run


def tight(depth, narrower):
    """A bathroom of about 4 m² whose basin stands behind the open door, with the bath opposite."""
    far, left = 4.1 + depth, 2.85 - narrower
    basin = (0.35, 0.45, 0.78)
    lid = Joint(name="lid", type="hinge", axis=(0, -1, 0), origin=(-0.1, 0, 0.05), range=(0, np.pi / 2),
                part="hinge_lid", extent=((-0.1, -0.18, 0.04), (0.26, 0.18, 0.06)))
    home = of_kind(h.home(
        h.thing("toilet", far - 0.272, left - 0.2, np.pi, h.BEDROOM, size=(0.54, 0.38, 0.74), id="toilet",
                joints=(lid,)),
        h.thing("bath", far - 0.39, 1.52, np.pi, h.BEDROOM, size=(0.76, 1.5, 0.67), id="bath"),
        h.thing("vanity", 4.33, left - 0.18, -np.pi / 2, h.BEDROOM, size=basin, id="vanity",
                joints=tuple(fake.joints("vanity", basin))),
        h.thing("mirror", 4.33, left - 0.02, -np.pi / 2, h.BEDROOM, size=(0.03, 0.4, 0.8), id="mirror"),
    ), "bathroom")
    room = h.rectangle(4.1, 0.76, depth, left - 0.76)
    rooms = [one.model_copy(update={"polygon": room}) if one.id == h.BEDROOM else one for one in home.rooms]
    openings = [o.model_copy(update={"hinge": int(o.id == "door_1")}) for o in home.openings if o.kind != "window"]
    return home.model_copy(update={"rooms": rooms, "openings": openings})


def walk(home):
    config = WalkableConfig(target=0.2, write_anyway=True)
    return run(home, config, np.random.default_rng(0), fake.Empty().of(home))


@pytest.mark.parametrize("depth, narrower", [(1.97, 0.0), (1.97, 0.02), (2.02, 0.0), (2.07, 0.04)])
def test_a_tight_bathroom_is_planned_anew(depth, narrower, monkeypatch):
    home = tight(depth, narrower)
    result = walk(home)
    assert result.walkable.unreached == [] and result.walkable.blocked == [] and result.walkable.dropped == []
    assert [(o.id, o.size) for o in result.objects] == [(o.id, o.size) for o in home.objects]
    assert collision.measure(result)[0].value == 0 and outside.measure(result)[0].value == 0
    assert doorways.measure(result)[0].value <= doorways.measure(home)[0].value
    now = {o.id: o for o in result.objects}
    last = {step.object: step.after for step in result.walkable.steps}
    assert {name: (o.center, o.yaw) for name, o in now.items() if name in last} == {
        name: (after.center, after.yaw) for name, after in last.items()}
    monkeypatch.setattr(repair, "rearranged", lambda *_: ())
    assert walk(home).walkable.unreached == ["vanity"]


def test_the_mirror_comes_along_with_its_basin():
    home = tight(1.97, 0.0)
    old, new = ({o.id: o for o in some} for some in (home.objects, walk(home).objects))

    def between(some):
        return np.subtract(some["mirror"].center, some["vanity"].center)

    assert new["vanity"].center != old["vanity"].center
    turn = new["vanity"].yaw - old["vanity"].yaw
    c, s = np.cos(turn), np.sin(turn)
    assert between(new) == pytest.approx(np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ between(old))


@pytest.mark.parametrize("many, area, found", [
    (1, 4.0, False), (2, 4.0, True), (rearrange.FIRM, 4.0, True), (rearrange.FIRM + 1, 4.0, False),
    (2, rearrange.SMALL, True), (2, rearrange.SMALL + 0.1, False)])
def test_only_small_rooms_of_two_to_five_needed_pieces_are_planned_anew(many, area, found, monkeypatch):
    monkeypatch.setattr(rearrange, "Question", lambda *_: None)
    monkeypatch.setattr(rearrange, "rooms", lambda *_: {h.BEDROOM})
    monkeypatch.setattr(rearrange, "_arrangements", lambda question, gone, some, cases: iter([some]))
    things = [h.thing("toilet", 4.5 + k, 1.0, 0, h.BEDROOM, id=f"t{k}") for k in range(many)]
    # neither what is not needed counts, though it can be moved, nor what hangs, though it is needed
    monkeypatch.setattr(rearrange.importance, "Ranks", lambda *_: SimpleNamespace(of=lambda o: 1 + (o.id != "bin")))
    things += [h.thing("bin", 4.5, 2.0, 0, h.BEDROOM, id="bin"), h.thing("mirror", 4.5, 0.1, 0, h.BEDROOM, id="m")]
    site = SimpleNamespace(floors={h.BEDROOM: box(0, 0, area, 1)}, config=WalkableConfig(drop=False))
    plans = list(rearrange.rearranged(site, SimpleNamespace(scene=things), SimpleNamespace(target=None)))
    assert bool(plans) == found and all(len(some) == min(3, many) for some in plans)


@pytest.mark.parametrize("got, wanted", [
    ({0}, "shelf"), ({1}, "robe"), ({-1, 0}, "shelf"), ({-1}, "shelf"), (set(), "shelf")])
def test_what_is_missed_in_a_room_that_is_got_into_comes_first(got, wanted):
    """A shelf in the first room and a wardrobe in the second; the floor of a doorway is of no room, which is -1."""
    home = h.home(h.thing("bookshelf", 1.0, 0.3, id="shelf"), h.thing("wardrobe", 5.5, 0.35, room=h.BEDROOM, id="robe"))
    cells = np.array([-1, 0, 1])
    site = SimpleNamespace(world=SimpleNamespace(plan=home, rooms=cells))
    now = SimpleNamespace(got=np.isin(cells, list(got)), scene=home.objects)
    assert repair._nearest(site, now, ["shelf", "robe"]) == wanted
