"""The light of lamps."""

from apartgen.stages.scene import light


def test_lamps_are_warmer_than_daylight() -> None:
    """As any glowing body cooler than the sun: more red than green and more green than blue."""
    red, green, blue = light.LAMP
    assert red > green > blue > 0
