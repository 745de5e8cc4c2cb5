"""Plans as drawn: symbols keep to their boxes, what hangs lies over what stands, doors turn through a quarter."""

import handmade as h
import numpy as np
import pytest
import shapely
from export import sample
from matplotlib.figure import Figure
from matplotlib.patches import Arc

from apartgen.schemas.errors import BadInput
from apartgen.stages import export
from apartgen.stages.export import _drawing, _symbols
from apartgen.stages.export._pen import Pen
from apartgen.stages.export._strokes import strokes
from apartgen.stages.retrieve import furniture
from apartgen.stages.space import polygons
from apartgen.stages.things.categories import TABLE


def points(axes, patch):
    """Corners of a patch in metres; of curves, their control points' hull is enough for most."""
    path = patch.get_transform().transform_path(patch.get_path()).interpolated(1)
    corners = np.concatenate([part for part in path.to_polygons(closed_only=False) if len(part)])
    return axes.transData.inverted().transform(corners)


def test_a_rectangle_has_four_corners_and_round_ones_where_asked():
    axes = blank()
    for r in (0.0, 0.2):
        Pen(axes, 1.0, 2.0, name="it/rect").rect(-1.0, 1.0, -0.5, 0.5, r=r)
    sharp, rounded = (line.points for line in strokes(axes.figure))
    assert sorted(map(tuple, sharp.round(6).tolist())) == [(0, 1.5), (0, 2.5), (2, 1.5), (2, 2.5)]
    assert shapely.Polygon(rounded).area == pytest.approx(2 - (4 - np.pi) * 0.2**2, abs=0.01)


def blank():
    axes = Figure(figsize=(40, 40)).add_axes((0, 0, 1, 1))
    axes.set_xlim(-5, 5)
    axes.set_ylim(-5, 5)
    return axes


@pytest.mark.parametrize("name", TABLE)
def test_a_symbol_keeps_to_its_box(name):
    for d, w in (TABLE[name].size[:2], TABLE[name].min[:2], TABLE[name].max[:2]):
        axes = blank()
        _symbols.draw(Pen(axes), name, d, w)
        drawn = np.concatenate([points(axes, patch) for patch in axes.patches])
        filled = np.abs(drawn).max(0) / [d / 2, w / 2]
        assert filled.min() > 0.35 and (np.abs(drawn).max(0) < np.array([d, w]) / 2 + 0.012).all()
        turned = blank()
        _symbols.draw(Pen(turned, 1.0, -2.0, 0.5), name, d, w)
        c, s = np.cos(0.5), np.sin(0.5)
        again = np.concatenate([points(turned, patch) for patch in turned.patches])
        assert again == pytest.approx(drawn @ np.array([[c, s], [-s, c]]) + [1.0, -2.0], abs=1e-6)


def test_every_symbol_that_a_category_has_is_drawn_and_no_other():
    assert {kind.symbol for kind in TABLE.values()} | {_symbols.FITTED} == set(_symbols.SYMBOLS)


@pytest.mark.parametrize("name", ["sofa", "corner_sofa"])
def test_cushions_lie_between_back_and_arms(name):
    axes = blank()
    _symbols.draw(Pen(axes), name, *TABLE[name].size[:2])
    parts = [(patch.get_facecolor(), shapely.Polygon(points(axes, patch)).buffer(0)) for patch in axes.patches]
    frame, *rest = parts
    wood = [part for colour, part in rest if colour == frame[0]]
    cushions = [part for colour, part in rest if colour != frame[0]]
    assert len(wood) == (3 if name == "sofa" else 2) and len(cushions) >= 2
    assert shapely.union_all(wood).intersection(shapely.union_all(cushions)).area < 0.02


def _outlines(style, seed, size):
    """Points of a corner sofa as it is built, and as it is drawn."""
    asset = furniture.build("corner_sofa", style, size, seed)
    built = np.concatenate([visual.vertices for link in asset.links for visual in link.visuals])[:, :2]
    axes = blank()
    _symbols.draw(Pen(axes), "corner_sofa", *size[:2])
    return built, np.concatenate([points(axes, patch) for patch in axes.patches])


@pytest.mark.parametrize("style", furniture.styles("corner_sofa"))
@pytest.mark.parametrize("seed", range(3))
def test_the_chaise_is_drawn_where_it_is_built(style, seed):
    """A quarter of a corner sofa's box, in front and at one side, has nothing in it: the same in both."""
    d, w, height = TABLE["corner_sofa"].size
    for found in _outlines(style, seed, (d, w, height)):
        ahead = found[found[:, 0] > 0.25 * d]
        assert (ahead[:, 1] > 0.3 * w).any() and not (ahead[:, 1] < 0).any()
    for depth in (1.45, d):
        built, drawn = _outlines(style, seed, (depth, w, height))
        fronts = [found[found[:, 1] < 0, 0].max() for found in (built, drawn)]
        assert abs(fronts[0] - fronts[1]) < 0.02 and abs(fronts[0] - (min(0.98, 0.67 * depth) - depth / 2)) < 0.02


def test_what_hangs_lies_over_what_stands_and_rugs_below_all():
    things = {"rug": (1.0, 1.0), "coffee_table": (2.0, 0.5), "wardrobe": (3.0, 2.4), "ceiling_lamp": (1.0, 2.5)}
    home = h.home(*(h.thing(name, x, y, size=(0.4, 0.4, 0.02 if name == "rug" else 2.2 if name == "wardrobe" else 0.4),
                            bottom=2.1 if name == "ceiling_lamp" else 0.0) for name, (x, y) in things.items()))
    axes = _drawing.figure(home).axes[0]
    order = {}
    for name, (x, y) in things.items():
        own = [patch.get_zorder() for patch in axes.patches
               if shapely.box(x - 0.3, y - 0.3, x + 0.3, y + 0.3).covers(shapely.MultiPoint(points(axes, patch)))]
        order[name] = max(own)
        assert own
    assert order["rug"] < order["coffee_table"] < order["wardrobe"] < order["ceiling_lamp"]


@pytest.mark.parametrize("hinge", [0, 1])
@pytest.mark.parametrize("into", [h.LIVING, h.BEDROOM])
def test_a_door_is_drawn_through_the_quarter_that_it_turns(hinge, into):
    home = h.plan()
    openings = [o.model_copy(update={"hinge": hinge, "into": into}) if o.id == "door_1" else o for o in home.openings]
    home = home.model_copy(update={"openings": openings})
    axes = _drawing.figure(home).axes[0]
    (door,) = [o for o in home.openings if o.id == "door_1"]
    swing = polygons.swing(door, home)
    arcs = [patch for patch in axes.patches if isinstance(patch, Arc)]
    (own,) = [arc for arc in arcs if swing.buffer(0.03).covers(shapely.MultiPoint(points(axes, arc)))]
    assert (own.theta2 - own.theta1) % 360 == pytest.approx(90) and own.width == pytest.approx(1.8)


def test_what_a_folder_holds_is_named_and_counted(tmp_path):
    (tmp_path / "a.md").write_text("mine")
    with pytest.raises(BadInput, match="holds a.md, which no export wrote"):
        export.run(sample.home(), ["svg"], tmp_path, sample.load)
    (tmp_path / "b.md").write_text("mine")
    (tmp_path / "c.md").write_text("mine")
    with pytest.raises(BadInput, match="holds a.md and 2 more, which no export wrote"):
        export.run(sample.home(), ["svg"], tmp_path, sample.load)


def test_a_drawing_is_the_same_for_one_format_or_several(tmp_path):
    home, load = sample.home(), sample.load
    for name, formats in (("both", ["png", "svg"]), ("vector", ["svg"]), ("picture", ["png"])):
        export.run(home, formats, tmp_path / name, load)
    for file, alone in (("plan.svg", "vector"), ("plan.png", "picture")):
        assert (tmp_path / "both" / file).read_bytes() == (tmp_path / alone / file).read_bytes()
