"""Makes the pictures of the README and of the example anew: `make pictures`.

    python docs/experiments/pictures.py [FOLDER]

FOLDER is what holds `docs` and `examples`, this checkout by default.
"""

import shutil
import sys
import tempfile
from pathlib import Path

import apartgen

PROMPT, SEED = "two-bedroom flat", 5
ROOT = Path(__file__).parents[2]
ROOMS = ("living_room", "bedroom")
CLEAR = 0.01
"""Share of a picture from which a thing counts as shown."""


def fullest(found, room: str) -> str:
    """The name of the view at the height of eyes in a room of this type that shows most things."""
    kept = [view for view in found.views if view.kind == "eye" and view.room.startswith(room)]
    things = {thing.number for thing in found.instances if thing.box}
    return max(kept, key=lambda view: sum(part.number in things and part.pixels > CLEAR * view.width * view.height
                                          for part in view.visible)).name


def main(root: Path) -> None:
    """One home, its plan, itself from above and its rooms; then the example's drawings."""
    name = PROMPT.replace(" ", "-")
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        home = apartgen.make(PROMPT, work / "home", seed=SEED, formats=["view", "png"])
        found = apartgen.render(home, work / "views", kind=["eye"], views=12, width=960, height=640, points=0)
        pictures = root / "docs" / "pictures"
        for source, target in (("view", "view"), ("plan", "plan")):
            shutil.copy(work / "home" / "scene" / f"{source}.png", pictures / f"{name}-{target}.png")
        for room in ROOMS:
            view = work / "views" / f"{fullest(found, room)}.rgb.png"
            shutil.copy(view, pictures / f"{name}-{room.replace('_', '-')}.png")
        example = root / "examples" / name
        apartgen.export(example / "walkable.json", work / "example", ["view", "png", "svg"])
        for file in ("view.png", "plan.png", "plan.svg"):
            shutil.copy(work / "example" / file, example / file)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT)
