"""Shapes of a USD stage: meshes, colliders, where they are."""

from typing import Any

import numpy as np
from numpy.typing import NDArray
from pxr import Gf, UsdGeom, UsdPhysics, Vt

from stages.asset import Array, Collider
from stages.export._hull import hull
from stages.export._rotation import quaternion


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
    made = mesh(stage, path, *hull(c))
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


def extent(points: Array) -> Any:
    """Bounds of points (n, 3), as USD keeps them."""
    return Vt.Vec3fArray.FromNumpy(np.stack([points.min(0), points.max(0)]).astype(np.float32))


def place(xform: Any, position: Array, turn: Array) -> None:
    """Position and quaternion (w, x, y, z) of an xform."""
    xform.AddTranslateOp().Set(Gf.Vec3d(*map(float, position)))
    xform.AddOrientOp(UsdGeom.XformOp.PrecisionDouble).Set(Gf.Quatd(*map(float, turn)))
