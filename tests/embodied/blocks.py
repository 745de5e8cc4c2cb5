"""Rooms and plain blocks whose ways can be worked out by hand, exported as MJCF."""

import numpy as np

from apartgen.schemas.plan import Opening, Plan, Program
from apartgen.schemas.retrieve import AssetKey, Furnishing, Retrieve
from apartgen.stages import registry
from apartgen.stages.scene.scene import Scene
from apartgen.stages.things import solids
from apartgen.stages.things.asset import Asset, Link
from apartgen.stages.things.materials import PALETTE


def block(id, x, y, depth, width, yaw=0.0, room="hallway_1", height=1.0, category="bookshelf"):
    """A block on the floor; its front looks along `yaw`."""
    asset = AssetKey(library="blocks", id=f"{depth} {width} {height}")
    return Furnishing(id=id, room=room, category=category, center=(x, y, height / 2), size=(depth, width, height),
                      yaw=yaw, asset=asset)


def load(library, id):
    size = np.array([float(v) for v in id.split()])
    links = [Link("base", [solids.box(-size / 2, size / 2, PALETTE["oak"])], [solids.slab(-size / 2, size / 2)], 30.0)]
    return Asset(library, id, "block", "plain", tuple(size), links)


def corridor(length, width):
    """One room from (0, 0), the entrance in the middle of its west side."""
    y = width / 2
    entrance = Opening(id="entrance_1", kind="entrance", rooms=["hallway_1"], sill=0, head=2.1, into="hallway_1",
                       segment=((-0.15, y - 0.45), (-0.15, y + 0.45)))
    room = {"id": "hallway_1", "type": "hallway", "polygon": [(0, 0), (length, 0), (length, width), (0, width)]}
    return Plan.model_validate({"program": Program.model_validate({"rooms": [{"id": "hallway_1", "type": "hallway"}]}),
                                "rooms": [room], "openings": [entrance]})


def furnished(plan, *objects):
    return Retrieve(**dict(plan), objects=list(objects))


def exported(home, folder):
    """The scene and its apartment.xml."""
    scene = Scene(home, load)
    folder.mkdir(parents=True, exist_ok=True)
    registry.load("apartgen.stages.export", "mjcf").write(scene, folder)
    return scene, folder / "mjcf" / "apartment.xml"
