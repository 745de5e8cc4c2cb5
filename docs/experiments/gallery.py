"""Twelve homes that are shown, by their sentences and seeds."""

from collections.abc import Iterator

import apartgen
from apartgen.stages.space import polygons

HOMES = (
    ("studio with a balcony", 11, "living_room"),
    ("one-bedroom flat with a large kitchen", 12, "kitchen"),
    ("two-bedroom flat with open kitchen", 13, "living_room"),
    ("three-bedroom flat with two bathrooms", 14, "bedroom"),
    ("flat for a family of four", 15, "living_room"),
    ("two-bedroom flat with a study and a balcony", 16, "study"),
    ("four-bedroom flat", 17, "living_room"),
    ("one-bedroom flat, 48 m2", 18, "bedroom"),
    ("Zweizimmerwohnung mit Balkon und Abstellraum", 19, "living_room"),
    ("appartement de trois pièces avec une cuisine ouverte", 20, "kitchen"),
    ("flat for a couple with a home office", 21, "living_room"),
    ("loft of 70 m2 with one bedroom", 22, "bedroom"),
)
"""What was asked for, the seed, and the type of the room whose picture is shown."""


def made() -> Iterator[tuple[str, object, str]]:
    """Each home: its number as it is written, the artifact with all small things, and the room to be shown."""
    for k, (text, seed, room) in enumerate(HOMES, 1):
        plan = apartgen.plan(text, seed=seed)
        home = apartgen.walkable(apartgen.retrieve(apartgen.layout(plan)))
        yield f"{k:02d}", apartgen.populate(home), room


def told(home) -> str:
    """A home in a few words."""
    area = sum(polygons.floor(room).area for room in home.body.rooms)
    return f"{area:.0f} m², {len(home.body.rooms)} rooms, {len(home.body.objects)} things"
