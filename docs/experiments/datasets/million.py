"""What a million homes take: `python million.py [HOMES] > table.md` makes some and simulates workers with their times.

Homes are made one after another in this process, warm, their processor time measured; then workers that draw their
homes' times from those are simulated event by event: each takes the next home when it is free, no more than eight homes
a worker ahead of the one that is written next, and one process writes them in order.
"""

import gzip
import heapq
import json
import platform
import sys
from itertools import islice
from pathlib import Path
from tempfile import TemporaryDirectory
from time import process_time

import numpy as np

from apartgen.dataset.grammar import Grammar
from apartgen.dataset.home import Asked, Done, home
from apartgen.dataset.pool import AHEAD
from apartgen.dataset.source import Drawn
from apartgen.dataset.store import Store, Writer
from apartgen.steps import BY

WORKERS, MILLION, SEED = 64, 1_000_000, 11
SIMULATED = 100_000
CORE_HOUR = 0.04
"""US dollars, an assumption: what clouds asked for a shared core in 2025."""


def made(count: int) -> tuple[list[Done], np.ndarray]:
    """Homes of the default grammar and the processor time of each, s, after two that warm up."""
    done, seconds = [], []
    for request in islice(Drawn(Grammar.read("default"), SEED, count + 2).requests(), count + 2):
        began = process_time()
        done.append(home(Asked(request, SEED, {"plan": {"processes": 1}})))
        seconds.append(process_time() - began)
    return done[2:], np.array(seconds[2:])


def written(done: list[Done]) -> float:
    """Processor time of writing a home, s."""
    with TemporaryDirectory() as folder:
        writer = Writer(Store(Path(folder)))
        began = process_time()
        for one in done * 5:
            writer.add(Done(one.line, dict(one.row)))
        spent = process_time() - began
        writer.close()
    return spent / (5 * len(done))


def simulated(seconds: np.ndarray, write: float, workers: int, count: int) -> tuple[float, float]:
    """How long it takes until `count` homes are written, s, and the share of that in which workers work."""
    drawn = np.random.default_rng(SEED).choice(seconds, count)
    free, ended = [0.0] * workers, np.zeros(count)
    out = np.zeros(count)
    for i in range(count):
        # The home that is so many before it has to be written.
        asked = out[i - workers * AHEAD] if i >= workers * AHEAD else 0.0
        ended[i] = max(heapq.heappop(free), asked) + drawn[i]
        heapq.heappush(free, ended[i])
        out[i] = max(ended[i], out[i - 1] if i else 0.0) + write
    return float(out[-1]), float(drawn.sum() / (workers * out[-1]))


def rows(done: list[Done], seconds: np.ndarray) -> dict[str, str]:
    """The page's table."""
    write = written([one for one in done if one.line])
    whole, busy = simulated(seconds, write, WORKERS, SIMULATED)
    pair, _ = simulated(seconds, write, 2, SIMULATED)
    hours, mean = MILLION / SIMULATED * whole / 3600, seconds.mean()
    size = np.mean([len(gzip.compress(one.line, 6)) for one in done if one.line])
    row = np.mean([len(json.dumps(one.row)) for one in done])
    return {
        "processor time of a home, mean": f"{mean:.2f} s",
        "median, greatest": f"{np.median(seconds):.2f} s, {seconds.max():.2f} s",
        "processor time of writing one": f"{1000 * write:.2f} ms",
        "a home in its shard, and its row": f"{size / 1000:.1f} kB, {row / 1000:.1f} kB",
        "two workers": f"{SIMULATED / pair * 3600:,.0f} homes an hour",
        f"{WORKERS} workers": f"{SIMULATED / whole * 3600:,.0f} homes an hour, at work {100 * busy:.1f} % of the time",
        f"a million by {WORKERS} workers": f"{hours:.1f} hours, {MILLION * mean / 3600:,.0f} core hours",
        "on the disk": f"{MILLION * (size + row) / 1e9:.0f} GB",
        f"at {CORE_HOUR} dollars a core hour, assumed": f"{CORE_HOUR * WORKERS * hours:,.0f} dollars",
        "one writer keeps up with": f"{mean / write:,.0f} workers",
    }


def main(count: int) -> None:
    """Write the page."""
    done, seconds = made(count)
    failed = sum(not one.line for one in done)
    lines = [
        "# A million homes", "",
        f"`python docs/experiments/datasets/million.py {count}`, {BY}, {platform.machine()}, Python "
        f"{platform.python_version()}: {count} homes of the default", f"grammar, from the plan to things, judged and "
        f"measured; {failed} failed. Processor time is of one core, warm. Workers", f"are simulated with these times "
        f"({SIMULATED:,} homes), not run: cores that share memory and heat give less.", "", "| | |", "|---|---|",
        *(f"| {name} | {value} |" for name, value in rows(done, seconds).items())]
    sys.stdout.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    main(int(sys.argv[1]) if sys.argv[1:] else 24)
