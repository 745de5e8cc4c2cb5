"""Let a vision-language-action policy open what opens, in Isaac Sim, judged at 80 % of each joint's range.

    ~/isaacsim/python.sh run_vla.py guided-12/usd/apartment.usd guided-12.episodes.json -o vla.jsonl \\
        --robot robot.usd --camera head_camera --policy ws://localhost:8000

Written for Isaac Sim 5.0 and 5.1 and never run: neither the simulator nor a policy was at hand. Names were read in that
version's sources. The robot is yours: a USD file of an articulation whose base can stand where the episode says, with a
camera in it. What differs between policies is in `observation` and `Robot.act`: change these two.

The policy is a server that speaks openpi's protocol (`pip install openpi-client`, its WebsocketClientPolicy), or with
`--policy package.module:make` whatever `make()` returns: a `Policy` as below. Actions are (steps, joints) position
targets in the order of the robot's joints.

Not judged here, though the benchmark does: pushes on other things than the part.
"""

import argparse
import importlib
import logging
from collections.abc import Mapping
from math import cos, sin
from typing import Any, Protocol

import isaac_load
import judge

ROBOT = "/Robot"
SETTLE = 5.0
"""Before an episode, s: the room doors open, the robot comes to rest."""
CONTROL = 0.05
"""Between actions and frames, s."""


class Policy(Protocol):
    """What acts. `openpi_client.base_policy.BasePolicy` is one."""

    def infer(self, obs: dict[str, Any]) -> Mapping[str, Any]:
        """The next actions, (steps, joints), as `actions`."""
        ...

    def reset(self) -> None:
        """A new episode begins."""
        ...


def policy(where: str) -> Policy:
    """The policy at an address (ws://host:port) or made by a function (package.module:name)."""
    if where.startswith(("ws://", "wss://")):
        from openpi_client.websocket_client_policy import WebsocketClientPolicy

        return WebsocketClientPolicy(host=where)
    module, _, name = where.partition(":")
    return getattr(importlib.import_module(module), name or "make")()


def observation(image: Any, joints: Any, instruction: str) -> dict[str, Any]:
    """What the policy gets: an image (h, w, 3) uint8, joint positions, the task in words."""
    return {"observation/image": image, "observation/state": joints, "prompt": instruction}


def main() -> None:
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("stage", help="apartment.usd of `apartgen export --format usd`")
    asked.add_argument("episodes", help="written by write_episodes.py")
    asked.add_argument("-o", "--out", required=True, help="JSON Lines file to add records to")
    asked.add_argument("--robot", required=True, help="USD file of an articulation")
    asked.add_argument("--camera", required=True, help="path of a camera prim below the robot's root")
    asked.add_argument("--policy", required=True, help="ws://host:port, or package.module:function")
    asked.add_argument("--seconds", type=float, default=60.0, help="time limit of an episode, simulated")
    asked.add_argument("--headless", action="store_true")
    given = asked.parse_args()
    logging.basicConfig(level=logging.INFO, format="%(message)s")

    from isaacsim import SimulationApp

    app = SimulationApp({"headless": given.headless})
    world, acting = isaac_load.load(app, given.stage, CONTROL, []), policy(given.policy)
    robot, found = Robot(world, given.robot, given.camera), []
    for episode in judge.episodes(given.episodes, "interaction"):
        if episode["base"] is None:
            record = judge.impossible(episode)
        else:
            record = opened(world, robot, acting, episode, given.seconds)
        judge.append(record, given.out)
        found.append(record)
    logging.info(judge.summary(found))
    app.close()


def opened(world: Any, robot: "Robot", acting: Policy, episode: dict[str, Any], limit: float) -> dict[str, Any]:
    """One episode's record: everything shut, the robot at the base's place, until the part is open or time is up."""
    import numpy as np

    world.reset()
    robot.put(**episode["base"])
    part = Part(episode)
    for _ in range(round(SETTLE / CONTROL)):
        world.step()
    acting.reset()
    seconds = 0.0
    while seconds < limit and abs(part.value()) < abs(episode["open_at"]):
        seen = observation(robot.image(), robot.joints(), episode["instruction"])
        for action in np.atleast_2d(np.asarray(acting.infer(seen)["actions"])):
            robot.act(action)
            world.step()
            seconds += CONTROL
            if seconds >= limit or abs(part.value()) >= abs(episode["open_at"]):
                break
    return judge.opened(episode, part.value(), seconds)


class Part:
    """The joint of an episode in the running simulation."""

    def __init__(self, episode: dict[str, Any]) -> None:
        from isaacsim.core.prims import SingleArticulation

        # The exported pose stays as it is.
        self.object = SingleArticulation(episode["usd_object"], name=episode["id"], reset_xform_properties=False)
        self.object.initialize()
        self.index = self.object.get_dof_index(episode["usd_joint"].rpartition("/")[2])

    def value(self) -> float:
        """Where it is, m or rad."""
        return float(self.object.get_joint_positions()[self.index])


class Robot:
    """Your robot."""

    def __init__(self, world: Any, usd: str, camera: str) -> None:
        from isaacsim.core.prims import SingleArticulation
        from isaacsim.core.utils.stage import add_reference_to_stage
        from isaacsim.sensors.camera import Camera

        add_reference_to_stage(usd_path=usd, prim_path=ROBOT)
        self.body = world.scene.add(SingleArticulation(ROBOT, name="robot"))
        self.camera = world.scene.add(Camera(f"{ROBOT}/{camera}", name="camera", resolution=(640, 480)))

    def put(self, x: float, y: float, yaw: float) -> None:
        """Stand at a pose, joints at their defaults."""
        import numpy as np

        self.body.set_world_pose(np.array([x, y, 0.0]), np.array([cos(yaw / 2), 0.0, 0.0, sin(yaw / 2)]))

    def image(self) -> Any:
        """What the camera sees, (480, 640, 3) uint8."""
        return self.camera.get_rgb()

    def joints(self) -> Any:
        """Joint positions, in the order of the robot's joints."""
        return self.body.get_joint_positions()

    def act(self, action: Any) -> None:
        """Take one action: a position target for every joint."""
        from isaacsim.core.utils.types import ArticulationAction

        self.body.apply_action(ArticulationAction(joint_positions=action))


if __name__ == "__main__":
    main()
