"""A home ready to be looked at: its triangles, what casts shadows, and where its light comes from."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from apartgen.schemas.plan import Opening, Plan
from apartgen.stages.scene.posed import ajar
from apartgen.stages.scene.scene import Scene
from apartgen.stages.scene.soup import Array, Index, Soup, Tracer, linear, soup, split
from apartgen.stages.space import grid, polygons
from apartgen.stages.space.grid import Grid
from apartgen.stages.things import solids
from apartgen.stages.things.asset import Link, Material
from apartgen.stages.things.body import Body
from apartgen.stages.things.categories import TABLE

HEIGHT_OF_SUN = np.radians(38.0)
ASIDE = np.radians(35.0)
"""How far the sun stands beside what most windows look to."""
CELL = 0.1
"""Of the raster that says in which room a point is, m."""
SPARE = 0.4
"""How much wider openings are taken where it is asked whether the sun can come in, m: more than walls are thick."""
GLOWING = ("bulb", "paper_shade")
"""Materials of lamps that shine by themselves."""


SUN_ABOVE = np.array([-0.46, -0.35, 0.82], np.float32)
"""The way to the sun of pictures from outside."""
FAR, SLAB = 60.0, 0.1
"""How far a ground reaches, and how thick it is, m."""


@dataclass(frozen=True)
class Lamp:
    """A light of a room, in lumens."""

    room: int
    position: Array
    lumens: float


@dataclass(frozen=True)
class Pane:
    """A window as a source of light: lower corner, its two sides, unit normal into the room, area m²."""

    room: int
    corner: Array
    across: Array
    up: Array
    normal: Array
    area: float


@dataclass(frozen=True)
class World:
    """What light is found in.

    `alpha` is how opaque triangles are, and at the end what nothing counts as, 1; `owner` of a triangle is a body's
    index; `blockers` are without glass and lamps; `glow` says which triangles shine, `faces` has their unit normals.
    `rooms` holds the index of the room for each cell of `cells`; `ways` are where sun comes in from out of doors
    (k, 6): corner, horizontal side, least and greatest height, with room to spare.
    """

    bodies: list[Body]
    every: Tracer
    blockers: Tracer
    alpha: Array
    glow: Array
    flat: Array
    faces: Array
    rooms: NDArray[np.int16]
    cells: Grid
    lamps: list[Lamp]
    panes: list[Pane]
    sun: Array
    outdoors: NDArray[np.bool_]
    ways: Array

    def room_at(self, points: Array) -> Index:
        """Index of the room at points (n, 2…); -1 in none."""
        x0, y0 = self.cells.origin
        column = ((points[:, 0] - x0) / CELL).astype(np.int64).clip(0, self.cells.shape[1] - 1)
        row = ((points[:, 1] - y0) / CELL).astype(np.int64).clip(0, self.cells.shape[0] - 1)
        found: Index = self.rooms[row, column].astype(np.int64)
        return found


@dataclass(frozen=True)
class HomeWorld(World):
    """That of a home."""

    plan: Plan


def world(scene: Scene) -> HomeWorld:
    """The home of a scene, its doors open."""
    plan = scene.home
    doors = {body.name: 1.0 for body in scene.placed if body.kind == "door" and body.category == "door"}
    bodies = ajar(scene.placed, doors)
    cells = grid.over(polygons.shell(plan), CELL)
    rooms = np.full(cells.shape, -1, np.int16)
    for i, room in enumerate(plan.rooms):
        rooms[grid.raster(polygons.floor(room), cells)] = i
    panes = _panes(plan)
    outdoors = np.array([room.base == "balcony" for room in plan.rooms])
    traced = _traced(bodies, soup(bodies))
    return HomeWorld(bodies, *traced, rooms, cells, _lamps(scene), panes, _sun(panes), outdoors, _ways(plan), plan)


def ajar_world(home: HomeWorld, scene: Scene, shares: Mapping[str, float]) -> HomeWorld:
    """The home of a scene, only these doors open, by these shares."""
    bodies = ajar(scene.placed, shares)
    every, blockers, alpha, glow, flat, faces = _traced(bodies, soup(bodies))
    return replace(home, bodies=bodies, every=every, blockers=blockers, alpha=alpha, glow=glow, flat=flat, faces=faces)


def roofless(home: HomeWorld) -> HomeWorld:
    """The same without its ceilings and what hangs from them."""
    bare = np.array([body.kind != "ceiling" and not hangs(body) for body in home.bodies])
    shown, _ = split(home.every.soup, bare[home.every.soup.owner])
    every, blockers, alpha, glow, flat, faces = _traced(home.bodies, shown)
    return replace(home, every=every, blockers=blockers, alpha=alpha, glow=glow, flat=flat, faces=faces,
                   outdoors=np.ones(len(home.plan.rooms), bool))


def open_air(bodies: list[Body], ground: Body) -> World:
    """Things under the sky, on a ground."""
    every = [*bodies, ground]
    nowhere = Grid((0.0, 0.0), (1, 1), CELL)
    return World(every, *_traced(every, soup(every)), np.full((1, 1), -1, np.int16), nowhere, [], [], SUN_ABOVE,
                 np.ones(1, bool), np.zeros((0, 6), np.float32))


def ground(middle: Array, height: float, material: Material) -> Body:
    """A ground about a place, its top at that height, m."""
    x, y = middle[:2]
    slab = solids.box((x - FAR, y - FAR, height - SLAB), (x + FAR, y + FAR, height), material)
    return Body("ground", "floor", "", "", np.zeros(3), 0.0, [Link("base", [slab], [], 0.0)])


def _traced(bodies: list[Body], every: Soup) -> tuple[Tracer, Tracer, Array, Array, Array, Array]:
    """What a world holds of its triangles."""
    alpha = np.array([m.color[3] for m in every.materials], np.float32)[every.material]
    lamp = np.array([_shines(body) for body in bodies])[every.owner]
    glowing = np.array([m.name in GLOWING for m in every.materials])[every.material] & lamp
    _, blockers = split(every, (alpha < 1) | lamp)
    alpha = np.append(alpha, np.float32(1))
    flat = linear(np.array([m.color[:3] for m in every.materials], np.float32))
    sides = every.corners[:, 1:] - every.corners[:, :1]
    faces = np.cross(sides[:, 0], sides[:, 1])
    return Tracer(every), Tracer(blockers), alpha, glowing, flat, faces / np.linalg.norm(
        faces, axis=1, keepdims=True).clip(1e-20)


def _shines(body: Body) -> bool:
    return body.category in TABLE and TABLE[body.category].lumens > 0


def hangs(body: Body) -> bool:
    """Whether it hangs under the ceiling that is taken away."""
    return body.category in TABLE and TABLE[body.category].place == "ceiling"


def _lamps(scene: Scene) -> list[Lamp]:
    index = {room.id: i for i, room in enumerate(scene.home.rooms)}
    return [Lamp(index[light.room], light.position.astype(np.float32), light.lumens)
            for light in scene.lights if light.room in index]


def _panes(plan: Plan) -> list[Pane]:
    index = {room.id: i for i, room in enumerate(plan.rooms)}
    found = []
    for o in (o for o in plan.openings if o.kind == "window" and o.rooms[0] in index):
        a, b = np.asarray(o.segment, float)
        normal, _ = polygons.face(o, plan, o.rooms[0])
        across, up = np.array([*(b - a), 0.0]), np.array([0.0, 0.0, o.head - o.sill])
        sides = [v.astype(np.float32) for v in (np.array([*a, o.sill]), across, up, np.array([*normal, 0.0]))]
        found.append(Pane(index[o.rooms[0]], sides[0], sides[1], sides[2], sides[3],
                          float(np.linalg.norm(across) * up[2])))
    return found


def _ways(plan: Plan) -> Array:
    """Every opening that leads out of doors, to a balcony too, a wall's thickness wider all about."""
    outside = {room.id for room in plan.rooms if room.base == "balcony"}
    rows = [_wider(o) for o in plan.openings if len(o.rooms) == 1 or outside & set(o.rooms)]
    return np.array(rows, np.float32).reshape(-1, 6)


def _wider(opening: Opening) -> list[float]:
    a, b = np.asarray(opening.segment, float)
    more = (b - a) / max(float(np.linalg.norm(b - a)), 1e-6) * SPARE
    return [*(a - more), *(b - a + 2 * more), opening.sill - SPARE, opening.head + SPARE]


def _sun(panes: list[Pane]) -> Array:
    """The way to the sun: beside where most of the glass looks."""
    out = -sum((pane.normal * pane.area for pane in panes), np.array([0.02, 0.01, 0.0]))
    azimuth = np.arctan2(out[1], out[0]) + ASIDE
    flat = np.cos(HEIGHT_OF_SUN)
    return np.array([np.cos(azimuth) * flat, np.sin(azimuth) * flat, np.sin(HEIGHT_OF_SUN)], np.float32)
