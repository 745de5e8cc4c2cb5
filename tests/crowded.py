"""The flat worked out by hand, its second room of any kind and full of furniture."""

import boxes_library as fake
import handmade as h
import numpy as np
import shapely

from apartgen.stages.space import boxes, polygons
from apartgen.stages.things import categories

ROOM = shapely.Polygon(h.rectangle(4.1, 0, 3, 3))
FIRST = {
    "bedroom": ["double_bed", "wardrobe", "chest", "nightstand"], "study": ["desk", "bookshelf"],
    "bathroom": ["toilet", "vanity", "shower", "bath", "washing_machine"],
    "kitchen": ["kitchen_sink", "hob", "fridge", "oven", "dining_table"],
    "living_room": ["sofa", "armchair", "sideboard", "tv_stand"], "dining_room": ["dining_table", "chair", "chair"],
}
"""What a room of a type gets first, by which it is crowded."""


def crowded(seed, kind):
    """The flat with its second room of some kind, full of what such rooms hold."""
    rng = np.random.default_rng(seed)
    doors = [polygons.clearance(o, h.plan(), 0.3) for o in h.plan().openings]
    more = sorted(name for name, c in categories.TABLE.items() if not c.like and kind in c.rooms and c.place == "floor")
    kept = []
    for name in FIRST[kind] + rng.choice(more, 6).tolist():
        for _ in range(30):
            size = tuple(rng.uniform(categories.TABLE[name].min, categories.TABLE[name].size))
            x, y, yaw = rng.uniform(4.1, 7.1), rng.uniform(0, 3), float(rng.integers(4) * np.pi / 2)
            about = {"id": f"o{len(kept)}", "size": size, "joints": tuple(fake.joints(name, size))}
            item = h.thing(name, x, y, yaw, h.BEDROOM, **about)
            area, others = boxes.footprints(boxes.of([item]))[0], boxes.footprints(boxes.of(kept))
            if ROOM.covers(area) and not any(area.intersects(other) for other in (*doors, *others)):
                kept.append(item)
                break
    return of_kind(h.home(*kept), kind)


def of_kind(home, kind):
    rooms = [room.model_copy(update={"type": kind}) if room.id == h.BEDROOM else room for room in home.rooms]
    return home.model_copy(update={"rooms": rooms})
