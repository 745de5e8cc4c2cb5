"""Many built assets in one file that loads faster than they are built: a safetensors of all their arrays end to end.

Vertices are kept in single precision. Reading runs no code from the file.
"""

import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from safetensors import SafetensorError, safe_open
from safetensors.numpy import save_file

from apartgen.schemas.errors import BadInput
from apartgen.schemas.retrieve import Joint
from apartgen.stages.retrieve.furniture.mesh import Array
from apartgen.stages.things.asset import Asset, Collider, Link, Material, Mesh

_FIELDS = ("library", "id", "category", "style", "size", "credit", "roles")


def write(assets: Sequence[Asset], path: Path) -> None:
    """One file of all assets, in order."""
    links = [link for asset in assets for link in asset.links]
    meshes = [mesh for link in links for mesh in link.visuals]
    pieces = [piece for link in links for piece in link.colliders]
    materials = list(dict.fromkeys(mesh.material for mesh in meshes))
    number = {material: i for i, material in enumerate(materials)}
    about = {
        "materials": [[m.name, m.color, m.roughness, m.metalness, m.texture, m.emission] for m in materials],
        "assets": [[*(getattr(a, f) for f in _FIELDS), [_link(link, number) for link in a.links]] for a in assets],
    }
    none = np.zeros((0, 3))
    uv = [np.zeros((len(m.vertices), 2)) if m.uv is None else m.uv for m in meshes]
    arrays = {
        "vertices": np.concatenate([m.vertices for m in meshes] or [none]).astype(np.float32),
        "faces": np.concatenate([m.faces for m in meshes] or [np.zeros((0, 3), np.int64)]).astype(np.int32),
        "uv": np.concatenate(uv or [np.zeros((0, 2))]).astype(np.float32),
        "hulls": np.concatenate([none, *(p.vertices for p in pieces if p.vertices is not None)]).astype(np.float32),
        "pieces": np.array([[*p.center, *p.size, *p.rotation.ravel()] for p in pieces]).reshape(-1, 15),
        "latents": np.array([a.latent for a in assets], np.float32),
    }
    save_file(arrays, path, metadata={"pack": json.dumps(about)})


def _link(link: Link, number: dict[Material, int]) -> list[Any]:
    return [
        link.name,
        link.mass,
        link.joint.model_dump() if link.joint else None,
        None if link.handle is None else [float(x) for x in link.handle],
        link.friction,
        link.grip,
        [[number[m.material], len(m.vertices), len(m.faces), m.uv is not None] for m in link.visuals],
        [[p.kind, -1 if p.vertices is None else len(p.vertices)] for p in link.colliders],
    ]


def read(path: Path) -> list[Asset]:
    """The assets of a file, in order; BadInput when it is missing or broken."""
    try:
        with safe_open(path, framework="np") as file:
            about = json.loads(file.metadata()["pack"])
            arrays = {name: file.get_tensor(name) for name in ("vertices", "faces", "uv", "hulls", "pieces", "latents")}
        return list(_Reader(about, arrays).assets())
    except (OSError, SafetensorError, LookupError, TypeError, ValueError) as error:
        raise BadInput(f"{path}: not a readable pack of assets ({error}); write it again") from None


class _Reader:
    """Cuts the arrays into assets, front to back."""

    def __init__(self, about: dict[str, Any], arrays: dict[str, Any]) -> None:
        self.about = about
        self.vertices, self.uv, self.hulls = (arrays[name].astype(float) for name in ("vertices", "uv", "hulls"))
        self.faces, self.pieces, self.latents = arrays["faces"].astype(np.int64), arrays["pieces"], arrays["latents"]
        self.materials = [Material(n, tuple(c), r, m, t, e) for n, c, r, m, t, e in about["materials"]]
        self.vertex = self.face = self.hull = self.piece = 0

    def assets(self) -> Iterator[Asset]:
        for row, latent in zip(self.about["assets"], self.latents.astype(float), strict=True):
            library, id, category, style, size, credit, roles, links = row
            made = [self._link(*link) for link in links]
            yield Asset(library, id, category, style, tuple(size), made, latent, credit, tuple(roles))

    def _link(
        self, name: str, mass: float, joint: Any, handle: Any, friction: float, grip: str, visuals: Any, pieces: Any
    ) -> Link:
        seen = [self._mesh(*mesh) for mesh in visuals]
        felt = [self._piece(*piece) for piece in pieces]
        hold = None if handle is None else np.array(handle, float)
        return Link(name, seen, felt, mass, Joint(**joint) if joint else None, hold, friction, grip)

    def _mesh(self, material: int, vertices: int, faces: int, mapped: bool) -> Mesh:
        v, f = slice(self.vertex, self.vertex + vertices), slice(self.face, self.face + faces)
        self.vertex, self.face = v.stop, f.stop
        return Mesh(self.vertices[v], self.faces[f], self.materials[material], self.uv[v] if mapped else None)

    def _piece(self, kind: Any, corners: int) -> Collider:
        row: Array = self.pieces[self.piece]
        self.piece += 1
        points = None
        if corners >= 0:
            points = self.hulls[self.hull : self.hull + corners]
            self.hull += corners
        return Collider(kind, row[:3], row[3:6], row[6:].reshape(3, 3), points)
