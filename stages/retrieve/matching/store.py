"""An asset as one file: arrays and a JSON description, in safetensors, so that reading runs no code."""

import json
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from safetensors import SafetensorError, safe_open
from safetensors.numpy import save_file

from apartgen.schemas.errors import BadInput
from apartgen.schemas.retrieve import Joint
from apartgen.stages.things.asset import Asset, Collider, Link, Material, Mesh

Tensors = dict[str, NDArray[Any]]


def write(asset: Asset, path: Path) -> None:
    """Vertices are kept in single precision."""
    tensors: Tensors = {"latent": np.asarray(asset.latent, np.float32)}
    links = [_link(link, f"{i}", tensors) for i, link in enumerate(asset.links)]
    about = {
        "library": asset.library,
        "id": asset.id,
        "category": asset.category,
        "style": asset.style,
        "size": asset.size,
        "credit": asset.credit,
        "links": links,
    }
    path.parent.mkdir(parents=True, exist_ok=True)
    save_file(tensors, path, metadata={"asset": json.dumps(about, sort_keys=True)})


def _link(link: Link, key: str, tensors: Tensors) -> dict[str, Any]:
    return {
        "name": link.name,
        "mass": link.mass,
        "grip": link.grip,
        "friction": link.friction,
        "joint": link.joint.model_dump() if link.joint else None,
        "handle": None if link.handle is None else np.asarray(link.handle, float).tolist(),
        "visuals": [_mesh(mesh, f"{key}.v{i}", tensors) for i, mesh in enumerate(link.visuals)],
        "colliders": [_collider(piece, f"{key}.c{i}", tensors) for i, piece in enumerate(link.colliders)],
    }


def _mesh(mesh: Mesh, key: str, tensors: Tensors) -> dict[str, Any]:
    tensors[f"{key}.vertices"] = np.ascontiguousarray(mesh.vertices, np.float32)
    tensors[f"{key}.faces"] = np.ascontiguousarray(mesh.faces, np.int32)
    if mesh.uv is not None:
        tensors[f"{key}.uv"] = np.ascontiguousarray(mesh.uv, np.float32)
    m = mesh.material
    return {
        "key": key,
        "uv": mesh.uv is not None,
        "name": m.name,
        "color": list(m.color),
        "roughness": m.roughness,
        "metalness": m.metalness,
        "texture": m.texture,
    }


def _collider(piece: Collider, key: str, tensors: Tensors) -> dict[str, Any]:
    if piece.vertices is not None:
        tensors[f"{key}.vertices"] = np.ascontiguousarray(piece.vertices, np.float32)
    return {
        "key": key,
        "kind": piece.kind,
        "center": np.asarray(piece.center).tolist(),
        "size": np.asarray(piece.size).tolist(),
        "rotation": np.asarray(piece.rotation).tolist(),
        "hull": piece.vertices is not None,
    }


def read(path: Path, textures: Path | None = None) -> Asset:
    """The asset of a file, its images in the folder `textures`; BadInput when it is missing or broken."""
    try:
        with safe_open(path, framework="np") as file:
            about = json.loads(file.metadata()["asset"])
            tensors = {name: file.get_tensor(name) for name in file.keys()}  # noqa: SIM118
        links = [_read_link(link, tensors, textures or path.parent) for link in about.pop("links")]
        return Asset(**about | {"size": tuple(about["size"])}, links=links, latent=tensors["latent"].astype(float))
    except (OSError, SafetensorError, KeyError, TypeError, ValueError) as error:
        raise BadInput(f"{path}: not a readable asset ({error}); index the library again") from None


def _read_link(about: dict[str, Any], tensors: Tensors, textures: Path) -> Link:
    visuals, colliders = about.pop("visuals"), about.pop("colliders")
    joint, handle = about.pop("joint"), about.pop("handle")
    return Link(
        **about,
        joint=Joint(**joint) if joint else None,
        handle=None if handle is None else np.asarray(handle, float),
        visuals=[_read_mesh(mesh, tensors, textures) for mesh in visuals],
        colliders=[_read_collider(piece, tensors) for piece in colliders],
    )


def _read_mesh(about: dict[str, Any], tensors: Tensors, textures: Path) -> Mesh:
    key, mapped, image = about.pop("key"), about.pop("uv"), about.pop("texture")
    # Only a name counts, so that no library leads out of itself.
    about["texture"] = str(textures / Path(image).name) if image else None
    material = Material(**about | {"color": tuple(about["color"])})
    uv = tensors[f"{key}.uv"].astype(float) if mapped else None
    return Mesh(tensors[f"{key}.vertices"].astype(float), tensors[f"{key}.faces"].astype(np.int64), material, uv)


def _read_collider(about: dict[str, Any], tensors: Tensors) -> Collider:
    key, hull = about.pop("key"), about.pop("hull")
    arrays = {name: np.asarray(about[name], float) for name in ("center", "size", "rotation")}
    vertices = tensors[f"{key}.vertices"].astype(float) if hull else None
    return Collider(kind=about["kind"], **arrays, vertices=vertices)
