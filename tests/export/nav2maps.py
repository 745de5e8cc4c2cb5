"""Nav2's maps read as map_server reads them."""

import numpy as np
import yaml
from PIL import Image
from shapely import contains_xy
from shapely.ops import unary_union

from apartgen.stages.robot import reach
from apartgen.stages.space import footprints, polygons

KEYS = {"image", "mode", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"}


def read(folder, name):
    """Cells as the trinary mode has them: 0 free, 100 occupied, -1 unknown; cell centres x, y; the YAML."""
    about = yaml.safe_load((folder / f"{name}.yaml").read_text())
    assert set(about) == KEYS and about["mode"] == "trinary" and about["negate"] == 0
    assert 0 < about["free_thresh"] < about["occupied_thresh"] < 1 and about["resolution"] > 0
    assert len(about["origin"]) == 3 and all(isinstance(v, float) for v in about["origin"])
    assert "/" not in about["image"] and (folder / about["image"]).read_bytes()[:3] == b"P5\n"
    grey = np.asarray(Image.open(folder / about["image"]))[::-1]
    share = (255 - grey) / 255
    cells = np.where(share > about["occupied_thresh"], 100, np.where(share < about["free_thresh"], 0, -1))
    x, y = (about["origin"][k] + (np.arange(grey.shape[1 - k]) + 0.5) * about["resolution"] for k in (0, 1))
    return cells, x, y, about


def free_ratios(folder, home):
    """Free share of the rooms' floors: by the map's cells, and exactly, R_walkable of what is in the map's band."""
    cells, x, y, about = read(folder, "map")
    floors = unary_union(list(polygons.floors(home).values()))
    inside = contains_xy(floors, *np.meshgrid(x, y))
    measured = (cells[inside] == 0).sum() * about["resolution"] ** 2 / floors.area
    return measured, footprints.walkable_ratio(floors, [o for o in home.objects if reach.in_the_way(o)])
