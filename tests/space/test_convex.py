"""Convex solids against linear programming, shapely and trimesh."""

import numpy as np
import pytest
import shapely
import trimesh
from scipy.optimize import linprog

from apartgen.schemas.retrieve import Joint
from apartgen.stages.space import convex
from apartgen.stages.things.asset import Collider


def hull(points) -> Collider:
    return Collider("hull", np.zeros(3), np.ones(3), vertices=np.asarray(points, float))


def box(center, size, turn=None) -> Collider:
    return Collider("box", np.array(center, float), np.array(size, float), np.eye(3) if turn is None else turn)


def have_a_point_in_common(a: np.ndarray, b: np.ndarray) -> bool:
    """Whether weights of the corners exist under which both have the same middle."""
    equal = np.block([[a.T, -b.T], [np.ones(len(a)), np.zeros(len(b))], [np.zeros(len(a)), np.ones(len(b))]])
    return linprog(np.zeros(len(a) + len(b)), A_eq=equal, b_eq=[0, 0, 0, 1, 1]).status == 0


@pytest.mark.parametrize("seed", range(40))
def test_solids_meet_where_they_have_a_point_in_common(seed: int) -> None:
    rng = np.random.default_rng(seed)
    a, b = (rng.normal(size=(rng.integers(4, 10), 3)) * rng.uniform(0.2, 1, 3) + rng.uniform(-0.7, 0.7, 3)
            for _ in range(2))
    assert convex.meet(convex.of([hull(a)]), convex.of([hull(b)]), 0.0) is have_a_point_in_common(a, b)


@pytest.mark.parametrize("seed", range(12))
def test_solids_meet_within_the_distance_that_shapely_finds(seed: int) -> None:
    """Prisms over turned rectangles: apart in plan, in height, or both."""
    rng = np.random.default_rng(seed)
    solids, plans, spans = [], [], []
    for k in range(2):
        plan = shapely.affinity.rotate(shapely.box(0, 0, *rng.uniform(0.2, 1, 2)), rng.uniform(0, 360))
        plan = shapely.affinity.translate(plan, k * rng.uniform(0.5, 1.5), 0)
        low, high = np.sort(rng.uniform(0, 1, 2)) + k * rng.uniform(0, 1)
        corners = shapely.get_coordinates(plan)[:4]
        solids.append(convex.of([hull([[x, y, z] for z in (low, high) for x, y in corners])]))
        plans.append(plan)
        spans.append((low, high))
    up = max(spans[1][0] - spans[0][1], spans[0][0] - spans[1][1], 0.0)
    apart = float(np.hypot(plans[0].distance(plans[1]), up))
    # Where neither a face nor an axis parts them best, they may count as a little closer.
    assert apart == 0 or not convex.meet(*solids, 0.97 * apart)
    assert convex.meet(*solids, apart + 1e-4) and convex.meet(*solids[::-1], apart + 1e-4)


def test_any_of_many_pairs_is_enough() -> None:
    rng = np.random.default_rng(0)
    row = convex.of([box([x, 0, 0], [0.5, 0.5, 0.5]) for x in range(40)])
    for x in rng.uniform(0, 39, 20):
        one = convex.of([box([x, 0, 0], [0.1, 0.1, 0.1])])
        nearest = abs(x - round(x)) - 0.3
        assert convex.meet(row, one, 0.0) is bool(nearest < 0) and convex.meet(one, row, nearest + 1e-6)
    assert not convex.meet(row, convex.of([]), 1.0)


def joint(kind: str, rng: np.random.Generator) -> Joint:
    lo, hi = sorted(rng.uniform(-1.5, 1.5, 2))
    return Joint(name="j", type=kind, axis=tuple(rng.normal(size=3)), origin=tuple(rng.uniform(-1, 1, 3)),
                 range=(lo, hi), part="part")


def by_trimesh(joint: Joint, value: float) -> np.ndarray:
    if joint.type == "slide":
        return trimesh.transformations.translation_matrix(value * np.array(joint.axis) / np.linalg.norm(joint.axis))
    return trimesh.transformations.rotation_matrix(value, joint.axis, joint.origin)


@pytest.mark.parametrize("kind", ["hinge", "slide"])
@pytest.mark.parametrize("seed", range(6))
def test_a_part_moves_as_its_joint_says_and_stays_in_what_it_sweeps(kind: str, seed: int) -> None:
    rng = np.random.default_rng(seed)
    turn = trimesh.transformations.random_rotation_matrix(rng.random(3))[:3, :3]
    solids = convex.of([box(rng.uniform(-1, 1, 3), rng.uniform(0.1, 0.8, 3), turn), hull(rng.normal(size=(6, 3)))])
    how = joint(kind, rng)
    swept = convex.swept(solids, how)
    for value in np.linspace(*how.range, 5):
        now, frame = convex.moved(solids, how, float(value)), by_trimesh(how, float(value))
        for points, start, axes, first in zip(now.points, solids.points, now.axes, solids.axes):
            assert points == pytest.approx(trimesh.transform_points(start, frame))
            assert axes == pytest.approx(first @ frame[:3, :3].T)
            assert all(convex.meet(convex.of([hull([p, p, p, p])]), swept, 1e-4) for p in points)


@pytest.mark.parametrize("origin", [(0.0, 0.0), (1.0, -2.0)])
def test_a_leaf_sweeps_a_quarter_disc_and_hardly_more(origin: tuple[float, float]) -> None:
    x, y = origin
    leaf = convex.of([box([x + 0.4, y, 1.0], [0.8, 0.02, 2.0])])
    how = Joint(name="j", type="hinge", axis=(0, 0, 2), origin=(x, y, 0.0), range=(0, np.pi / 2), part="leaf")
    swept = convex.swept(leaf, how)
    assert np.ptp(swept.points[..., 2]) == 2.0 and 0 < swept.bulge.max() < 0.002
    plans = [shapely.MultiPoint(points[:, :2]).convex_hull for points in swept.points]
    area = shapely.union_all(plans)
    disc = shapely.Point(x, y).buffer(np.hypot(0.8, 0.01), 256).intersection(shapely.box(x, y, x + 1, y + 1))
    assert area.covers(disc.buffer(-0.002)) and disc.buffer(0.011).covers(area)


def test_round_colliders_are_enclosed() -> None:
    ball = convex.of([Collider("sphere", np.zeros(3), np.full(3, 0.5))])
    rod = convex.of([Collider("cylinder", np.zeros(3), np.array([0.5, 0.5, 2.0]))])
    rng = np.random.default_rng(1)
    for way in rng.normal(size=(30, 3)):
        way /= np.linalg.norm(way)
        flat = np.array([way[0], way[1], 0]) / np.hypot(*way[:2])
        assert convex.meet(rod, convex.of([hull([0.499 * flat] * 4)]), 1e-6)
        assert not convex.meet(rod, convex.of([hull([0.53 * flat] * 4)]), 1e-6)
        assert convex.meet(ball, convex.of([hull([0.499 * way] * 4)]), 1e-6)
        assert not convex.meet(ball, convex.of([hull([0.8 * way] * 4)]), 1e-6)


def test_the_way_that_parts_two_solids_leads_from_the_first_to_the_second() -> None:
    """Along it all of the second is ahead of all of the first by the distance told."""
    rng = np.random.default_rng(3)
    pairs = [[rng.normal(size=(6, 3)) + k * rng.normal(size=3) * 3 for k in range(2)] for _ in range(30)]
    a, b = (convex.of([hull(pair[k]) for pair in pairs]) for k in range(2))
    apart, way = convex._along(a, b, np.broadcast_to(np.eye(3), (30, 3, 3)))
    for (first, second), far, to in zip(pairs, apart, way):
        assert (second @ to).min() - (first @ to).max() == pytest.approx(far)
        assert far == pytest.approx(max(max(q.min() - p.max(), p.min() - q.max()) for p, q in zip(first.T, second.T)))
