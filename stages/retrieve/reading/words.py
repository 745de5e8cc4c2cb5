"""Which furniture a name speaks of."""

import re
from functools import cache

from apartgen.stages.things.categories import by_word

OTHER = "other"
"""Category of what the furniture vocabulary has no word for."""

EXTRA = {
    "bed double": "double_bed",
    "bed single": "single_bed",
    "bed bunk": "bunk_bed",
    "bathtub": "bath",
    "bathroom cabinet": "vanity",
    "bathroom sink": "vanity",
    "bathroom mirror": "mirror",
    "bookcase": "bookshelf",
    "cabinet bed": "nightstand",
    "cabinet television": "tv_stand",
    "desk chair": "office_chair",
    "chair desk": "office_chair",
    "computer screen": "monitor",
    "coat rack": "coat_rack",
    "kitchen bar": "island",
    "kitchen fridge": "fridge",
    "kitchen stove": "oven",
    "kitchen microwave": "microwave",
    "kitchen cabinet": "kitchen_base",
    "kitchen cabinet upper": "wall_unit",
    "kitchen cabinet upper corner": OTHER,
    "kitchen cabinet drawer": "kitchen_drawers",
    "kitchen cabinet corner": "kitchen_corner",
    "lamp round floor": "floor_lamp",
    "lamp square floor": "floor_lamp",
    "lamp round table": "table_lamp",
    "lamp square table": "table_lamp",
    "lamp square ceiling": "ceiling_lamp",
    "lamp wall": "wall_lamp",
    "lounge chair": "armchair",
    "lounge design chair": "armchair",
    "lounge sofa": "sofa",
    "lounge design sofa": "sofa",
    "lounge sofa corner": "corner_sofa",
    "lounge design sofa corner": "corner_sofa",
    "lounge sofa ottoman": "pouffe",
    "pillow": OTHER,
    "plant small": "plant",
    "side table": "side_table",
    "stool bar": "stool",
    "table coffee": "coffee_table",
    "table round": "round_table",
    "table cross": "dining_table",
    "table": "dining_table",
    "trashcan": "bin",
    "trash bin": "bin",
    "television": "tv",
    "washer dryer stacked": "washing_machine",
    "washer": "washing_machine",
    "books": OTHER,
    "doorway": OTHER,
    "wall": OTHER,
    "stairs": OTHER,
    "floor": OTHER,
    "kitchen sink": "kitchen_sink",
    "door": OTHER,
    "window": OTHER,
    "kettle": OTHER,
    "backwall": OTHER,
    "light buttons": OTHER,
    "box cabinet": "wall_unit",
    "boxcabinet": "wall_unit",
    "hingecabinet": "wall_unit",
    "slidecabinet": "wall_unit",
    "lightbuttons": OTHER,
    "studytable": "desk",
    "simpletable": "dining_table",
    "ventiontable": "workbench",
    "hinge cabinet": "wall_unit",
    "slide cabinet": "wall_unit",
    "counters": "island",
    "sink counter": "kitchen_sink",
    "box counter": "island",
    "simple table": "dining_table",
    "study table": "desk",
    "vention table": "workbench",
}


def split(name: str) -> list[str]:
    """Lower-case words of a file or model name: `loungeSofa_02` gives lounge, sofa."""
    spaced = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)
    return [word.lower() for word in re.split(r"[^A-Za-z]+", spaced) if word]


@cache
def _known() -> dict[str, str]:
    return by_word() | EXTRA


def category(name: str) -> str:
    """Category of a name: its longest known run of words, the earliest of equals; `other` without one."""
    words = split(name)
    for length in range(len(words), 0, -1):
        for start in range(len(words) - length + 1):
            run = " ".join(words[start : start + length])
            for word in (run, run.removesuffix("s")):
                if word in _known():
                    return _known()[word]
    return OTHER
