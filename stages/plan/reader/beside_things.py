"""Where in a room things are to stand: told, as no plan is asked for it, and what they stand by is not asked for."""

import re

WHY = "where in its room a thing stands is not asked of a plan"
_THING = (
    r"(?:(?:dining|coffee|bedside|kitchen|low) tables?|tables?|(?:tv|television) (?:stand|set)|tvs?|televisions?|"
    r"(?:single|double|bunk|king|queen|twin) beds?|beds?|sofas?|couch|desks?|wardrobes?|sideboards?|piano|sink|hob|"
    r"book(?:shelf|case)s?|fireplace|armchairs?|nightstands?|bedside cabinets?|dressers?|chest of drawers|stove|oven|"
    r"fridge|washing machine|lamp|mirror)"
)
_BY = (
    r"(?:opposite(?: to)?|facing|across from|in front of|behind|beside|next to|near(?: to)?|close to|by|below|above|"
    r"over|under(?:neath)?|beneath|on(?: top of)?|at the (?:foot|head|end|side) of|to the (?:left|right) of)"
)
_PLACED = re.compile(
    rf"(?<=[a-z]) {_BY} (?:the|each|every|his|her|our|your|their|its|my) {_THING}(?![a-z]| ?rooms?\b|-)"
    r"|(?<=[a-z]) on(?: top of)? it(?=$|[.,;:!\n)]| (?:and|in) )"
)
_COUNTER = re.compile(r"(?<=[a-z]) on (?:the|a|our|my) kitchen (?:counter ?top|counter|work ?top|bench|work surface)\b")
"""What is the kitchen's: things on it stand in the kitchen."""
_OF_A_ROOM = re.compile(r"(?:rooms?|kitchen|hall|hallway|bath|study|balcony|lounge|toilet|door|window)$")
"""What lies beside a thing as a room: there it is the room's place that is said."""


def beside_things(folded: str) -> tuple[str, list[tuple[str, str]]]:
    """A folded text without where things stand beside others, and these words with why they are left out."""
    said: list[tuple[str, str]] = []

    def left_out(found: re.Match[str]) -> str:
        if _OF_A_ROOM.search(folded[: found.start()]):
            return found.group()
        said.append((found.group().strip(), WHY))
        return ""

    def of_kitchen(found: re.Match[str]) -> str:
        said.append((found.group().strip(), WHY))
        return " in the kitchen"

    return _PLACED.sub(left_out, _COUNTER.sub(of_kitchen, folded)), said
