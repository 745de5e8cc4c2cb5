"""How deep boxes stand in one another, compiled.

Of the project only what compiles is imported: the cache of compiled code sees changes of this file alone.
"""

import numpy as np
from numba import njit
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@njit("void(float64[:,:,:],float64[:,:,:],float64[:,:],float64[:,:,:],float64[:,:,:],float64[:,:],float64[:,:,:])",
      cache=True, error_model="numpy")  # fmt: skip
def depths(
    a_center: Floats, a_size: Floats, a_yaw: Floats, b_center: Floats, b_size: Floats, b_yaw: Floats, out: Floats
) -> None:
    """Fills `out` (B, n, m) with the least shift that parts boxes (B, n) from boxes (B, m), m.

    Separating axes in plan (the two of each box) and z.
    """
    for k in range(len(a_yaw)):
        for i in range(a_yaw.shape[1]):
            a_cos, a_sin = np.cos(a_yaw[k, i]), np.sin(a_yaw[k, i])
            ax, ay, az = a_size[k, i, 0] / 2, a_size[k, i, 1] / 2, a_size[k, i, 2] / 2
            for j in range(b_yaw.shape[1]):
                x, y = b_center[k, j, 0] - a_center[k, i, 0], b_center[k, j, 1] - a_center[k, i, 1]
                b_cos, b_sin = np.cos(b_yaw[k, j]), np.sin(b_yaw[k, j])
                cosine, sine = abs(a_cos * b_cos + a_sin * b_sin), abs(a_cos * b_sin - a_sin * b_cos)
                bx, by = b_size[k, j, 0] / 2, b_size[k, j, 1] / 2
                depth = az + b_size[k, j, 2] / 2 - abs(b_center[k, j, 2] - a_center[k, i, 2])
                depth = min(depth, ax + bx * cosine + by * sine - abs(x * a_cos + y * a_sin))
                depth = min(depth, ay + bx * sine + by * cosine - abs(y * a_cos - x * a_sin))
                depth = min(depth, bx + ax * cosine + ay * sine - abs(x * b_cos + y * b_sin))
                depth = min(depth, by + ax * sine + ay * cosine - abs(y * b_cos - x * b_sin))
                out[k, i, j] = depth


@njit("void(float64[:,:],float64[:,:],float64[:],float64[:,:],float64[:,:],float64[:],float64,boolean[:])",
      cache=True, error_model="numpy")  # fmt: skip
def deeper(
    a_center: Floats, a_size: Floats, a_yaw: Floats, b_center: Floats, b_size: Floats, b_yaw: Floats, deep: float,
    out: NDArray[np.bool_],
) -> None:
    """Fills `out` (n,) with which boxes (n,) stand deeper than that in any of the boxes (m,), by the depths above."""
    b_cosines, b_sines = np.cos(b_yaw), np.sin(b_yaw)
    for i in range(len(a_yaw)):
        out[i] = False
        a_cos, a_sin = np.cos(a_yaw[i]), np.sin(a_yaw[i])
        ax, ay, az = a_size[i, 0] / 2, a_size[i, 1] / 2, a_size[i, 2] / 2
        for j in range(len(b_yaw)):
            if not az + b_size[j, 2] / 2 - abs(b_center[j, 2] - a_center[i, 2]) > deep:
                continue
            x, y = b_center[j, 0] - a_center[i, 0], b_center[j, 1] - a_center[i, 1]
            b_cos, b_sin = b_cosines[j], b_sines[j]
            cosine, sine = abs(a_cos * b_cos + a_sin * b_sin), abs(a_cos * b_sin - a_sin * b_cos)
            bx, by = b_size[j, 0] / 2, b_size[j, 1] / 2
            if (ax + bx * cosine + by * sine - abs(x * a_cos + y * a_sin) > deep
                    and ay + bx * sine + by * cosine - abs(y * a_cos - x * a_sin) > deep
                    and bx + ax * cosine + ay * sine - abs(x * b_cos + y * b_sin) > deep
                    and by + ax * sine + ay * cosine - abs(y * b_cos - x * b_sin) > deep):
                out[i] = True
                break
