"""The stages, each `run(previous, config, rng) -> next`, and the floor that they share.

No stage imports another. What two need lives on the shared floor: `space`, `things`, `scene`, `robot`, `registry`.
"""
