"""An exported apartment in Isaac Sim with its doors open, the benchmark's base in it, and a bridge to ROS 2.

    ~/isaacsim/python.sh isaac_load.py guided-12/usd/apartment.usd guided-12.episodes.json

Written for Isaac Sim 5.0 and 5.1 (Python 3.11, its own ROS 2 Jazzy libraries: see "ROS 2 Installation" in its manual)
and never run: no such machine was at hand. Names were read in that version's sources. To check first: contact impulses
in N·s, and that /scan carries the time of /clock.

Topics: subscribes /cmd_vel (Twist) and /start_pose (PoseStamped: puts the robot there); publishes /clock, /odom and /tf
(exact, in the world's frame), /scan (a planar lidar at 0.2 m) and /push (Float32: mean push on the column, N).
"""

import argparse
from collections import deque
from math import atan2, cos, pi, sin
from typing import Any

STEP, FRAME = 0.01, 0.02
"""Of physics, and between frames, s; every frame, all is published and commands are heard."""
FELT = 0.05
"""Pushes are averaged over this time, s."""
WARM_UP = 5.0
"""In which the doors open, s."""
LEVEL = 0.7
"""Contacts whose normal is steeper than this are the ground's, not pushes."""


def main() -> None:
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("stage", help="apartment.usd of `apartgen export --format usd`")
    asked.add_argument("episodes", help="written by write_episodes.py; tells where the robot starts")
    asked.add_argument("--headless", action="store_true")
    given = asked.parse_args()

    from isaacsim import SimulationApp

    app = SimulationApp({"headless": given.headless})
    world = load(app, given.stage, FRAME, ["isaacsim.ros2.bridge"])
    import judge
    import rclpy

    start = next(e["start"] for e in judge.episodes(given.episodes, "navigation") if e["start"] is not None)
    base = Base(world, app, start)
    world.reset()
    world.add_physics_callback("push", base.feel)
    for _ in range(round(WARM_UP / FRAME)):
        world.step()
    rclpy.init()
    bridge = Bridge(base)
    while app.is_running():
        world.step()
        rclpy.spin_once(bridge.node, timeout_sec=0.0)
        bridge.publish()
    rclpy.shutdown()
    app.close()


def load(app: Any, path: str, frame: float, extensions: list[str]) -> Any:
    """The stage, its doors driven open, in a world that is rendered every `frame` s; `SimulationApp` comes before."""
    import stage
    from isaacsim.core.api import World
    from isaacsim.core.utils.extensions import enable_extension
    from isaacsim.core.utils.stage import get_current_stage, is_stage_loading, open_stage

    for extension in extensions:
        enable_extension(extension)
    app.update()
    if not open_stage(path):
        raise SystemExit(f"{path}: can't be opened")
    while is_stage_loading():
        app.update()
    stage.open_doors(get_current_stage())
    return World(stage_units_in_meters=1.0, physics_dt=STEP, rendering_dt=frame,
                 physics_prim_path="/Apartment/PhysicsScene")


class Base:
    """The robot: drives, tells where it is, feels pushes."""

    def __init__(self, world: Any, app: Any, start: dict[str, float]) -> None:
        import omni.kit.commands
        import omni.replicator.core as rep
        import stage
        from isaacsim.core.prims import SingleArticulation
        from isaacsim.core.utils.stage import get_current_stage
        from isaacsim.sensors.physics import ContactSensor
        from pxr import Gf

        stage.add_base(get_current_stage(), start["x"], start["y"], start["yaw"])
        self.body = world.scene.add(SingleArticulation(stage.ROBOT, name="robot"))
        self.skin = world.scene.add(ContactSensor(f"{stage.BASE}/skin", name="skin", dt=STEP))
        self.skin.add_raw_contact_data_to_frame()
        self.pushes: deque[float] = deque(maxlen=round(FELT / STEP))
        _, lidar = omni.kit.commands.execute(
            "IsaacSensorCreateRtxLidar", path="/lidar", parent=stage.BASE, config="Example_Rotary_2D",
            translation=(0.0, 0.0, stage.LIDAR), orientation=Gf.Quatd(1.0, 0.0, 0.0, 0.0),
        )
        writer = rep.writers.get("RtxLidarROS2PublishLaserScan")
        writer.initialize(topicName="scan", frameId="lidar")
        writer.attach([rep.create.render_product(lidar.GetPath(), [1, 1], name="lidar")])
        app.update()

    def drive(self, speed: float, turn: float) -> None:
        """Turn the wheels for a speed (m/s) and a turn (rad/s)."""
        import numpy as np
        import stage
        from isaacsim.core.utils.types import ArticulationAction

        rates = [(speed + side * turn * stage.TRACK / 2) / stage.WHEEL for side in (-1, 1)]
        axles = [self.body.get_dof_index(name) for name in stage.DRIVES]
        self.body.apply_action(ArticulationAction(joint_velocities=np.array(rates), joint_indices=np.array(axles)))

    def put(self, x: float, y: float, yaw: float) -> None:
        """Stand still at a pose."""
        import numpy as np

        self.body.set_world_pose(np.array([x, y, 0.0]), np.array([cos(yaw / 2), 0.0, 0.0, sin(yaw / 2)]))
        self.body.set_linear_velocity(np.zeros(3))
        self.body.set_angular_velocity(np.zeros(3))
        self.body.set_joint_velocities(np.zeros(self.body.num_dof))
        self.drive(0.0, 0.0)

    @property
    def push(self) -> float:
        """Mean over the last `FELT` seconds, N."""
        return sum(self.pushes) / len(self.pushes) if self.pushes else 0.0

    def feel(self, _: float) -> None:
        """Remember the last step's push: impulses of contacts whose normal is level."""
        contacts = self.skin.get_current_frame().get("contacts", [])
        level = (c for c in contacts if abs(c["normal"][2]) < LEVEL)
        self.pushes.append(sum(abs(float(c["impulse"] @ c["normal"])) / STEP for c in level))


class Bridge:
    """The base's topics."""

    def __init__(self, base: Base) -> None:
        import rclpy
        from geometry_msgs.msg import PoseStamped, Twist
        from nav_msgs.msg import Odometry
        from rosgraph_msgs.msg import Clock
        from std_msgs.msg import Float32
        from tf2_msgs.msg import TFMessage

        self.base, self.node = base, rclpy.create_node("apartgen_base")
        self.node.create_subscription(Twist, "/cmd_vel", lambda m: base.drive(m.linear.x, m.angular.z), 1)
        self.node.create_subscription(PoseStamped, "/start_pose", self._start, 1)
        kinds = {"/clock": Clock, "/odom": Odometry, "/tf": TFMessage, "/push": Float32}
        self.out = {topic: self.node.create_publisher(kind, topic, 10) for topic, kind in kinds.items()}

    def _start(self, message: Any) -> None:
        at, turn = message.pose.position, message.pose.orientation
        self.base.put(at.x, at.y, 2 * atan2(turn.z, turn.w))

    def publish(self) -> None:
        """All of a moment, stamped with the simulator's time."""
        import stage
        from builtin_interfaces.msg import Time
        from geometry_msgs.msg import TransformStamped
        from isaacsim.core.nodes.bindings import _isaacsim_core_nodes
        from nav_msgs.msg import Odometry
        from rosgraph_msgs.msg import Clock
        from std_msgs.msg import Float32
        from tf2_msgs.msg import TFMessage

        now = _isaacsim_core_nodes.acquire_interface().get_sim_time()
        stamp = Time(sec=int(now), nanosec=int(now % 1 * 1e9))
        (x, y, _), (w, _, _, z) = self.base.body.get_world_pose()
        yaw = (2 * atan2(float(z), float(w)) + pi) % (2 * pi) - pi
        velocity, spin = self.base.body.get_linear_velocity(), self.base.body.get_angular_velocity()

        odometry = Odometry()
        odometry.header.stamp, odometry.header.frame_id, odometry.child_frame_id = stamp, "odom", "base_link"
        pose, twist = odometry.pose.pose, odometry.twist.twist
        pose.position.x, pose.position.y = float(x), float(y)
        pose.orientation.z, pose.orientation.w = sin(yaw / 2), cos(yaw / 2)
        twist.linear.x = float(velocity[0] * cos(yaw) + velocity[1] * sin(yaw))
        twist.angular.z = float(spin[2])

        moving, lidar = TransformStamped(), TransformStamped()
        moving.header, moving.child_frame_id = odometry.header, "base_link"
        moving.transform.translation.x, moving.transform.translation.y = float(x), float(y)
        moving.transform.rotation = pose.orientation
        lidar.header.stamp, lidar.header.frame_id, lidar.child_frame_id = stamp, "base_link", "lidar"
        lidar.transform.translation.z, lidar.transform.rotation.w = stage.LIDAR, 1.0

        self.out["/clock"].publish(Clock(clock=stamp))
        self.out["/odom"].publish(odometry)
        self.out["/tf"].publish(TFMessage(transforms=[moving, lidar]))
        self.out["/push"].publish(Float32(data=self.base.push))


if __name__ == "__main__":
    main()
