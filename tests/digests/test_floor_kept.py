"""What stages share: shapes, robots' floors, scenes, things, types of artifacts, files that are read; as they were."""

import json
from pathlib import Path

import boxes_library as fake
import numpy as np
import pytest
import shapely
from crowded import crowded
from digests import kept
from export import sample

from apartgen.schemas import artifact, consistency
from apartgen.schemas.plan import Plan
from apartgen.stages.robot import handling, reach, wedged
from apartgen.stages.scene.scene import Scene
from apartgen.stages.space import boxes, convex, footprints, graphs, grid, polygons, sweeps
from apartgen.stages.things import (
    body,
    carrying,
    categories,
    finishes,
    grasps,
    latents,
    materials,
    palettes,
    receptacles,
)

pytestmark = pytest.mark.wide
HOMES = {name: lambda name=name: kept.home(name) for name in kept.HOMES} | {
    f"crowded {kind}": lambda kind=kind: opening(kind) for kind in ("bedroom", "kitchen", "living_room")}


def opening(kind):
    home = crowded(5, kind)
    fake.Boxes().of(home)
    return home


def drawn(rng, n=40):
    return boxes.Boxes(rng.uniform(-2, 2, (n, 3)), rng.uniform(0.2, 1.5, (n, 3)), rng.uniform(-3, 3, n))


def test_boxes():
    a, b = drawn(np.random.default_rng(0)), drawn(np.random.default_rng(1))
    points = np.random.default_rng(2).uniform(-2, 2, (30, 2))
    kept.same("floor", "boxes", {
        "penetration": boxes.penetration(a, b), "overlap": boxes.overlap_area(a, b), "iou": boxes.iou(a, b),
        "gap": boxes.gap(a, b), "distance": boxes.distance(points, a), "local": boxes.local(points, a),
        "meeting": list(boxes.meeting(a)), "footprints": list(boxes.footprints(a)),
        "spread": boxes.spread(a, -a.size / 3, a.size)})


@pytest.mark.parametrize("name", HOMES)
def test_floors(name):
    home = HOMES[name]()
    world = reach.space(home)
    doors = [o for o in home.openings if o.kind in polygons.PASSAGES]
    cells = reach.free(world, home.objects)
    movable = [o for o in home.objects if handling.joints(o)]
    kept.same("floor", f"floors {name}", {
        "shell": polygons.shell(home), "walls": polygons.walls(home), "free": polygons.free_floor(home),
        "inward": polygons.inward(home), "before": [polygons.clearance(o, home) for o in home.openings],
        "leaves": [polygons.leaf(o, home, turn) for o in doors for turn in (0.3, 1.2)],
        "swings": sweeps.door_swings(home),
        "space": world, "cells": cells, "survey": reach.survey(world, home.objects),
        "parts": [reach.part(world, [room.id], cells) for room in home.rooms[:3]],
        "standing": [handling.standing(o, joint, world.grid, 0.25, cells) for o in movable
                     for joint in handling.joints(o)],
        "ratio": [footprints.walkable_ratio(polygons.floor(room), home.objects) for room in home.rooms],
        "plain": footprints.plain_ratio(polygons.free_floor(home), home.objects),
        "swept": sweeps.extended(home.objects), "published": sweeps.published(home.objects),
        "opened": sweeps.opened(home.objects), "carried": carrying.told(home.objects, home.height),
        "graph": graphs.of_plan(home),
        "alike": graphs.edge_similarity(graphs.of_plan(home), graphs.of_program(home.program)),
        "faults": list(consistency.faults(home))})


def test_rasters():
    ring = shapely.Polygon([(0, 0), (5, 0), (5, 4), (2.5, 2.5), (0, 4)], [[(1, 1), (2, 1), (2, 2), (1, 2)]])
    cells = grid.over(ring, 0.07)
    free = grid.open_to(ring, cells, 0.3)
    kept.same("floor", "rasters", {
        "cells": cells, "inside": grid.raster(ring, cells), "open": free,
        "mitre": grid.open_to(ring, cells, 0.3, "mitre"),
        "near": grid.near(drawn(np.random.default_rng(3), 8), cells, 0.2), "parts": grid.connected(free),
        "largest": grid.largest(free), "finer": grid.finer(cells, 3, ring)})


@pytest.mark.parametrize("name", kept.HOMES)
def test_scenes(name):
    """Bodies with their weights, what opens in them and where a hand takes hold."""
    scene = Scene(kept.home(name), kept.load)
    links = [link for one in scene.bodies for link in one.links]
    moving = [(one.links[0], link) for one in scene.bodies for link in one.links if link.joint]
    kept.same("floor", f"scene {name}", {
        "bodies": [(one.name, one.kind, one.position, one.yaw, [link.joint for link in one.links])
                   for one in scene.bodies],
        "inertia": [(body.inertia(link), body.counterbalanced(link)) for link in links],
        "swept": [convex.swept(convex.of(link.colliders), link.joint) for _, link in moving if link.colliders],
        "meet": [convex.meet(convex.moved(convex.of(link.colliders), link.joint, link.joint.range[1]),
                             convex.of(base.colliders), 0.002)
                 for base, link in moving if link.colliders and base.colliders],
        "wedged": wedged.wedged([one for one in scene.bodies if one.kind == "object"]),
        "shell": [one for one in scene.bodies if one.kind != "object"][:12],
        "holds": [grasps.holds(link) for _, link in moving]})


def test_assets():
    ids = sorted({(o.asset.library, o.asset.id) for name in kept.HOMES for o in kept.home(name).objects})[::3]
    kept.same("floor", "assets", {id: receptacles.receptacles(kept.load(library, id)) for library, id in ids})


def test_things():
    home = kept.home("flat")
    kept.same("floor", "things", {
        "table": categories.TABLE, "groups": categories.groups(), "words": categories.by_word(),
        "reach": [categories.reach(name, kind.size) for name, kind in categories.TABLE.items()],
        "latents": latents.index(), "finishes": palettes.drawn(home.rooms, np.random.default_rng(3)),
        "floors": [finishes.floor(room, home) for room in home.rooms],
        "walls": [finishes.wall(room, home) for room in home.rooms],
        "doors": [finishes.joinery(o, home) for o in home.openings]})


@pytest.mark.parametrize("name", materials.textures())
def test_textures(name):
    image = np.asarray(materials.texture(name, 64), float)
    squares = image.reshape(8, 8, 8, 8, -1).mean((1, 3)) if image.ndim == 3 else image.reshape(8, 8, 8, 8).mean((1, 3))
    kept.same("floor", f"texture {name}", {"shades": np.floor(squares / 6 + 0.3137).astype(int)})


def test_types_of_artifacts():
    kept.same("floor", "types", {kind: artifact.json_schema(kind) for kind in artifact.BODIES})


def spoiled():
    """A home's body with each of its leaves in turn wrong, every hundredth."""
    body_ = json.loads(artifact.finish(kept.home("studio"), artifact.Made(by="test", seed=1))[0])["body"]
    paths = list(leaves(body_))
    for path in paths[::97]:
        for wrong in (-1, "x", None):
            yield path, wrong, set_at(body_, path, wrong)


def leaves(value, path=()):
    children = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, child in children:
        yield from leaves(child, (*path, key)) if isinstance(child, dict | list) and child else [(*path, key)]


def set_at(value, path, wrong):
    if not path:
        return wrong
    copy = dict(value) if isinstance(value, dict) else list(value)
    copy[path[0]] = set_at(copy[path[0]], path[1:], wrong)
    return copy


def test_what_is_refused():
    found = {}
    for path, wrong, one in spoiled():
        try:
            read = Plan.model_validate({name: one[name] for name in Plan.model_fields if name in one})
            found[f"{path} {wrong}"] = [str(fault) for fault in consistency.faults(read)]
        except ValueError as error:
            found[f"{path} {wrong}"] = artifact.first_fault(error)[:80]
    kept.same("floor", "refused", {"all": list(found.items())})


def test_what_we_write_is_read(tmp_path):
    from apartgen.stages import export
    from apartgen.stages.retrieve.matching import indexing

    export.run(sample.home(), ["urdf", "sdf", "mjcf", "glb"], tmp_path / "out", sample.load)
    found = [one for kind in ("folder", "simobjects") for one in indexing.read(tmp_path / "out", kind)]
    links = {id: getattr(one, "links", []) for id, one in found}
    kept.same("floor", "read", {id: [[link.name, [[mesh.vertices, mesh.faces] for mesh in link.visuals], link.colliders,
                                      link.mass, link.joint] for link in some] for id, some in links.items()})


def test_rooms_of_data_sets(tmp_path: Path):
    from layout.datasets import test_importers as made

    from apartgen.stages.layout.datasets import _arrays, front3d, procthor, ssr
    from apartgen.stages.layout.datasets import boxes as atiss

    (tmp_path / "room.json").write_text(json.dumps({"scene": made.SSR, "split": "val"}))
    for name in "fpb":
        (tmp_path / name).mkdir()
    (tmp_path / "f" / "house.json").write_text(json.dumps(made.front3d_house()))
    (tmp_path / "f" / "model_info.json").write_text(json.dumps([
        {"model_id": "bed", "super-category": "Bed", "category": "King-size Bed"}]))
    made.npz(tmp_path / "b", "house_MasterBedroom-1")
    names = ["double_bed", "pendant_lamp", "start", "end"]
    (tmp_path / "b" / "dataset_stats.txt").write_text(json.dumps({"class_labels": names}))
    homes = [*ssr.homes(tmp_path / "room.json"), *front3d.homes(tmp_path / "f"),
             *procthor.homes(made.procthor_files(tmp_path / "p")), *atiss.homes(tmp_path / "b")]
    _arrays.write_corpus(tmp_path / "c.npz", [(home, k) for k, home in enumerate(homes)])
    kept.same("floor", "data sets", {str(k): home for k, home in enumerate(homes)} | {"corpus": tmp_path / "c.npz"})


def test_pictures_of_furniture():
    from apartgen.stages.retrieve.preview.render import pair

    ids = [o.asset.id for o in kept.home("studio").objects if o.joints][:2]
    kept.same("floor", "furniture", {id: [np.floor(picture[::8, ::8] / 12 + 0.3137).astype(int)
                                          for picture in pair(kept.load("parametric", id), 64)] for id in ids})
