"""The reward terms by name, and what each counts unless a programme says otherwise."""

WEIGHTS: dict[str, float] = {
    "shortest_path": 20.0,
    "typical_area": 20.0,
    "aspect_ratio": 5.0,
    "convexity": 50.0,
    "conciseness": 8.0,
    "exterior_length": 40.0,
    "exterior_corner": 8.0,
    "collinearity": 1.0,
    "functional_room": 10.0,
    "narrow_passage": 0.6,
    "staircase_occupancy": 1.0,
    "staircase_iou": 0.5,
    "near_rooms": 1.5,
    "wide_corridor": 8.0,
    "privacy": 28.0,
}
"""Reward terms and their weights; a programme multiplies them. The two of staircases are 0 on one storey. `near_rooms`
(wet rooms apart, the kitchen apart from where one eats), `wide_corridor` and `privacy` (bedrooms nearer the entrance
than the living room) are added to the field's twelve."""


def counted(factors: dict[str, float], urge: float) -> list[float]:
    """What each term counts with a programme's factors; of those above 1 a share, lest no plan be found for them."""
    return [weight * _urged(factors.get(name, 1.0), urge) for name, weight in WEIGHTS.items()]


def _urged(factor: float, urge: float) -> float:
    return min(factor, 1.0 + urge * max(factor - 1.0, 0.0))
