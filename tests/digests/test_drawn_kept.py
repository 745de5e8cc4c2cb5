"""Symbols of plans, doors and windows in every design, and drawings that other programs read, as they were."""

import numpy as np
import pytest
from digests import kept
from export import sample

from apartgen.stages import export, retrieve
from apartgen.stages.export import _symbols
from apartgen.stages.retrieve import furniture
from apartgen.stages.retrieve.matching.config import RetrieveConfig
from apartgen.stages.scene import leaves, sashes
from apartgen.stages.scene.scene import Scene
from apartgen.stages.things import palettes
from apartgen.stages.things.asset import Material

SIDES = ((0.6, 0.6), (0.9, 2.0), (2.1, 1.3), (0.35, 0.5), (0.6, 3.1))
DOORS = ((0.1, 0.9, 2.05), (0.12, 0.45, 2.1), (0.08, 1.3, 1.5), (0.1, 0.8, 1.1))
HOLES = ((0.3, 1.2, 1.8), (0.55, 0.9, 2.2), (1.0, 0.0, 2.3), (1.9, 0.8, 2.1))
LOOKS = ("linetype", "ltscale", "thickness", "char_height", "attachment_point", "height")
PLACES = ("start", "end", "center", "radius", "start_angle", "end_angle", "defpoint", "defpoint2", "defpoint3")


class Noted:
    """A pen that draws nothing, and keeps what it was told."""

    def __init__(self):
        self.told = []

    def __getattr__(self, name):
        return lambda *points, **how: self.told.append([name, points, sorted(how.items())])


@pytest.mark.parametrize("part", range(4))
def test_symbols(part):
    found = {}
    for name in sorted(_symbols.SYMBOLS)[part::4]:
        pen = Noted()
        for d, w in SIDES:
            _symbols.SYMBOLS[name](pen, d, w)
        found[name] = pen.told
    kept.same("export", f"symbols {part}", found)


@pytest.mark.parametrize("kind", furniture.BUILDING)
def test_doors_and_windows_as_furniture(kind):
    found = {f"{style} {k}": furniture.build(kind, style, size, k)
             for style in furniture.styles(kind) for k, size in enumerate(DOORS)}
    kept.same("retrieve", f"building {kind}", found)


def test_designs():
    """Of leaves and windows, some of them narrow or low."""
    wood, corner = Material("wood", (0.5, 0.4, 0.3, 1.0), 0.6), np.array([-0.02, -0.4, 0.0])
    kept.same("floor", "designs", {
        **{f"leaf {name}": [leaves.leaf(name, corner, corner + [0.04, width, tall], wood) for _, width, tall in DOORS]
           for name in (*leaves.DESIGNS, "nothing")},
        **{f"window {name}": [sashes.window(name, sashes.Hole(half, low, high, 0.1)) for half, low, high in HOLES]
           for name in (*sashes.DESIGNS, "nothing")}})


@pytest.mark.parametrize("seed", range(3))
def test_other_finishes(seed):
    """A home of the building alone, its doors, windows and walls in other designs."""
    home = kept.home(kept.HOMES[seed % 2])
    bare = home.model_copy(update={"finishes": palettes.drawn(home.rooms, np.random.default_rng(seed)),
                                   "objects": home.objects[seed::4]})
    bare = bare.model_copy(update={"objects": [o.model_copy(update={"on": None}) for o in bare.objects]})
    found = retrieve.run(bare, RetrieveConfig(), kept.lane("finishes", str(seed)))
    scene = Scene(found, kept.load)
    kept.same("floor", f"finishes {seed}", {
        "objects": found.objects, "bodies": [[one.name, one.kind, [
            [link.name, link.colliders, [[mesh.vertices, mesh.faces, mesh.material] for mesh in link.visuals]]
            for link in one.links]] for one in scene.bodies]})


def told(entity):
    """Where a line, a text or a block of a drawing is, on which layer."""
    kind, dxf = entity.dxftype(), entity.dxf
    found = [kind, dxf.layer, *(dxf.get(name) for name in LOOKS if dxf.is_supported(name))]
    if kind == "LWPOLYLINE":
        found.append([bool(entity.closed), np.array(entity.get_points("xy"))])
    elif kind == "INSERT":
        at = [*dxf.insert, dxf.get("xscale", 1.0), dxf.get("yscale", 1.0), dxf.get("rotation", 0.0)]
        found.append([dxf.name, np.array(at, float), [[one.dxf.tag, one.dxf.text] for one in entity.attribs]])
    elif kind in ("MTEXT", "TEXT"):
        found.append([entity.plain_text() if kind == "MTEXT" else dxf.text, np.array(dxf.insert, float)])
    else:
        found.append([np.array(dxf.get(name), float) for name in PLACES if dxf.hasattr(name)])
    return found


@pytest.mark.parametrize("name", ["sample", "studio"])
def test_drawings(name, tmp_path):
    """DXF, which has dates and ids: its entities and its blocks."""
    ezdxf = pytest.importorskip("ezdxf")
    home, load = (sample.home(), sample.load) if name == "sample" else (kept.home(name), kept.load)
    made = export.run(home, ["dxf"], tmp_path / "out", load)
    (path,) = (file.path for file in made.files if file.path.endswith(".dxf"))
    doc = ezdxf.readfile(tmp_path / "out" / path)
    kept.same("export", f"dxf {name}", {
        "space": [told(one) for one in doc.modelspace()],
        "blocks": {block.name: [told(one) for one in block] for block in doc.blocks if block.name[0] != "*"},
        "layers": sorted([layer.dxf.name, layer.dxf.color, layer.dxf.linetype] for layer in doc.layers),
        "units": [doc.header["$INSUNITS"], doc.dxfversion]})
