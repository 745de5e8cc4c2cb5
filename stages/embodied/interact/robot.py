"""A mobile manipulator simple enough to plan for in closed form: a round base, a mast, a telescope, a gripper.

The base is the navigating robot's disc. On its mast a carriage goes up and down and turns about it; the telescope on
the carriage ends in a wrist that yaws, pitches and rolls, and carries two parallel fingers: six degrees of freedom
between base and hand, every one force limited. Its reach and grip stay within those of a Franka Panda and its hand
(0.855 m to the flange, 70 N continuous); the shape is that of the lift-and-telescope robots, as Stretch.

Hand frame: x forward between the fingers, y from finger to finger, z up; its origin lies between the fingers' pads.
"""

import numpy as np
from numpy.typing import ArrayLike

from apartgen.stages.space.boxes import Array, Mask

RADIUS = 0.25
"""Of the base, m."""
BASE_HEIGHT = 0.14
MAST = 1.9
LIFT = (0.175, 1.9)
"""Heights of the telescope, m."""
_SEGMENT, _STROKE = 0.22, 0.2  # m, of each of the telescope's pieces, and how far each comes out
ARM = (_SEGMENT, _SEGMENT + 3 * _STROKE)
"""Distance of the wrist from the mast's axis, m."""
PALM, FINGER, TIP = 0.06, 0.075, 0.006
"""Lengths of palm and fingers, and how far the fingers reach beyond the hand's origin, m."""
HAND = PALM + FINGER - TIP
"""From the wrist to the hand's origin, m."""
REACH = ARM[1] + HAND
"""Furthest that the hand gets from the mast's axis, m."""
CUP = 0.02
"""Length of the suction cup before the closed fingers; it gives way to any slant, m."""
OPENING = 0.045
"""Each finger moves this far from the middle, m."""
THICK = 0.01
"""Of a finger, m."""
FORCE = 80.0
"""What the arm can push or pull with at the hand, N; at the turret, at full reach."""
GRIP = 60.0
"""Of each finger, N."""
BASE_MASS, CARRIAGE_MASS, PIECE_MASS, PALM_MASS, FINGER_MASS = 40.0, 3.0, 0.7, 0.7, 0.05
MASS = BASE_MASS + CARRIAGE_MASS + 3 * PIECE_MASS + PALM_MASS + 2 * FINGER_MASS
"""Of all of it, kg; the base drives with so much."""
TRACTION = 235.0
"""What the wheels hold: 40 kg on rubber (μ 0.6), N."""

NAMES = ("x", "y", "heading", "lift", "turret", "arm_1", "arm_2", "arm_3", "yaw", "pitch", "roll", "left", "right")
"""Joints, in the order of every posture; each has an actuator of its name that takes its target."""
SPEED = np.array([0.3, 0.3, 0.8, 0.4, 1.2, 0.2, 0.2, 0.2, 2.0, 2.0, 2.0, 0.2, 0.2])
"""Of the joints, m/s and rad/s."""
FINGERS = slice(11, 13)
_WRIST = {"yaw": 2.7, "pitch": 2.1, "roll": 3.3}
_GAINS = {  # kp, kv, greatest force or torque
    "x": (4e4, 4e3, TRACTION), "y": (4e4, 4e3, TRACTION), "heading": (4e3, 4e2, TRACTION * RADIUS),
    "lift": (6e3, 500, FORCE), "turret": (3e3, 250, FORCE * ARM[1]), "arm": (1.5e4, 600, FORCE),
    "yaw": (60, 5, 10), "pitch": (60, 5, 10), "roll": (30, 2.5, 6), "left": (3e3, 80, GRIP), "right": (3e3, 80, GRIP),
}  # fmt: skip
LEAD = np.array([_GAINS[name.split("_")[0]][1] / _GAINS[name.split("_")[0]][0] for name in NAMES])
"""How much time each servo lags behind a moving target, s."""


def joint(name: str) -> str:
    """Full name of a joint in the model."""
    return f"robot__{name}"


def mjcf() -> str:
    """The robot as MJCF, for `world.build`; it stands at the origin, its arm in and its hand up."""
    return f"""<mujoco>
  <default>
    <default class="robot">
      <geom contype="2" conaffinity="1" group="1" density="0" rgba="0.25 0.27 0.3 1"/>
    </default>
    <default class="robot_hand">
      <geom contype="4" conaffinity="1" group="1" density="0" rgba="0.85 0.5 0.1 1"/>
    </default>
  </default>
  <worldbody>
    <body name="robot_base" gravcomp="1">
      {_joint("x", "slide", "1 0 0")}{_joint("y", "slide", "0 1 0")}{_joint("heading", "hinge", "0 0 1")}
      <inertial pos="0 0 0.1" mass="{BASE_MASS}" diaginertia="1 1 1.5"/>
      <geom name="robot__drum" class="robot" conaffinity="5" type="cylinder"
        size="{RADIUS} {(BASE_HEIGHT - 0.02) / 2}" pos="0 0 {(BASE_HEIGHT + 0.02) / 2}"/>
      <geom name="robot__mast" class="robot" type="capsule" fromto="0 0 {BASE_HEIGHT} 0 0 {MAST}" size="0.04"/>
      <body name="robot__carriage" gravcomp="1">
        {_joint("lift", "slide", "0 0 1", LIFT)}{_joint("turret", "hinge", "0 0 1")}
        <inertial pos="0 0 0" mass="{CARRIAGE_MASS}" diaginertia="0.02 0.02 0.02"/>
        <geom class="robot" type="capsule" fromto="0 0 0 {_SEGMENT} 0 0" size="0.03"/>
        {_telescope(1)}
      </body>
    </body>
  </worldbody>
  <equality>
    <connect name="robot__hold" body1="robot__palm" body2="robot_base" anchor="0 0 0" active="false" solref="0.016 1"/>
  </equality>
  <actuator>
    {"".join(_servo(name) for name in NAMES)}
  </actuator>
</mujoco>"""


def _joint(name: str, kind: str, axis: str, limits: tuple[float, float] | None = None, armature: float = 0.05) -> str:
    bound = f'range="{limits[0]} {limits[1]}" limited="true"' if limits else ""
    return f'<joint name="{joint(name)}" type="{kind}" axis="{axis}" armature="{armature}" {bound}/>'


def _servo(name: str) -> str:
    kp, kv, force = _GAINS[name.split("_")[0]]
    return (f'<position name="{joint(name)}" joint="{joint(name)}" kp="{kp}" kv="{kv}" '
            f'forcerange="{-force} {force}"/>')


def _telescope(k: int) -> str:
    """The k-th moving piece and what it carries."""
    carried = _telescope(k + 1) if k < 3 else _hand()
    start = "0 0 0" if k == 1 else f"{0} 0 0"
    return f"""<body name="robot__arm_{k}" pos="{start}" gravcomp="1">
      {_joint(f"arm_{k}", "slide", "1 0 0", (0.0, _STROKE))}
      <inertial pos="0.1 0 0" mass="{PIECE_MASS}" diaginertia="0.003 0.003 0.003"/>
      <geom class="robot" type="capsule" fromto="0.02 0 0 {_SEGMENT} 0 0" size="{0.03 - 0.003 * k}"/>
      {carried}
    </body>"""


def _hand() -> str:
    fingers = "".join(_finger(name, side) for name, side in (("left", 1), ("right", -1)))
    return f"""<body name="robot__palm" pos="{_SEGMENT} 0 0" gravcomp="1">
      {_joint("yaw", "hinge", "0 0 1", (-_WRIST["yaw"], _WRIST["yaw"]), 0.02)}
      {_joint("pitch", "hinge", "0 1 0", (-_WRIST["pitch"], _WRIST["pitch"]), 0.02)}
      {_joint("roll", "hinge", "1 0 0", (-_WRIST["roll"], _WRIST["roll"]), 0.02)}
      <inertial pos="0.04 0 0" mass="{PALM_MASS}" diaginertia="0.001 0.001 0.001"/>
      <geom name="robot__palm" class="robot_hand" type="box" size="{PALM / 2} 0.035 0.02" pos="{PALM / 2} 0 0"/>
      {fingers}
    </body>"""


def _finger(name: str, side: int) -> str:
    return f"""<body name="robot__{name}" pos="{PALM} 0 0" gravcomp="1">
      {_joint(name, "slide", f"0 {side} 0", (0.0, OPENING), 0.01)}
      <inertial pos="{FINGER / 2} 0 0" mass="{FINGER_MASS}" diaginertia="0.0001 0.0001 0.0001"/>
      <geom name="robot__{name}" class="robot_hand" type="box" size="{FINGER / 2} {THICK / 2} 0.009"
        pos="{FINGER / 2} {side * THICK / 2} 0" friction="1" priority="1" condim="4"/>
    </body>"""


def tucked(base: ArrayLike, lift: float, turret: float) -> Array:
    """The posture with the arm in and the hand up, all of it above the base; `base` is (x, y, heading)."""
    return np.array([*np.asarray(base, float), np.clip(lift, *LIFT), turret, 0, 0, 0, 0, -np.pi / 2, 0, 0, 0])


def posture(
    base: ArrayLike, at: Array, turn: Array, opening: float, near: Array | None = None, spare: float = 0.0
) -> Array | None:
    """The posture (13,) that holds the hand at a point, its axes the columns of `turn`; None out of reach.

    `near` is a posture whose turns it continues; `spare` is kept from the ends of telescope and lift, m.
    """
    x, y, heading = (float(v) for v in np.asarray(base, float))
    wrist = at - HAND * turn[:, 0]
    out = float(np.hypot(wrist[0] - x, wrist[1] - y))
    ends = ((out, ARM), (wrist[2], LIFT))
    if any(not lo + spare <= value <= hi - spare for value, (lo, hi) in ends):
        return None
    bearing = float(np.arctan2(wrist[1] - y, wrist[0] - x))
    c, s = np.cos(bearing), np.sin(bearing)
    seen = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) @ turn
    yaw, pitch = np.arctan2(seen[1, 0], seen[0, 0]), -np.arcsin(np.clip(seen[2, 0], -1, 1))
    roll = np.arctan2(seen[2, 1], seen[2, 2])
    found = np.array([x, y, heading, wrist[2], bearing - heading, *[(out - ARM[0]) / 3] * 3, yaw, pitch, roll,
                      opening, opening])
    old = np.zeros(13) if near is None else near
    for k in (4, 10):
        found[k] = old[k] + (found[k] - old[k] + np.pi) % (2 * np.pi) - np.pi
    within = all(abs(found[k]) <= _WRIST[name] for k, name in ((8, "yaw"), (9, "pitch"), (10, "roll")))
    return found if within else None


def postures(
    base: ArrayLike, at: Array, turns: Array, opening: float, spare: float = 0.0, near: Array | None = None
) -> tuple[Array, Mask]:
    """The postures (n, 13) that hold the hand at points (n, 3) with axes (n, 3, 3), and which are within reach.

    With `near` they continue one another's turns, on from that posture.
    """
    x, y, heading = (float(v) for v in np.asarray(base, float))
    wrist = at - HAND * turns[:, :, 0]
    aside, ahead = wrist[:, 1] - y, wrist[:, 0] - x
    out, bearing = np.hypot(aside, ahead), np.arctan2(aside, ahead)
    c, s = np.cos(bearing)[:, None], np.sin(bearing)[:, None]
    first, second, last = c * turns[:, 0] + s * turns[:, 1], c * turns[:, 1] - s * turns[:, 0], turns[:, 2]
    found = np.empty((len(at), 13))
    found[:, :3] = x, y, heading
    found[:, 3] = wrist[:, 2]
    found[:, 4] = (bearing - heading + np.pi) % (2 * np.pi) - np.pi
    found[:, 5:8] = (out[:, None] - ARM[0]) / 3
    found[:, 8] = np.arctan2(second[:, 0], first[:, 0])
    found[:, 9] = -np.arcsin(last[:, 0].clip(-1, 1))
    found[:, 10] = np.arctan2(last[:, 1], last[:, 2])
    found[:, 11:] = opening
    if near is not None:
        found[:, [4, 10]] = np.unwrap(np.vstack([near, found])[:, [4, 10]], axis=0)[1:]
    within = (ARM[0] + spare <= out) & (out <= ARM[1] - spare)
    within &= (LIFT[0] + spare <= wrist[:, 2]) & (wrist[:, 2] <= LIFT[1] - spare)
    within &= (np.abs(found[:, 8:11]) <= list(_WRIST.values())).all(1)
    return found, within
