"""A folder of GLB, glTF or OBJ models, metric or of a declared scale; doors, drawers and lids that are nodes move."""

from collections.abc import Iterator
from functools import partial
from pathlib import Path

import numpy as np

from apartgen.stages.retrieve.reading import gltf, limits, motion, obj
from apartgen.stages.retrieve.reading.model import Model, Part, asset
from apartgen.stages.retrieve.reading.source import Source, beside, credit, files, image
from apartgen.stages.things.asset import Asset
from apartgen.stages.things.words import category

MOVABLE = "movable_nodes.json"
"""May name more nodes that move: {file: {node: {"pivot": [x, y, z]}}}."""


def assets(root: Path, scale: float = 1.0) -> Iterator[Source]:
    """Every model below `root`, y up and front +z as glTF has it; `scale` is metres per unit."""
    movable = limits.parsed(root / MOVABLE) if (root / MOVABLE).exists() else {}
    by, found = credit(root), files(root, (".glb", ".gltf", ".obj"))
    stems = [str(path.relative_to(root).with_suffix("")) for path in found]
    for path, stem in zip(found, stems, strict=True):
        name = stem if stems.count(stem) == 1 else str(path.relative_to(root))
        yield Source(name, partial(_load, path, root, name, scale, by, movable.get(path.stem, {})))


def _load(
    path: Path, root: Path, name: str, scale: float, by: str, movable: dict[str, dict[str, list[float]]]
) -> Asset:
    kind = category(path.stem)
    data = limits.read(path)
    if path.suffix.lower() == ".obj":
        parts = [Part("base", obj.parse(data, path.name, beside(path, root), image(path, root)))]
    else:
        parts = _parts(gltf.parse(data, path.name, beside(path, root)), kind, movable)
    return asset(
        Model(name, kind, parts, credit=by, scale=scale, style=path.parent.name if path.parent != root else ""), ""
    )


def _parts(roots: list[gltf.Node], kind: str, movable: dict[str, dict[str, list[float]]]) -> list[Part]:
    """The tree cut at nodes that move; what hangs below such a node moves with it."""
    middle = _middle(roots)
    still = Part("base", [])
    parts = [still]
    stack = list(reversed(roots))
    while stack:
        node = stack.pop()
        pieces = node.all()
        if pieces and (node.name in movable or motion.moves(node.name)):
            pivot = np.asarray(movable.get(node.name, {}).get("pivot", node.frame[:3, 3]), float)
            parts.append(Part(node.name, pieces, motion.guess(node.name, kind, pieces, pivot, middle)))
        else:
            still.pieces.extend(node.pieces)
            stack.extend(reversed(node.children))
    return parts


def _middle(roots: list[gltf.Node]) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    pieces = [piece for node in roots for piece in node.all() if len(piece.vertices)]
    if not pieces:
        raise limits.Broken("has no faces")
    points = np.concatenate([piece.vertices for piece in pieces])
    return np.asarray((points.min(0) + points.max(0)) / 2)
