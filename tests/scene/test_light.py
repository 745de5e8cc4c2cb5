"""The light of lamps."""

import numpy as np

from apartgen.stages.scene.light import LAMP


def test_lamps_are_warmer_than_daylight() -> None:
    """As any glowing body cooler than the sun: more red than green and more green than blue."""
    red, green, blue = LAMP
    assert red > green > blue > 0 and np.isfinite(LAMP).all()
