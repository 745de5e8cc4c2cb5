"""Where on the drawing words point: `north east corner`, `top left`, `middle of the south side`."""

_POINTS = {
    "N": "north northern northernmost northerly northward top upper topmost upside",
    "S": "south southern southernmost southerly southward bottom lower bottommost downside",
    "E": "east eastern easternmost easterly eastward right rightmost righthand rightside",
    "W": "west western westernmost westerly westward left leftmost lefthand leftside",
    "NE": "northeast northeastern",
    "NW": "northwest northwestern",
    "SE": "southeast southeastern",
    "SW": "southwest southwestern",
    "C": "center centre middle central centrally",
}
_WORDS = {word: frozenset(points) for points, words in _POINTS.items() for word in words.split()}
_NAMES = {"N": "north", "S": "south", "E": "east", "W": "west", "C": "centre"}
HANDS = ("left", "right")
"""Words that also say other things: `right next to`."""
OF_ANOTHER = ("upside", "downside", "leftside", "rightside")
"""Words that say where a room lies of another one."""
SIDES = frozenset(
    "side sides corner hand handed part portion end edge wall most half section area region direction".split())
"""What may stand behind a point of the compass."""


def points(word: str) -> frozenset[str]:
    """The points a word names, none for other words."""
    return _WORDS.get(word, frozenset())


def place(found: set[str]) -> str:
    """The place on the drawing that points make together, "" for points that contradict one another."""
    sides = found - {"C"}
    if {"N", "S"} <= sides or {"E", "W"} <= sides or not found:
        return ""
    if not sides:
        return "centre"
    return "_".join(_NAMES[point] for point in "NSEW" if point in sides)
