"""What of a sofa round a corner is what: seats along its back, and a chaise at its left end that comes to its front."""

SEAT, SEAT_SHARE = 0.98, 0.67
"""From the back to the front of the seats, m, and of the whole depth at most, as they are sold (.99 of 1.51 m)."""
CHAISE, CHAISE_SHARE = 1.0, 0.38
"""How wide the chaise is, m, and of the whole width at most."""


def seat_depth(depth: float) -> float:
    """Depth of the seats beside the chaise, m."""
    return min(SEAT, SEAT_SHARE * depth)


def chaise_width(width: float) -> float:
    """Width of the chaise, m."""
    return min(CHAISE, CHAISE_SHARE * width)
