"""Floor plans to train the layout model on, of the lines of prompts.txt in turn: `python plans.py FOLDER [COUNT]`."""

import sys
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import apartgen

PROMPTS = (Path(__file__).parent / "prompts.txt").read_text().splitlines()
COUNT = 4000


def draw(folder: Path, i: int) -> None:
    """The plan with number `i`, unless it is there already."""
    target = folder / f"{i:04d}.json"
    if not target.exists():
        apartgen.plan(PROMPTS[i % len(PROMPTS)], seed=5000 + i).save(target)


if __name__ == "__main__":
    where = Path(sys.argv[1])
    where.mkdir(parents=True, exist_ok=True)
    numbers = range(int(sys.argv[2]) if len(sys.argv) > 2 else COUNT)
    with ProcessPoolExecutor() as workers:
        list(workers.map(draw, [where] * len(numbers), numbers, chunksize=8))
