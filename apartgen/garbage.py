"""How often Python looks through everything for garbage in cycles."""

import gc

FRESH = 50_000
"""Objects more than were freed before the youngest are looked at; 700 by default."""


def seldom() -> None:
    """Look less often: what is made here is hardly ever in a cycle, and the packages that are loaded are a hundred
    thousand objects to go through each time. For programs; a library leaves such things to who uses it.
    """
    gc.set_threshold(FRESH, *gc.get_threshold()[1:])


def no_more() -> None:
    """Leave alone all that there is: a program that ends need not look whether its packages are garbage, which takes
    longer than many a command. What is in no cycle is still closed and freed; so is what asked for it at the exit.
    """
    gc.freeze()
