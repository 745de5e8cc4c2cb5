"""Names on plans lie on nothing, measured by what the rasteriser draws; groups of the SVG are what they are called."""

from pathlib import Path
from xml.etree import ElementTree

import handmade as h
import numpy as np
import pytest
import shapely
from export import sample
from matplotlib.backends.backend_agg import FigureCanvasAgg

from apartgen.schemas import artifact
from apartgen.schemas.walkable import Walkable
from apartgen.stages import export
from apartgen.stages.export import _drawing, _layers
from apartgen.stages.space import polygons

GOLDEN = Path(__file__).parent.parent / "golden/v2/walkable.json"
SVG = "{http://www.w3.org/2000/svg}"


def crowded():
    """The two rooms with so much in them that little floor is left."""
    things = [h.thing("coffee_table", 0.45 + 0.7 * (k % 5), 0.4 + 0.9 * (k // 5), id=f"t_{k}") for k in range(15)]
    return h.home(*things)


def homes():
    return {"sample": sample.home(), "golden": artifact.read(GOLDEN, Walkable).body, "crowded": crowded(),
            "empty": h.home()}


def corners(o):
    c, s = np.cos(o.yaw), np.sin(o.yaw)
    d, w = o.size[0] / 2, o.size[1] / 2
    return [(o.center[0] + c * x - s * y, o.center[1] + s * x + c * y) for x, y in ((d, w), (-d, w), (-d, -w), (d, -w))]


def written(home):
    """What is written, as (group, text, rectangle in metres), by the rasteriser's own measure."""
    sheet = _drawing.figure(home)
    renderer, axes = FigureCanvasAgg(sheet).get_renderer(), sheet.axes[0]
    back = axes.transData.inverted()
    for text in axes.texts:
        box = text.get_window_extent(renderer)
        ends = back.transform([(box.x0, box.y0), (box.x1, box.y1)])
        yield text.get_gid() or "", text.get_text(), shapely.box(*ends.ravel())


@pytest.mark.parametrize("name", homes())
def test_labels_lie_on_no_symbol_wall_door_or_other_text(name):
    home = homes()[name]
    rows = [row for row in written(home) if not row[0].startswith("furniture")]
    labels = [row for row in rows if row[0].startswith("labels")]
    assert {row[0] for row in labels} == {f"labels/label_{room.id}" for room in home.rooms}
    taken = [shapely.Polygon(corners(o)).buffer(-0.005) for o in home.objects]
    taken += [polygons.swing(o, home).exterior for o in home.openings if not polygons.swing(o, home).is_empty]
    taken.append(polygons.walls(home))
    for _, text, box in labels:
        assert not any(box.intersects(shape) for shape in taken), text
    for k, (group, text, box) in enumerate(rows):
        for other, its, there in rows[:k]:
            assert group == other or not box.intersects(there), (text, its)


@pytest.mark.parametrize("name", homes())
def test_every_room_is_in_the_list_with_its_number(name):
    home = homes()[name]
    texts = [(group, text) for group, text, _ in written(home) if group.startswith("list")]
    for k, room in enumerate(home.rooms, 1):
        rows = [text for group, text in texts if group == f"list/list_{room.id}"]
        floor = shapely.Polygon(room.polygon)
        x0, y0, x1, y1 = floor.bounds
        assert rows == [str(k), room.type.replace("_", " ").title(), f"{floor.area:.1f} m²",
                        f"{x1 - x0:.2f} × {y1 - y0:.2f}"]
        label = [text for group, text, _ in written(home) if group == f"labels/label_{room.id}"]
        assert label[0].split()[0] == str(k)


@pytest.mark.parametrize("name", homes())
def test_the_sheet_ends_little_beyond_its_list(name):
    sheet = _drawing.figure(homes()[name])
    renderer = FigureCanvasAgg(sheet).get_renderer()
    ends = [text.get_window_extent(renderer).x1 / sheet.dpi for text in sheet.axes[0].texts
            if (text.get_gid() or "").startswith("list")]
    assert 0.0 < sheet.get_figwidth() - max(ends) < 0.6, "inches"


@pytest.fixture(scope="module")
def drawing(tmp_path_factory):
    out = tmp_path_factory.mktemp("plan") / "out"
    export.run(sample.home(), ["svg"], out, sample.load)
    return ElementTree.parse(out / "plan.svg").getroot()


def test_text_is_text(drawing):
    texts = {"".join(one.itertext()).strip() for one in drawing.iter(f"{SVG}text")}
    assert {"Bedroom", "Bathroom"} <= texts and any("Living" in text for text in texts)


def test_every_thing_and_layer_has_its_group_once(drawing):
    ids = [one.get("id") for one in drawing.iter() if one.get("id")]
    assert len(ids) == len(set(ids))
    home = sample.home()
    layers = {one.get("id"): one for one in drawing.iter(f"{SVG}g")}
    assert {"rooms", "furniture", "sweeps", "walls", "openings", "windows", "frame", "labels", "list"} <= set(layers)
    assert {o.id for o in home.objects} <= {one.get("id") for one in layers["furniture"]}
    assert {f"label_{room.id}" for room in home.rooms} == {one.get("id") for one in layers["labels"]}


def test_groups_are_of_what_is_drawn_one_after_another():
    text = ('<svg xmlns="http://www.w3.org/2000/svg"><g id="axes">'
            '<g id="a/x"><path d="1"/></g><g id="a/x"><path d="2"/></g>'
            '<g id="a/y z"><path d="3"/></g><g id="plain"/><g id="a/x"><path d="4"/></g></g></svg>')
    axes = ElementTree.fromstring(_layers.grouped(text).partition("\n")[2])[0]
    shape = [(one.get("id"), [inner.get("id") for inner in one]) for one in axes]
    assert shape == [("a", ["x", "y_z"]), ("plain", []), ("a-2", ["x-2"])]
    assert [path.get("d") for path in axes.iter(f"{SVG}path")] == ["1", "2", "3", "4"]
