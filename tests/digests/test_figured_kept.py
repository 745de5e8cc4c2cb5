"""Shapes for engines, tables of figures, and what films and balconies are asked, as it was."""

import numpy as np
import pytest
from digests import kept

from apartgen.schemas.metrics import Metrics, Value
from apartgen.schemas.render import Film, Shown
from apartgen.stages import qa, render, seeds
from apartgen.stages.export import _masks, _primitive, _randomized, _thor
from apartgen.stages.metrics import _table
from apartgen.stages.qa.config import QaConfig
from apartgen.stages.render.config import RenderConfig
from apartgen.stages.retrieve.matching import outdoors
from apartgen.stages.retrieve.matching.config import RetrieveConfig
from apartgen.stages.retrieve.matching.table import Table
from apartgen.stages.scene.scene import Scene
from apartgen.stages.things.asset import Collider
from apartgen.stages.things.categories import TABLE

pytestmark = pytest.mark.wide


def test_hulls_made_simple():
    """Boxes, prisms, balls and plates by chance, turned and cut off."""
    found = []
    for seed in range(60):
        rng = np.random.default_rng(seed)
        points = rng.normal(size=(rng.integers(4, 30), 3)) * rng.choice([0.05, 0.3, 1.0], 3)
        if seed % 4 == 0:
            turn = np.linspace(0, 2 * np.pi, 13)[:-1]
            ring = np.stack([np.cos(turn), np.sin(turn)], 1) * rng.uniform(0.1, 0.4)
            points = np.concatenate([np.c_[ring, np.full(12, z)] for z in (0.0, rng.uniform(0.05, 0.9))])
        elif seed % 4 == 1:
            points = np.stack(np.meshgrid(*[[0.0, side] for side in rng.uniform(0.02, 1, 3)]), -1).reshape(-1, 3)
        elif seed % 4 == 2:
            points = points / np.linalg.norm(points, axis=1, keepdims=True) * 0.2
        turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
        turn = np.eye(3) if seed % 3 == 0 else turn * np.sign(np.linalg.det(turn))
        found.append(_primitive.simple(Collider("hull", rng.normal(size=3), np.ptp(points, axis=0), turn, points)))
    kept.same("export", "hulls made simple", {"found": found})


@pytest.mark.parametrize("name", kept.HOMES[:2])
def test_bodies_for_engines(name):
    scene = Scene(kept.home(name), kept.load)
    bodies = scene.bodies
    kept.same("export", f"bodies {name}", {
        "masks": _masks.masks(bodies), "randomized": [[
            body.name, [[link.mass, link.friction] for link in body.links], body.motions]
            for body in _randomized.randomized(scene, 3)],
        "primitive": [[link.colliders for link in body.links] for body in _primitive.primitive(bodies[::8])]})


def test_assets_of_another_program():
    """Things of which it has some a little larger, smaller, or none."""
    found = {}
    for seed, name in enumerate(kept.HOMES):
        home, rng = kept.home(name), np.random.default_rng(seed)
        sizes = [np.multiply(o.size, rng.choice([0.7, 0.9, 1.0, 1.05, 1.4], 3)).tolist() for o in home.objects]
        known = [_thor.Model(f"m{k}", str(_thor.type_of(o.category)), tuple(size))
                 for k, (o, size) in enumerate(zip(home.objects, sizes))]
        found[name] = [_thor.alike(o, known) for o in home.objects] + [_thor.dressed(home.objects, known)]
    kept.same("export", "assets of another program", found)


def test_tables_of_figures():
    found = {}
    for seed in range(12):
        rng = np.random.default_rng(seed)
        names = ["Col_obj", "R_out", "area", *(f"{kind}{k}" for kind in (
            _table.FREQUENCY, _table.FAULT, _table.LACK) for k in range(14))]
        measured = [Metrics(notes=["a note"], values=[
            Value(name=name, version=str(version), of=str(rng.choice(["apartment", "bedroom"])), unit="%",
                  value=None if rng.random() < 0.1 else float(rng.choice([0, 0.004, 0.01, 0.3, 12]) * rng.normal()),
                  n=None if rng.random() < 0.2 else int(rng.integers(1, 9)))
            for name in names for version in ("real", "generated", "b")]) for _ in range(1 + seed % 4)]
        rows = _table.table(measured, rng, ("apartment", "bedroom")[: 1 + seed % 2])
        pairs = [(float(v), float(w)) for v, w in rng.uniform(0.1, 2, (seed % 3, 2))]
        found[str(seed)] = [rows, _table.markdown(rows, seed), _table.side_by_side(measured[0]),
                            _table.averaged(measured[0].values[0], pairs)]
    kept.same("metrics", "tables", found)


def test_nearest_assets():
    found, kinds = [], ["sofa", "wardrobe", "chair"]
    for seed in range(40):
        rng = np.random.default_rng(seed)
        names = rng.choice(kinds, 30).tolist()
        sizes = np.array([TABLE[name].size for name in names]) * rng.uniform(0.8, 1.2, (30, 3))
        table = Table(names, sizes, rng.normal(size=(30, 32)), rng.random(30) < 0.5)
        size, latent = np.multiply(TABLE[kinds[seed % 3]].size, rng.uniform(0.9, 1.1, 3)), rng.normal(size=32)
        config = RetrieveConfig(tolerance=float(rng.choice([0.05, 0.15, 0.4])), static_cost=float(seed % 4))
        for limit in (None, size * rng.uniform(0.8, 1.1, 3)):
            found.append(table.nearest(kinds[seed % 3], size, latent if seed % 5 else [], limit, config))
        found.append(table.nearest("piano", size, latent, None, config))
    kept.same("retrieve", "nearest", {"found": found})


def test_what_hangs_over_a_railing():
    """A wall lamp anywhere on the edge of a balcony, with other things in its way."""
    home, found = kept.home("studio"), []
    (room,) = (one for one in home.rooms if one.base == "balcony")
    lamp = next(o for o in home.objects if not o.joints)
    corners = np.asarray(room.polygon)
    for seed in range(40):
        rng, some = np.random.default_rng(seed), [o for o in home.objects if o.room == room.id][: seed % 3]
        for _ in range(1 + seed % 3):
            k = int(rng.integers(len(corners)))
            a, b = corners[k], corners[(k + 1) % len(corners)]
            inward = np.array([a[1] - b[1], b[0] - a[0]]) / np.linalg.norm(b - a)
            x, y = a + rng.uniform(0, 1) * (b - a) + 0.1 * inward
            some.append(lamp.model_copy(update={
                "id": f"lamp_{len(some)}", "category": "wall_lamp", "room": room.id, "on": "wall",
                "center": (x, y, float(rng.choice([0.5, 1.8, 2.3]))), "size": (0.2, float(rng.uniform(0.1, 0.9)), 0.3),
                "yaw": float(np.arctan2(inward[1], inward[0]))}))
        found.append(outdoors.hung(some, home))
    kept.same("retrieve", "over a railing", {"found": found})


def test_questions_of_films(tmp_path):
    """Of films that were never taken, in whatever order they go through rooms."""
    home = kept.home("flat")
    config = RenderConfig(width=64, height=48, views=1, frames=2, points=0, kind=["eye"])
    views, found = render.run(home, config, seeds.drawn(2, "films"), tmp_path / "views", kept.load), {}
    for seed in range(8):
        rng, frames, rooms = np.random.default_rng(seed), [], [room.id for room in home.rooms]
        way = rng.permutation(rooms).tolist()
        some = rng.permutation([thing.number for thing in views.instances])[:25].tolist()
        for k in range(200):
            seen = [(n, int(rng.uniform(7, 9) * (k - 8 * j))) for j, n in enumerate(some) if 0 < k - 8 * j < 30]
            frames.append(Shown(seconds=k / 5, room=way[k // (9 + 3 * seed) % len(way)], visible=seen))
        film = Film(file="walk.mp4", rate=5, width=64, height=48, frames=frames)
        asked = qa.run(home, views.model_copy(update={"film": film}), QaConfig(each=4), kept.lane("films", str(seed)))
        found[str(seed)] = [one for one in asked if one.videos]
    assert all(found.values())
    kept.same("qa", "films", found)
