"""Guidance energies, one a file: `energy(boxes, room) -> (B,)`, at least 0 and 0 when satisfied."""
