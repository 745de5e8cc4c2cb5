"""How often Python looks through everything for garbage in cycles, and what becomes of the memory of freed arrays."""

import gc

FRESH = 50_000
"""Objects more than were freed before the youngest are looked at; 700 by default."""
KEPT = 31 << 20
"""Bytes of the greatest array whose memory is kept; the C library sets no store by more than 32 MiB."""


def seldom() -> None:
    """Look less often: what is made here is hardly ever in a cycle, and the packages that are loaded are a hundred
    thousand objects to go through each time. For programs; a library leaves such things to who uses it.
    """
    gc.set_threshold(FRESH, *gc.get_threshold()[1:])


def hold() -> None:
    """Keep the memory of freed arrays for the next ones: the C library does so for arrays up to the size of the
    greatest that it has freed, and otherwise has every page of each cleared anew.
    """
    bytes(KEPT)  # none of it is touched


def no_more() -> None:
    """Leave alone all that there is: a program that ends need not look whether its packages are garbage, which takes
    longer than many a command. What is in no cycle is still closed and freed; so is what asked for it at the exit.
    """
    gc.freeze()
