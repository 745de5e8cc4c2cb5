"""Floor plans to train the layout model on: `python plans.py FOLDER` draws one for every line of prompts.txt."""

import sys
from pathlib import Path

import apartgen

folder = Path(sys.argv[1])
folder.mkdir(parents=True, exist_ok=True)
for i, prompt in enumerate((Path(__file__).parent / "prompts.txt").read_text().splitlines()):
    apartgen.plan(prompt, seed=5000 + i).save(folder / f"{i:04d}.json")
