"""glTF 2.0 binary: named nodes, joints in node extras, physically based materials, lights.

One node per body and one per moving link, whose origin is on its joint, so that turning or shifting the node by a
value of the joint's range moves the part. Node extras name the artifact's object, and the joint in the node's frame.
"""

from pathlib import Path

from apartgen.stages.export._gltf import packed
from apartgen.stages.export._readback import read_glb
from apartgen.stages.scene.scene import Scene


def write(scene: Scene, out: Path) -> list[Path]:
    """One file, apartment.glb."""
    path = out / "apartment.glb"
    path.write_bytes(packed(scene.bodies, scene.lights, scene.credits))
    return [path]


def read_back(files: list[Path]) -> None:
    """By trimesh."""
    read_glb(files)
