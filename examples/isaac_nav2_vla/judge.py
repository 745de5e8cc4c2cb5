"""What the runners share: reading episodes.json, judging as the benchmark does, and records like the benchmark's.

Plain Python without packages, for ROS 2's and Isaac Sim's interpreters; tested without either.
"""

import json
from collections.abc import Iterator, Mapping
from math import hypot, pi
from pathlib import Path
from typing import Any

Episode = Mapping[str, Any]


def episodes(path: str | Path, kind: str) -> Iterator[dict[str, Any]]:
    """The `navigation` or `interaction` episodes of a file."""
    whole = json.loads(Path(path).read_text(encoding="utf-8"))
    for episode in whole[kind]:
        yield {"apartment": whole["apartment"], "episode": kind, **episode}


def arrived(
    episode: Episode, pose: tuple[float, float, float], seconds: float, metres: float, push: float | None = None,
) -> dict[str, Any]:
    """The record of a drive that ended at `pose` (x, y, yaw) after so many seconds and metres.

    `push` is the hardest push on the robot, N, None where nothing felt it; only then pushes are not judged.
    """
    goal = episode["goal"]
    missed = hypot(pose[0] - goal["x"], pose[1] - goal["y"])
    turned = abs((pose[2] - goal["yaw"] + pi) % (2 * pi) - pi)
    reason = ""
    if push is not None and push > episode["push"]:
        reason = "ran against something"
    elif seconds > episode["seconds"]:
        reason = "too slow"
    elif missed > episode["within"] or turned > episode["facing"]:
        reason = "did not stop at the goal"
    shortest = episode["shortest"]
    numbers = {
        "spl": (shortest / max(metres, shortest) if shortest else 1.0) if not reason else 0.0, "shortest": shortest,
        "metres": metres, "seconds": seconds, "missed": missed, "goal_x": goal["x"], "goal_y": goal["y"],
        "goal_yaw": goal["yaw"],
    }
    return _record(episode, reason, "controller", numbers if push is None else {**numbers, "push": push})


def opened(episode: Episode, value: float, seconds: float) -> dict[str, Any]:
    """The record of a part whose joint came to `value` (m or rad); pushes on other things are not judged."""
    travel = max(episode["range"], key=abs)
    share = value / travel
    reason = "" if share >= episode["share"] - 1e-6 else f"opened to {max(share, 0.0):.0%} of its range"
    return _record(episode, reason, "controller", {"share": share, "seconds": seconds})


def impossible(episode: Episode) -> dict[str, Any]:
    """The record of an episode that has failed before it begins."""
    return _record(episode, episode["reason"], episode["failure"],
                   {"spl": 0.0} if episode["episode"] == "navigation" else {})


def _record(episode: Episode, reason: str, failure: str, numbers: Mapping[str, float]) -> dict[str, Any]:
    keys = ("id", "apartment", "episode", "room", "object", "category")
    return {
        **{key: episode[key] for key in keys}, "joint": episode.get("joint", ""), "success": not reason,
        "failure": failure if reason else None, "reason": reason,
        "numbers": {key: round(float(value), 4) for key, value in numbers.items()},
    }


def append(record: Mapping[str, Any], path: str | Path) -> None:
    """One more line of a JSON Lines file."""
    with Path(path).open("a", encoding="utf-8") as file:
        file.write(json.dumps(record) + "\n")


def summary(records: list[dict[str, Any]]) -> str:
    """How many succeeded, and why the others did not."""
    failed = [f"{r['id']}: {r['failure']} ({r['reason']})" for r in records if not r["success"]]
    return "\n".join([f"{len(records) - len(failed)} of {len(records)} succeeded", *failed])
