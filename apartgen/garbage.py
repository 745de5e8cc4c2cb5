"""How often Python looks through everything for garbage in cycles."""

import gc

FRESH = 50_000
"""Objects more than were freed before the youngest are looked at; 700 by default."""


def seldom() -> None:
    """Look less often: what is made here is hardly ever in a cycle, and the packages that are loaded are a hundred
    thousand objects to go through each time. For programs; a library leaves such things to who uses it.
    """
    gc.set_threshold(FRESH, *gc.get_threshold()[1:])
