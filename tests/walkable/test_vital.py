"""What a room is for stays in it, whatever the robot and the target ask for."""

import boxes_library as fake
import handmade as h
import numpy as np
import pytest
from crowded import FIRST, crowded, of_kind

from apartgen.schemas.errors import Unmet
from apartgen.schemas.plan import AskedObjects
from apartgen.stages.metrics import collision, doorways, outside
from apartgen.stages.walkable import WalkableConfig, importance, run, unmet

DOWN, UP = -np.pi / 2, np.pi / 2
def walk(home, library=None, **config):
    return run(home, WalkableConfig(**config), np.random.default_rng(0), (library or fake.Boxes()).of(home))


def lacking(home, after):
    """What a room was for and no longer has."""
    return [need for need in importance.needs(home)
            if sum(o.room == need.room and o.category in need.of for o in after.objects) < need.least]


@pytest.mark.parametrize("kind", list(FIRST))
@pytest.mark.parametrize("seed", range(2))
def test_a_room_keeps_what_it_is_for(seed, kind):
    home = crowded(seed, kind)
    assert importance.needs(home)
    for library, target in ((fake.Boxes(), 0.95), (fake.Empty(), 0.5)):
        result = walk(home, library, target=target, write_anyway=True)
        assert lacking(home, result) == []
        assert collision.measure(result)[0].value in (0, None) and outside.measure(result)[0].value in (0, None)
        assert doorways.measure(result)[0].value <= doorways.measure(home)[0].value


def small(*objects):
    """The flat with a bedroom of 2.2 × 3 m."""
    home = h.home(*objects)
    rooms = [room.model_copy(update={"polygon": h.rectangle(4.1, 0, 2.2, 3)}) if room.id == h.BEDROOM else room
             for room in home.rooms]
    return home.model_copy(update={"rooms": rooms})


def barred():
    """A bedroom whose wardrobe the bed bars, and neither has another place."""
    bed = h.thing("double_bed", 5.4, 1.15, UP, h.BEDROOM, size=(2.3, 1.8, 0.8), id="bed")
    size = (0.6, 2.1, 2.1)
    return small(bed, h.thing("wardrobe", 5.2, 2.69, DOWN, h.BEDROOM, size=size, id="wardrobe",
                              joints=tuple(fake.joints("wardrobe", size))))


def test_a_wardrobe_goes_before_the_only_bed():
    result = walk(barred(), fake.Empty(), target=0.2, reach=0.6)
    assert result.walkable.dropped == ["wardrobe"] and result.walkable.unreached == []


def test_what_was_asked_for_and_the_bed_can_not_both_be_had():
    home = barred()
    wish = AskedObjects(room=h.BEDROOM, category="wardrobe", count=1)
    asked = home.model_copy(update={"program": home.program.model_copy(update={"objects": [wish]})})
    with pytest.raises(Unmet, match=rf"not get to wardrobe, as {h.BEDROOM} can't do without bed; .*--no-connect"):
        walk(asked, fake.Empty(), target=0.2, reach=0.6)
    best = walk(asked, fake.Empty(), target=0.2, reach=0.6, write_anyway=True)
    assert best.walkable.dropped == [] and best.walkable.unreached == ["wardrobe"]
    config = WalkableConfig(target=0.2, reach=0.6, write_anyway=True)
    assert "does not get to wardrobe" in unmet(best, config, fake.Empty())
    assert unmet(best, config.model_copy(update={"target": 0.99}), fake.Empty()).startswith("walkable ratio 0.99")
    fine = walk(barred(), fake.Empty(), target=0.2, reach=0.6)
    assert unmet(fine, config, fake.Empty()) == ""


def test_a_bed_that_bars_the_way_becomes_a_smaller_one():
    bed = h.thing("double_bed", 5.3, 1.95, DOWN, h.BEDROOM, size=(2.1, 1.9, 1.0), id="bed")
    chest = h.chest(5.3, 0.25, UP, h.BEDROOM, id="chest")
    result = walk(small(bed, chest), target=0.2)
    (bed,) = [o for o in result.objects if o.id == "bed"]
    assert bed.category == "single_bed" and result.walkable.unreached == [] and result.walkable.dropped == []


def test_what_is_in_the_way_only_together_with_lesser_things_moves_once_they_are_gone() -> None:
    size = (0.44, 0.94, 0.86)
    home = of_kind(h.home(
        h.thing("bath", 5.58, 0.98, np.pi, h.BEDROOM, size=(0.81, 1.4, 0.59), id="bath"),
        h.thing("vanity", 5.76, -0.2, np.pi, h.BEDROOM, size=size, id="vanity",
                joints=tuple(fake.joints("vanity", size))),
        h.thing("toilet", 4.44, 0.79, 0, h.BEDROOM, size=(0.67, 0.4, 0.79), id="toilet"),
        h.thing("stool", 4.56, 0.26, 0, h.BEDROOM, size=(0.5, 0.5, 0.8), id="stool"),
    ), "bathroom")
    rooms = [room.model_copy(update={"polygon": h.rectangle(4.1, -0.69, 1.89, 2.64)}) if room.id == h.BEDROOM else room
             for room in home.rooms]
    openings = [o.model_copy(update={"hinge": int(o.id == "door_1")}) for o in home.openings if o.kind != "window"]
    home = home.model_copy(update={"rooms": rooms, "openings": openings})
    result = walk(home, fake.Empty(), target=0.2)
    assert result.walkable.unreached == [] and lacking(home, result) == []


def test_a_stand_stays_with_the_lamp_on_it_that_was_asked_for():
    """Where that meets no target, it is said as elsewhere; what carries nothing goes."""
    stands = [h.thing("nightstand", x, 0.3, UP, size=(0.4, 0.5, 0.5), id=f"stand{x}") for x in (1, 2)]
    home = h.home(*stands, h.thing("table_lamp", 2, 0.3, bottom=0.5, id="lamp"))
    assert walk(home, fake.Empty(), target=0.999).walkable.dropped == ["stand1", "stand2", "lamp"]
    wish = AskedObjects(room=h.LIVING, category="table_lamp", count=1)
    asked = home.model_copy(update={"program": home.program.model_copy(update={"objects": [wish]})})
    with pytest.raises(Unmet, match="can't be met"):
        walk(asked, fake.Empty(), target=0.999)
    assert walk(asked, fake.Empty(), target=0.999, write_anyway=True).walkable.dropped == ["stand1"]
    assert walk(asked, fake.Empty(), target=0.99).walkable.dropped == ["stand1"]
