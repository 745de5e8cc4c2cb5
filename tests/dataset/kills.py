"""Ends a build of a data set by kill -9 at random moments, resumes it each time, and compares with one left alone.

    python tests/dataset/kills.py FOLDER [HOMES] [KILLS] [SEED]

Ctrl-C ends the killing: the build that is under way comes to its end, and what was found is told.
"""

import hashlib
import json
import os
import random
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

SETTINGS = "[layout]\ncandidates = 1\n[plan]\nenough = 1\ncandidates = 1\n"
TIMES = ("README.md", "croissant.json", "manifest.parquet")
"""Files that tell how long homes took."""


def digests(data: Path) -> dict[str, str]:
    """Of every file by name, what times were taken left out."""
    found = {}
    for file in sorted(file for file in data.rglob("*") if file.is_file() and file.name not in TIMES):
        content = re.sub(rb'"seconds":\{[^}]*\}', b"", file.read_bytes())
        found[file.relative_to(data).as_posix()] = hashlib.sha256(content).hexdigest()
    return found


def rows(data: Path) -> int:
    """Whole rows of the manifest."""
    file = data / "manifest.jsonl"
    return file.read_bytes().count(b"\n") if file.exists() else 0


class Build:
    """A build in a session of its own, that may be killed."""

    def __init__(self, folder: Path, homes: int, seed: int, data: Path) -> None:
        (folder / "settings.toml").write_text(SETTINGS)
        command = [sys.executable, "-m", "apartgen_cli", "-q", "dataset", "build", "--prompts-from", "default",
                   "--count", str(homes), "--seed", str(seed), "--config", str(folder / "settings.toml"),
                   "--shard", "16", "--workers", "2", "-o", str(data)]
        self.data, self.began = data, time.monotonic()
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                        start_new_session=True)

    def kill(self, rng: random.Random) -> str:
        """At once: the process, or it with its workers, or one worker, after which it goes on by itself."""
        whom = rng.choice(["all", "parent", "worker"])
        if whom == "worker":
            victims = [pid for pid in children(self.process.pid) if not is_tracker(pid)] or [self.process.pid]
            os.kill(rng.choice(victims), signal.SIGKILL)
        elif whom == "all":
            os.killpg(self.process.pid, signal.SIGKILL)
        else:
            self.process.kill()
        return whom


def children(parent: int) -> list[int]:
    """Processes that descend from one."""
    pairs = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            pairs.append((int(stat.parent.name), int(stat.read_text().rpartition(")")[2].split()[1])))
        except OSError:
            continue
    found = [parent]
    for one in found:
        found += [pid for pid, of in pairs if of == one]
    return found[1:]


def is_tracker(pid: int) -> bool:
    """Whether it is Python's own keeper of semaphores, which complains loudly of its death and harms nothing."""
    try:
        return b"resource_tracker" in Path(f"/proc/{pid}/cmdline").read_bytes()
    except OSError:
        return False


class Killer:
    """Kills builds of one data set at random moments, `left` times yet."""

    def __init__(self, folder: Path, homes: int, kills: int, seed: int) -> None:
        self.folder, self.homes, self.seed, self.left = folder, homes, seed, kills
        self.rng = random.Random(seed)
        self.kills = {"all": 0, "parent": 0, "worker": 0}
        self.wrong: list[str] = []

    def stop(self, *_: object) -> None:
        """No more of it."""
        self.left = 0

    def build(self, data: Path) -> None:
        """One data set, killed and resumed until it is whole or there was enough of it."""
        ended = False
        while not ended:
            running = Build(self.folder, self.homes, self.seed, data)
            while running.process.poll() is None and self.left:  # one goes on by itself without one of its workers
                self._disturb(running, rows(data) + self.rng.randrange(3))
            error = running.process.communicate()[1].decode()
            ended = running.process.returncode in (0, 1)
            if "Traceback" in error:
                self.wrong.append(f"{data.name}: {error.splitlines()[-1]}")
        calm, found = digests(self.folder / "calm"), digests(data)
        if found != calm:
            other = sorted(name for name in {*calm, *found} if calm.get(name) != found.get(name))
            self.wrong.append(f"{data.name}: differs in {', '.join(other)}")
        if rows(data) != self.homes:
            self.wrong.append(f"{data.name}: {rows(data)} rows")

    def _disturb(self, running: Build, wanted: int) -> None:
        """Some kills meet the program while it starts, most of them while homes are made and written."""
        while running.process.poll() is None and self.left and self.rng.random() > 0.002:
            if rows(running.data) > wanted:
                time.sleep(self.rng.uniform(0, 1.5))
                break
            time.sleep(0.02)
        if running.process.poll() is None and self.left:
            self.left -= 1
            self.kills[running.kill(self.rng)] += 1


def main(folder: Path, homes: int = 200, kills: int = 200, seed: int = 1) -> int:
    """Exit status 1 where anything is wrong."""
    folder.mkdir(parents=True, exist_ok=True)
    calm = Build(folder, homes, seed, folder / "calm")
    calm.process.communicate()
    assert calm.process.returncode in (0, 1), "the build that nobody disturbs"
    killer = Killer(folder, homes, kills, seed)
    signal.signal(signal.SIGINT, killer.stop)
    builds = 0
    while killer.left:
        builds += 1
        killer.build(folder / f"killed_{builds}")
    print(json.dumps({"homes": homes, "builds": builds, "kills": killer.kills, "wrong": killer.wrong}))
    return 1 if killer.wrong else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), *map(int, sys.argv[2:])))
