"""Makes the pictures of the README, of the gallery and of the example anew: `make pictures`.

    python docs/experiments/pictures.py [FOLDER]

FOLDER is what holds `docs` and `examples`, this checkout by default.
"""

import shutil
import sys
import tempfile
from pathlib import Path

import gallery
import numpy as np
from PIL import Image

import apartgen
from apartgen.outputs import opened_libraries
from apartgen.stages.export._contact import contact
from apartgen.stages.render import TILT, film
from apartgen.stages.render.config import RenderConfig
from apartgen.stages.scene.camera import Camera
from apartgen.stages.scene.scene import Scene
from apartgen.stages.scene.world import world

PROMPT, SEED = "two-bedroom flat", 1
ROOT = Path(__file__).parents[2]
ROOMS = ("living_room", "bedroom")
CLEAR = 0.01
"""Share of a picture from which a thing counts as shown."""
MANY = 12
"""More things make a picture no better."""
NEAR, CROWDED = 1500, 30.0
"""What is nearer is right before the camera, mm, and how much a picture that is all of that is worse, in things."""
RATHER = 2.0
"""How much better a picture of the room that is asked for is."""
QUALITY = 88
COLUMNS = 3
WALK = RenderConfig(width=400, height=260, rate=4, speed=1.0)
SECONDS = 22
"""Of the walk that is shown."""
COLOURS = 96


def fullest(found, folder: Path, room: str, only: bool = True) -> str:
    """The name of the view at the height of eyes that shows most things and has least right before it; of a room of
    this type `only`, or rather of one.
    """
    eyes = [view for view in found.views if view.kind == "eye"]
    kept = [view for view in eyes if view.room.startswith(room)] if only else eyes
    return max(kept or eyes, key=lambda view: _worth(found, folder, view) + RATHER * view.room.startswith(room)).name


def _worth(found, folder: Path, view) -> float:
    things = {thing.number for thing in found.instances if thing.box}
    depth = np.asarray(Image.open(folder / f"{view.name}.depth.png"))
    shown = sum(part.number in things and part.pixels > CLEAR * view.width * view.height for part in view.visible)
    return min(shown, MANY) - CROWDED * float((depth < NEAR).mean())


def first(root: Path, work: Path) -> None:
    """One home, its plan, itself from above, its rooms and a walk; then the example's drawings."""
    name = PROMPT.replace(" ", "-")
    home = apartgen.make(PROMPT, work / "home", seed=SEED, formats=["view", "png"])
    found = apartgen.render(home, work / "views", kind=["eye"], views=12, width=960, height=640, points=0)
    pictures = root / "docs" / "pictures"
    for source, target in (("view", "view"), ("plan", "plan")):
        shutil.copy(work / "home" / "scene" / f"{source}.png", pictures / f"{name}-{target}.png")
    for room in ROOMS:
        view = work / "views" / f"{fullest(found, work / 'views', room)}.rgb.png"
        shutil.copy(view, pictures / f"{name}-{room.replace('_', '-')}.png")
    walk(home.body, pictures / f"{name}-walk.gif")
    example = root / "examples" / name
    apartgen.export(example / "walkable.json", work / "example", ["view", "png", "svg"])
    for file in ("view.png", "plan.png", "plan.svg"):
        shutil.copy(work / "example" / file, example / file)


def walk(home, target: Path) -> None:
    """The robot's way through the home as a moving picture."""
    scene = Scene(home, opened_libraries().load_asset)
    around = world(scene)
    some = film.moments(around, WALK)[:SECONDS * WALK.rate]
    size, field = (WALK.width, WALK.height), np.radians(WALK.field)
    cameras = [Camera.looking(m.stand.place, m.stand.yaw, TILT, field, *size) for m in some]
    frames = [Image.fromarray(image).quantize(COLOURS, dither=Image.Dither.NONE)
              for image in film.pictures(scene, around, some, cameras, WALK.rate)]
    frames[0].save(target, save_all=True, append_images=frames[1:], duration=1000 // WALK.rate, loop=0)


def twelve(root: Path, work: Path) -> None:
    """A room of each home of the gallery, all plans on one sheet, and the page that shows them."""
    pictures, cells, plans = root / "docs" / "pictures" / "gallery", [], []
    pictures.mkdir(parents=True, exist_ok=True)
    for number, home, room in gallery.made():
        folder = work / number
        found = apartgen.render(home, folder, kind=["eye"], views=14, width=600, height=400, points=0)
        with Image.open(folder / f"{fullest(found, folder, room, only=False)}.rgb.png") as picture:
            picture.save(pictures / f"{number}.jpg", quality=QUALITY, optimize=True)
        plans.append(home.body)
        text = home.body.prompt
        cells.append(f"![{text}](pictures/gallery/{number}.jpg)<br>{int(number)}. “{text}”<br>{gallery.told(home)}")
    contact(plans, 4).quantize(64).save(pictures / "plans.png", optimize=True)
    rows = ["| " + " | ".join(row) + " |" for row in (cells[k:k + COLUMNS] for k in range(0, len(cells), COLUMNS))]
    seeds = [seed for _, seed, _ in gallery.HOMES]
    head = ["# Twelve homes", "", "Each is what `apartgen make` makes of its sentence; seeds are those from "
            f"{min(seeds)} to {max(seeds)} in order.", "", "| " * COLUMNS + "|", "|---" * COLUMNS + "|"]
    foot = ["", "Their plans, to one scale (`apartgen view homes/*.json -o plans.png`):", "",
            "![Plans of the twelve homes](pictures/gallery/plans.png)", ""]
    (root / "docs" / "gallery.md").write_text("\n".join([*head, *rows, *foot]), encoding="utf-8")


def main(root: Path) -> None:
    """All of them."""
    with tempfile.TemporaryDirectory() as folder:
        first(root, Path(folder))
        twelve(root, Path(folder))


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT)
