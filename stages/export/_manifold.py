"""Triangle meshes parted so that every vertex is in one fan of triangles, as USD's validators want them."""

import numpy as np
from numpy.typing import NDArray

Index = NDArray[np.int64]
ROUNDS = 8
"""Cutting a fan off may leave its neighbours in two; so often it is tried again."""


def manifold(faces: Index) -> list[Index]:
    """The triangles (m, 3) in as few groups as it takes that triangles which only touch are not in one."""
    piece = np.zeros(len(faces), np.int64)
    for _ in range(ROUNDS):
        part, fan = _connected(faces, piece)
        cut = _pinched(faces, part, fan)
        if not len(cut):
            break
        piece[cut // 3] = piece.max() + 1 + fan[cut]
    group = _told_apart(faces, part)
    return [faces[group == k] for k in range(int(group.max()) + 1)]


def _connected(faces: Index, piece: Index) -> tuple[Index, Index]:
    """Part of each triangle (m,), fan of each corner (3 m,): joined over edges between triangles of one piece."""
    m, sides = len(faces), [[0, 1], [1, 2], [2, 0]]
    corner = (3 * np.arange(m)[:, None, None] + sides).reshape(-1, 2)
    turned = np.argsort(faces.ravel()[corner], axis=1)
    corner = np.take_along_axis(corner, turned, 1)
    edge = np.column_stack([faces.ravel()[corner], piece[corner[:, 0] // 3]])
    order = np.lexsort(edge.T)
    same = np.flatnonzero((np.diff(edge[order], axis=0) == 0).all(1))
    one, other = corner[order][same], corner[order][same + 1]
    return _components(m, one[:, 0] // 3, other[:, 0] // 3), _components(3 * m, one.ravel(), other.ravel())


def _components(n: int, one: Index, other: Index) -> Index:
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    return np.asarray(connected_components(coo_array((np.ones(len(one)), (one, other)), shape=(n, n)))[1], np.int64)


def _pinched(faces: Index, part: Index, fan: Index) -> Index:
    """Corners of all fans of a part about a vertex but the first."""
    place = np.column_stack([faces.ravel(), np.repeat(part, 3)])
    _, at = np.unique(place, axis=0, return_inverse=True)
    first = np.full(at.max() + 1, len(fan), np.int64)
    np.minimum.at(first, at, fan)
    return np.flatnonzero(fan != first[at])


def _told_apart(faces: Index, part: Index) -> Index:
    """A group for each triangle: parts that meet in a vertex are in different ones."""
    pairs = np.unique(np.column_stack([faces.ravel(), np.repeat(part, 3)]), axis=0)
    met: dict[int, set[int]] = {}
    for here in np.split(pairs[:, 1], np.flatnonzero(np.diff(pairs[:, 0])) + 1):
        for one in here.tolist() if len(here) > 1 else ():
            met.setdefault(one, set()).update(here.tolist())
    group = np.zeros(int(part.max()) + 1, np.int64)
    for one in sorted(met):
        taken = {int(group[other]) for other in met[one] if other < one}
        group[one] = next(k for k in range(len(taken) + 1) if k not in taken)
    return group[part]
