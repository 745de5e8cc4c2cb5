"""Projection: a sample arranged by rules, so that nothing collides, blocks a door or leaves its room.

Objects take their places one after another, large ones first, each at the cheapest of a few hundred candidate
places about where the model put it, those at what it belongs with by habit first; kitchen units stand in runs. What
still breaks a requirement is placed again, then smaller, then anywhere. At last what cuts the floor in two or is out
of reach is shifted, tucked in or narrowed.
"""
