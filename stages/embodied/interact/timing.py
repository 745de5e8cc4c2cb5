"""When the servos are told what: paths of postures as targets, one a step."""

import numpy as np

from apartgen.stages.space.boxes import Array


def timed(path: Array, spans: Array, timestep: float, ramp: float) -> Array:
    """Points of a path (k, 13) whose legs take `spans` seconds, one a step, gathering and losing speed evenly."""
    ends = np.concatenate([[0.0], np.cumsum(np.maximum(spans, 1e-6))])
    total = float(ends[-1])
    ramp = min(ramp, total)
    t = np.linspace(0, total + ramp, max(3, int(np.ceil((total + ramp) / timestep)) + 1))[1:]
    left = total + ramp - t
    # Constant speed between two parabolas.
    here = np.where(t < ramp, t * t / (2 * ramp), np.where(left < ramp, total - left * left / (2 * ramp), t - ramp / 2))
    return np.stack([np.interp(here, ends, column) for column in path.T], 1)


def smoothed(targets: Array, width: int) -> Array:
    """The mean over `width` rows on each side, the ends staying where they are."""
    padded = np.concatenate([targets[:1].repeat(2 * width, 0), targets, targets[-1:].repeat(2 * width, 0)])
    total = np.cumsum(padded, axis=0)
    return np.asarray((total[2 * width :] - total[: -2 * width]) / (2 * width))
