"""What stands in the way where no plan exists, told from the arrangement that came closest."""

import numpy as np

from apartgen.schemas.plan import Program
from apartgen.stages.plan.slicing import (
    EPS,
    L_ENTRY,
    L_LINK,
    R_AREA,
    R_FACE,
    R_JOINTS,
    R_PIECES,
    R_WIDTH,
    S_FACE,
    S_LOOSE,
    S_TARGET,
    S_WIDTH,
    Problem,
    Scratch,
)


def lacks(program: Program, p: Problem, z: Scratch) -> list[str]:
    """Requirements that a measured arrangement misses, in words."""
    ids = [room.id for room in program.rooms]
    out = [
        f"{ids[a]} and {ids[b]} share too little wall for a door"
        for (a, b), wall in zip(p.links, z.wall, strict=True)
        if wall[0] < p.limits[L_LINK] - EPS
    ]
    if z.entry[2] < p.limits[L_ENTRY] - EPS:
        out.append(f"{ids[p.order[0, 0]]} finds no outside wall for the entrance")
    share = z.room[:, R_AREA] / z.room[:, R_AREA].sum() * p.spec[:, S_TARGET].sum() / p.spec[:, S_TARGET]
    for name, room, want, ratio in zip(ids, z.room, p.spec, share, strict=True):
        if room[R_FACE] < want[S_FACE] - EPS:
            out.append(f"{name} finds no outside wall for its window")
        if room[R_WIDTH] < want[S_WIDTH] - EPS:
            out.append(f"{name} is narrower than {want[S_WIDTH]:.1f} m")
        if room[R_PIECES] - 1 > room[R_JOINTS]:
            out.append(f"{name} falls into parts")
        if np.abs(ratio - 1) > want[S_LOOSE] + EPS:
            out.append(f"{name} gets {room[R_AREA]:.1f} m² instead of {want[S_TARGET]:.1f}")
    return out or ["some room is too long for its width"]


def told(program: Program, missed: list[str]) -> str:
    """One line for the user."""
    return (
        f"no floor plan of these {len(program.rooms)} rooms meets all requirements at once; in the closest one "
        f"{'; '.join(missed[:3])}: ask for fewer links, other areas, or another outline"
    )
