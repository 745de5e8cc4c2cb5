"""Which holds are clear: boxes against solids by linear programming, and holds in a home against what stands there."""

from types import SimpleNamespace

import numpy as np
from inhabited import library, lived_in, things
from scipy.optimize import linprog

from apartgen.stages.populate import reached
from apartgen.stages.populate.arrange import FINGERS
from apartgen.stages.populate.touching import hits
from apartgen.stages.things.grasps import THICK, TIP
from apartgen.stages.things.solids import corners

SIDES = 24
"""Of the prism that stands for what is round."""


def box(rng):
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    return np.concatenate([rng.uniform(-1, 1, 3), turn.ravel(), rng.uniform(0.05, 0.8, 3)])


def solid(rng, round_):
    angle, half = rng.uniform(0, 6), rng.uniform(0.05, 0.8, 3)
    half[1] = half[0] if round_ else half[1]
    return np.array([*rng.uniform(-1, 1, 3), *half, np.cos(angle), np.sin(angle), round_])


def overlap(box, solid, grown=1.0):
    """Whether a point is in both: half-spaces of the box, and of the solid or a prism within it."""
    axes = box[3:12].reshape(3, 3)
    c, s = solid[6:8]
    flat = np.arange(SIDES) * 2 * np.pi / SIDES if solid[8] else np.arctan2(s, c) + np.arange(4) * np.pi / 2
    walls = np.column_stack([np.cos(flat), np.sin(flat), 0 * flat])
    far = np.full(SIDES, solid[3] * np.cos(np.pi / SIDES)) if solid[8] else solid[[3, 4, 3, 4]]
    up = np.array([[0, 0, 1.0], [0, 0, -1.0]])
    normals = np.concatenate([axes, -axes, walls, up])
    reach = np.concatenate([axes @ box[:3] + box[12:] * grown, -axes @ box[:3] + box[12:] * grown,
                            walls @ solid[:3] + far * grown, up @ solid[:3] + solid[5] * grown])
    return linprog(np.zeros(3), normals, reach, bounds=[(None, None)] * 3).status == 0


def test_boxes_touch_boxes_as_linear_programming_says():
    rng = np.random.default_rng(4)
    told = []
    for _ in range(300):
        a, b = box(rng), solid(rng, 0.0)
        if overlap(a, b, 1.001) == overlap(a, b, 0.999):
            told.append((bool(hits(a[None], b[None])[0]), overlap(a, b)))
    assert len(told) > 280 and 0.2 < np.mean([true for _, true in told]) < 0.9
    assert all(found == true for found, true in told)


def test_no_touch_of_what_is_round_is_missed_and_few_are_made_up():
    rng = np.random.default_rng(5)
    pairs = [(box(rng), solid(rng, 1.0)) for _ in range(300)]
    found = np.array([hits(a[None], b[None])[0] for a, b in pairs])
    true = np.array([overlap(a, b) for a, b in pairs])
    assert found[true].all() and found[~true].mean() < 0.15


def test_clear_holds_come_first_and_their_fingers_are_in_no_other_thing():
    """Points of both fingers where they hold are looked for in the pieces of all that lies near, as the parts stand."""
    home = lived_in(0)
    near = [o for o in things(home) if o.grasps]
    assert sum(o.grasps[0].clear for o in near) > 0.4 * len(near)
    for o in near[::3]:
        flags = [grasp.clear for grasp in o.grasps]
        assert flags == sorted(flags, reverse=True)
        for grasp in o.grasps[: sum(flags)]:
            tips = _tips(o, grasp)
            for other in near:
                if other is not o and np.hypot(*np.subtract(other.center, o.center)[:2]) < 0.4:
                    assert not _within(other, tips).any(), (o.id, other.id)


def _turn(o):
    c, s = np.cos(o.yaw), np.sin(o.yaw)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def _tips(o, grasp):
    ahead, close = np.array(grasp.approach), np.array(grasp.close)
    steps = np.linspace(-0.03, TIP, 5)[:, None] * ahead
    points = [grasp.at + side * close * (grasp.width + THICK) / 2 + steps for side in (-1, 1)]
    return np.concatenate(points) @ _turn(o).T + o.center


def _within(o, points):
    """Which points lie in the boxes about a thing's pieces, a little smaller than these."""
    local = (points - o.center) @ _turn(o)
    found = np.zeros(len(points), bool)
    for piece in library().load_asset(o.asset.library, o.asset.id).links[0].colliders:
        reach, middle = np.ptp(corners(piece), axis=0) / 2, corners(piece).mean(0)
        if piece.kind == "cylinder":
            found |= (np.hypot(*(local - middle)[:, :2].T) < reach[0]) & (np.abs(local - middle)[:, 2] < reach[2])
        else:
            found |= (np.abs(local - middle) < reach - 1e-4).all(1)
    return found


def test_glasses_and_forks_stand_with_room_for_a_finger_where_there_is_room():
    home = lived_in(0)
    for category in ("fork", "knife", "glass"):
        group = [o for o in things(home) if o.category == category and o.in_]
        gaps = [_gap(o, p) for k, o in enumerate(group) for p in group[:k]
                if o.in_ == p.in_ and abs(o.yaw - p.yaw) < 1e-6]
        assert not group or not gaps or min(gaps) > FINGERS - 1e-3, category


def _gap(a, b):
    """Between the boxes of two things that are turned alike, the way they are further apart."""
    apart = np.abs(_turn(a).T @ np.subtract(a.center, b.center))[:2]
    return float((apart - (np.array(a.size[:2]) + b.size[:2]) / 2).max())


def test_only_the_leaf_that_is_opened_is_out_of_the_way():
    """Of two cupboards whose doors have one name, and whose insides stay."""
    solids = np.arange(36.0).reshape(4, 9)
    room = SimpleNamespace(solids=solids, owner=np.array(["a", "a", "b", "b"]),
                           joint=np.array(["door", "", "door", ""]), within=np.array([""] * 4))
    place = SimpleNamespace(owner="a", joint=SimpleNamespace(name="door", type="hinge"))
    left = reached._seen(room, place)
    assert left.solids.tolist() == solids[1:].tolist() and left.owner.tolist() == ["a", "b", "b"]
    assert reached._seen(room, SimpleNamespace(owner="", joint=None)).solids.tolist() == solids.tolist()
