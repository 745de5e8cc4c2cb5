"""A differential-drive base on real wheels, for MuJoCo: two driven, two casters, and a column as high as the robot.

The size and weight of a mobile manipulator for homes (Hello Robot's Stretch: 0.34 m wide, 1.41 m high, 24.5 kg), its
radius that of the walkable stage's robot. Speeds are the defaults of Nav2's regulated pure pursuit.
"""

from apartgen.stages.embodied.world import ROBOT
from apartgen.stages.robot import reach

RADIUS = reach.RADIUS
HEIGHT = 1.4
"""The column is as wide as the base all the way up, so that no table top or shelf is driven under, m."""
MASS = 24.5
SPEED, TURN = 0.5, 1.8
"""Greatest speeds, m/s and rad/s: desired_linear_vel and rotate_to_heading_angular_vel."""
ACCELERATION, TURN_ACCELERATION = 1.0, 3.2
"""Greatest accelerations, m/s² and rad/s²; Nav2's defaults are 2.5 and 3.2."""
WHEEL, TRACK = 0.08, 0.36
"""Radius of the driven wheels and distance between them, m."""
TYRE = 0.015
"""Half the width of a tyre, whose round tread meets the floor in one point, m."""
TORQUE, GAIN = 6.0, 20.0
"""Greatest of a wheel's motor, N·m (at the wheel's rim 75 N), and what it gives for each rad/s that is missing."""
STIFFNESS = 10_000.0
"""Of the bumper's skin that the column wears, N/m: it gives a millimetre at 10 N at each point of contact.

It slides without friction: in MuJoCo's friction cones sliding itself would push the two apart.
"""
JOINTS = (f"{ROBOT}_free",)
DRIVES = (f"{ROBOT}_left", f"{ROBOT}_right")


def mjcf(mass: float = MASS) -> str:
    """The base as MuJoCo XML, standing at the origin and looking along +x.

    `mass` is all of it, kg; motors are in proportion, so that a heavier one drives alike.

    That things may sleep spares what never moves its share of every step; the base itself is kept awake.
    """
    heavy = mass / MASS
    most = TORQUE * heavy
    wheels = "".join(_wheel(name, side, heavy) for name, side in (("left", 1), ("right", -1)))
    casters = "".join(
        f'<geom name="{ROBOT}_caster_{k}" type="sphere" size="0.03" pos="{x} 0 0.03" condim="1" priority="1"/>'
        for k, x in enumerate((0.18, -0.18))
    )
    servo = f'kv="{GAIN * heavy}" forcerange="-{most} {most}"'
    motors = "".join(f'<velocity name="{name}" joint="{name}_axle" {servo}/>' for name in DRIVES)
    skin = (2 * mass / STIFFNESS) ** 0.5  # s, the time constant that gives so much at an impedance of one half
    inertia = " ".join(f"{share * heavy:.9g}" for share in (1.6, 1.6, 0.7))
    half = (HEIGHT - 0.02) / 2
    column = f'<geom name="{ROBOT}_column" type="cylinder" size="{RADIUS} {half}" pos="0 0 {0.02 + half}"'
    return f"""<mujoco>
  <option impratio="20"><flag sleep="enable"/></option>
  <worldbody>
    <body name="{ROBOT}_base" sleep="never"><freejoint name="{JOINTS[0]}"/>
      <inertial pos="0 0 0.2" mass="{mass - 2 * heavy}" diaginertia="{inertia}"/>
      {column} condim="1" rgba="0.2 0.2 0.25 1" priority="1" solref="{skin} 1" solimp="0.5 0.5 0.001"/>
      {casters}{wheels}
    </body>
  </worldbody>
  <contact><exclude body1="{ROBOT}_base" body2="{ROBOT}_left_wheel"/>
    <exclude body1="{ROBOT}_base" body2="{ROBOT}_right_wheel"/></contact>
  <actuator>{motors}</actuator>
</mujoco>"""


def _wheel(name: str, side: int, heavy: float) -> str:
    resists = f'armature="{0.02 * heavy}" damping="{0.01 * heavy}"'
    return (
        f'<body name="{ROBOT}_{name}_wheel" pos="0 {side * TRACK / 2} {WHEEL}">'
        f'<joint name="{ROBOT}_{name}_axle" type="hinge" axis="0 1 0" {resists}/>'
        f'<geom name="{ROBOT}_{name}_tyre" type="ellipsoid" size="{WHEEL} {TYRE} {WHEEL}" mass="{heavy}" '
        'friction="0.9 0.01 0.001" condim="3" priority="1"/></body>'
    )
