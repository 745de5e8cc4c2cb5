"""Shapes of a USD stage: meshes, colliders, where they are."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pxr import Gf, Sdf, UsdGeom, UsdPhysics, Vt

from apartgen.stages.export._hull import hull
from apartgen.stages.export._manifold import manifold
from apartgen.stages.export._rotation import quaternion
from apartgen.stages.scene.pieces import shaded
from apartgen.stages.things.asset import Array, Collider, Mesh


class Surface(NamedTuple):
    """Vertices (n, 3), unit normals (n, 3), uv (n, 2) or None, triangles (m, 3)."""

    vertices: Array
    normals: Array
    uv: Array | None
    faces: NDArray[np.int64]


def collider(stage: Any, path: str, c: Collider) -> Any:
    """A shape to collide with, of the kind that engines treat exactly."""
    if c.kind == "hull":
        return _hull(stage, path, c)
    if c.kind == "box":
        shape = UsdGeom.Cube.Define(stage, path)
        shape.CreateSizeAttr(1.0)
        shape.CreateExtentAttr(extent(np.array([[-0.5] * 3, [0.5] * 3])))
    elif c.kind == "cylinder":
        shape = UsdGeom.Cylinder.Define(stage, path)
        shape.CreateRadiusAttr(float(c.size[0]))
        shape.CreateHeightAttr(float(c.size[2]))
        shape.CreateAxisAttr(UsdGeom.Tokens.z)
        shape.CreateExtentAttr(extent(np.array([[-1.0], [1.0]]) * [c.size[0], c.size[0], c.size[2] / 2]))
    else:
        shape = UsdGeom.Sphere.Define(stage, path)
        shape.CreateRadiusAttr(float(c.size[0]))
        shape.CreateExtentAttr(extent(np.array([[-1.0] * 3, [1.0] * 3]) * c.size[0]))
    place(shape, c.center, quaternion(c.rotation))
    if c.kind == "box":
        shape.AddScaleOp().Set(Gf.Vec3f(*map(float, c.size)))
    return shape


def _hull(stage: Any, path: str, c: Collider) -> Any:
    vertices, faces = hull(c)
    made = mesh(stage, path, vertices, faces)
    a, b, d = (vertices[faces[:, k]] for k in range(3))
    across = np.cross(b - a, d - a)
    _normals(made, across / np.linalg.norm(across, axis=1, keepdims=True), UsdGeom.Tokens.uniform)
    UsdPhysics.MeshCollisionAPI.Apply(made.GetPrim()).CreateApproximationAttr(UsdPhysics.Tokens.convexHull)
    return made


def mesh(stage: Any, path: str, vertices: Array, faces: NDArray[Any]) -> Any:
    """A triangle mesh."""
    made = UsdGeom.Mesh.Define(stage, path)
    made.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(vertices.astype(np.float32)))
    made.CreateFaceVertexCountsAttr(Vt.IntArray.FromNumpy(np.full(len(faces), 3, np.int32)))
    made.CreateFaceVertexIndicesAttr(Vt.IntArray.FromNumpy(faces.ravel().astype(np.int32)))
    made.CreateSubdivisionSchemeAttr(UsdGeom.Tokens.none)
    made.CreateExtentAttr(extent(vertices))
    return made


def visuals(piece: Mesh) -> list[Surface]:
    """What shows of a piece, shaded, as manifold meshes."""
    vertices, normals, uv, faces = shaded(piece)
    found = []
    a, b, c = (vertices.astype(np.float32)[faces[:, k]] for k in range(3))
    for part in manifold(faces[np.linalg.norm(np.cross(b - a, c - a), axis=1) > 0]):
        used, index = np.unique(part, return_inverse=True)
        own = None if uv is None else uv[used]
        found.append(Surface(vertices[used], normals[used], own, index.reshape(-1, 3).astype(np.int64)))
    return found


def show(stage: Any, path: str, surface: Surface) -> Any:
    """A mesh with normals, and texture coordinates where it has them, each stored once."""
    made = mesh(stage, path, surface.vertices, surface.faces)
    _normals(made, surface.normals, UsdGeom.Tokens.vertex)
    if surface.uv is not None:
        kind = Sdf.ValueTypeNames.TexCoord2fArray
        primvar = UsdGeom.PrimvarsAPI(made).CreatePrimvar("st", kind, UsdGeom.Tokens.vertex)
        once, index = np.unique(surface.uv.astype(np.float32), axis=0, return_inverse=True)
        primvar.Set(Vt.Vec2fArray.FromNumpy(once))
        primvar.SetIndices(Vt.IntArray.FromNumpy(index.ravel().astype(np.int32)))
    return made


def _normals(shown: Any, unit: Array, interpolation: str) -> None:
    """Unit normals (n, 3), one for each vertex or face."""
    shown.CreateNormalsAttr(Vt.Vec3fArray.FromNumpy(unit.astype(np.float32)))
    shown.SetNormalsInterpolation(interpolation)


def extent(points: Array) -> Any:
    """Bounds of points (n, 3), as USD keeps them."""
    return Vt.Vec3fArray.FromNumpy(np.stack([points.min(0), points.max(0)]).astype(np.float32))


def place(xform: Any, position: Array, turn: Array) -> None:
    """Position and quaternion (w, x, y, z) of an xform."""
    xform.AddTranslateOp().Set(Gf.Vec3d(*map(float, position)))
    xform.AddOrientOp(UsdGeom.XformOp.PrecisionDouble).Set(Gf.Quatd(*map(float, turn)))
