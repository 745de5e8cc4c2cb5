"""Send Nav2 the navigation episodes of an apartment, one after the other, and judge them as the benchmark does.

    python3 run_navigation.py guided-12.episodes.json -o isaac.jsonl

Runs in a ROS 2 Jazzy shell beside isaac_load.py and navigation.launch.py (use `--exact-pose` with localise:=false). Not
run with Isaac Sim yet. Every line written is a record as in the benchmark's trials.jsonl. Before every episode the
robot is put back to the start through /start_pose; the pose judged is the simulator's own (/odom), not AMCL's.
"""

import argparse
import logging
from math import atan2, cos, hypot, sin
from typing import Any

import judge

SETTLE = 3.0
"""Between episodes, s of simulated time: the robot comes to rest at the start and AMCL hears of it."""


class Watch:
    """Where the robot is, how far it has come, and how hard it was pushed, from what isaac_load.py publishes."""

    def __init__(self) -> None:
        self.pose = (0.0, 0.0, 0.0)
        self.metres = 0.0
        self.push: float | None = None

    def begin(self) -> None:
        """A new episode; whether pushes are felt at all is remembered."""
        self.metres, self.push = 0.0, None if self.push is None else 0.0

    def moved(self, message: Any) -> None:
        """Odometry whose frame is the world's."""
        at, turn = message.pose.pose.position, message.pose.pose.orientation
        self.metres += hypot(at.x - self.pose[0], at.y - self.pose[1])
        self.pose = at.x, at.y, 2 * atan2(turn.z, turn.w)

    def pushed(self, message: Any) -> None:
        """Mean push on the column over 50 ms, N."""
        self.push = max(self.push or 0.0, message.data)


def main() -> None:
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("episodes", help="written by write_episodes.py")
    asked.add_argument("-o", "--out", required=True, help="JSON Lines file to add records to")
    asked.add_argument("--exact-pose", action="store_true", help="there is no AMCL")
    given = asked.parse_args()
    logging.basicConfig(level=logging.INFO, format="%(message)s")
    found = run(list(judge.episodes(given.episodes, "navigation")), given.out, given.exact_pose)
    logging.info(judge.summary(found))


def run(episodes: list[dict[str, Any]], out: str, exact_pose: bool) -> list[dict[str, Any]]:
    """All episodes; records are written as they come."""
    import rclpy

    rclpy.init()
    robot, found = Robot(exact_pose), []
    for episode in episodes:
        record = judge.impossible(episode) if episode["goal"] is None else robot.drive(episode)
        judge.append(record, out)
        found.append(record)
    rclpy.shutdown()
    return found


class Robot:
    """The simulated robot as Nav2 drives it; times are simulated seconds."""

    def __init__(self, exact_pose: bool) -> None:
        from geometry_msgs.msg import PoseStamped
        from nav2_simple_commander.robot_navigator import BasicNavigator
        from nav_msgs.msg import Odometry
        from rclpy.parameter import Parameter
        from std_msgs.msg import Float32

        self.watch, self.navigator, self.exact_pose = Watch(), BasicNavigator(), exact_pose
        self.navigator.set_parameters([Parameter("use_sim_time", value=True)])
        self.navigator.create_subscription(Odometry, "/odom", self.watch.moved, 10)
        self.navigator.create_subscription(Float32, "/push", self.watch.pushed, 10)
        self.to_start = self.navigator.create_publisher(PoseStamped, "/start_pose", 1)

    def drive(self, episode: dict[str, Any]) -> dict[str, Any]:
        """One episode's record."""
        self._begin(episode["start"])
        self.watch.begin()
        began = self._now()
        if self.navigator.goToPose(_stamped(self.navigator, episode["goal"])):
            while not self.navigator.isTaskComplete():
                if self._now() - began > episode["seconds"] or (self.watch.push or 0.0) > episode["push"]:
                    self.navigator.cancelTask()
                    break
        return judge.arrived(episode, self.watch.pose, self._now() - began, self.watch.metres, self.watch.push)

    def _begin(self, start: dict[str, float]) -> None:
        while not self.to_start.get_subscription_count() or not self._now():
            self._spin()
        self.to_start.publish(_stamped(self.navigator, start))
        self._wait()
        self.navigator.setInitialPose(_stamped(self.navigator, start))
        self.navigator.waitUntilNav2Active(localizer="robot_localization" if self.exact_pose else "amcl")
        self._wait()
        self.navigator.clearAllCostmaps()
        self._wait()

    def _wait(self) -> None:
        until = self._now() + SETTLE
        while self._now() < until:
            self._spin()

    def _spin(self) -> None:
        import rclpy

        rclpy.spin_once(self.navigator, timeout_sec=0.1)

    def _now(self) -> float:
        """0 until the clock is heard."""
        return float(self.navigator.get_clock().now().nanoseconds) / 1e9


def _stamped(navigator: Any, pose: dict[str, float]) -> Any:
    from geometry_msgs.msg import PoseStamped

    message = PoseStamped()
    message.header.frame_id = "map"
    message.header.stamp = navigator.get_clock().now().to_msg()
    message.pose.position.x, message.pose.position.y = pose["x"], pose["y"]
    message.pose.orientation.z, message.pose.orientation.w = sin(pose["yaw"] / 2), cos(pose["yaw"] / 2)
    return message


if __name__ == "__main__":
    main()
