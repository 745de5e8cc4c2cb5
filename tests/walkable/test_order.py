"""What is left out first."""

import boxes_library as fake
import handmade as h
import numpy as np

from apartgen.schemas.plan import AskedObjects
from apartgen.stages.walkable import WalkableConfig, importance
from apartgen.stages.walkable.site import survey


def order(home, most=1):
    site = survey(home, WalkableConfig(), fake.Boxes(), importance.needs(home))
    return [o.id for o in importance.droppable(site, tuple(home.objects), most)]


def things():
    """Of every rank two or more, in no order: decoration, comfort, the only sofa and wardrobe, a bed that stays."""
    return [
        h.thing("bookshelf", 1.0, 2.7, id="shelf", size=(0.3, 0.9, 2.0)),
        h.thing("plant", 3.6, 2.6, id="low_plant", size=(0.3, 0.3, 0.5)),
        h.thing("double_bed", 5.5, 1.5, room=h.BEDROOM, id="bed"),
        h.thing("armchair", 3.0, 0.6, id="armchair", size=(0.9, 0.9, 0.9)),
        h.thing("rug", 2.0, 1.5, id="rug"),
        h.thing("plant", 0.3, 2.6, id="plant", size=(0.6, 0.6, 1.5)),
        h.thing("wardrobe", 6.5, 2.6, room=h.BEDROOM, id="wardrobe", size=(0.6, 1.2, 2.0)),
        h.thing("coffee_table", 2.0, 1.5, id="table", size=(0.6, 1.2, 0.4)),
        h.thing("sofa", 0.5, 1.5, id="sofa", size=(0.9, 1.8, 0.8)),
    ]


def test_the_least_important_goes_first_and_of_these_the_largest():
    rank = {"low_plant": 0, "plant": 0, "table": 1, "armchair": 1, "shelf": 1, "wardrobe": 2, "sofa": 2, "bed": 3}
    area = {"low_plant": 0.09, "plant": 0.36, "table": 0.72, "armchair": 0.81, "shelf": 0.27, "wardrobe": 0.72,
            "sofa": 1.62}
    home = h.home(*things())
    site = survey(home, WalkableConfig(), fake.Boxes(), importance.needs(home))
    ranks = importance.Ranks(site, tuple(home.objects))
    assert {o.id: ranks.of(o) for o in home.objects if o.id in rank} == rank
    expected = ["plant", "low_plant", "armchair", "table", "shelf", "sofa", "wardrobe"]
    assert expected == sorted(area, key=lambda name: (rank[name], -area[name]))
    rng = np.random.default_rng(0)
    for _ in range(5):
        shuffled = h.home(*(home.objects[i] for i in rng.permutation(len(home.objects))))
        assert order(shuffled, 2) == order(shuffled, 3) == expected
        assert order(shuffled) == expected[:-2] and order(shuffled, 0) == expected[:2]


def test_what_is_as_large_and_as_important_goes_by_name():
    plants = [h.thing("plant", x, 2.6, id=name) for name, x in (("b", 1.0), ("c", 2.0), ("a", 3.0))]
    assert order(h.home(*plants)) == ["a", "b", "c"]


def test_what_was_asked_for_stays():
    home = h.home(*things())
    wish = AskedObjects(room=h.LIVING, category="armchair", count=1)
    asked = home.model_copy(update={"program": home.program.model_copy(update={"objects": [wish]})})
    assert order(asked) == [name for name in order(home) if name != "armchair"]
    counted = home.model_copy(update={"program": home.program.model_copy(update={"counts": {h.LIVING: 6}})})
    assert order(counted, 2) == ["wardrobe"]
    # Of two armchairs one was asked for: the other may go.
    second = h.home(*things(), h.thing("armchair", 1.0, 0.6, id="second", size=(0.8, 0.8, 0.9)))
    both = second.model_copy(update={"program": home.program.model_copy(update={"objects": [wish]})})
    assert {"armchair", "second"} <= set(order(both))


def lamps(*below):
    """The things above with a table lamp on each of some side tables, and a programme that asks for so many."""
    stands = [h.thing("side_table", x, 0.4, id=f"stand{x:g}", size=(0.4, 0.4, 0.5)) for x in below]
    on = [h.thing("table_lamp", x, 0.4, bottom=0.5, id=f"lamp{x:g}").model_copy(update={"on": f"stand{x:g}"})
          for x in below]
    return h.home(*things(), *stands, *on)


def lit(home, count):
    wish = AskedObjects(room=h.LIVING, category="table_lamp", count=count)
    return home.model_copy(update={"program": home.program.model_copy(update={"objects": [wish]})})


def test_what_carries_what_was_asked_for_stays():
    """Leaving out the table would take the lamp along."""
    assert "stand2" in order(lamps(2)) and "stand2" not in order(lit(lamps(2), 1), 2)
    assert {"stand2", "stand3"} <= set(order(lit(lamps(2, 3), 1)))
    site = survey(lit(lamps(2), 1), WalkableConfig(), fake.Boxes())
    scene = tuple(lit(lamps(2), 1).objects)
    assert importance.sparable([o for o in scene if o.id == "stand2"], scene, site) == []


def test_of_several_that_may_go_no_more_go_at_once_than_were_not_asked_for():
    home = lit(lamps(1, 2, 3), 2)
    site, scene = survey(home, WalkableConfig(), fake.Boxes()), tuple(home.objects)
    loose = importance.droppable(site, scene)
    assert {"stand1", "stand2", "stand3"} <= {o.id for o in loose}
    together = [o.id for o in importance.at_once(loose, scene, site)]
    assert together == [o.id for o in loose if o.id not in ("stand2", "lamp2", "stand3", "lamp3")]
