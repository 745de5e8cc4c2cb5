"""Descriptions: texts that go from room to room and say where each lies, how large it is and what it is next to.

In such a text a name always means the same room, and what is said belongs to the room the clause began with.
"""

from apartgen.stages.plan.reader.lexeme import Lexeme
from apartgen.stages.plan.reader.mention import RoomPhrase
from apartgen.stages.plan.reader.names import Name, names
from apartgen.stages.plan.reader.positions import FACING
from apartgen.stages.plan.reader.sense import sense
from apartgen.stages.plan.reader.statements import Asked, Said, Statement
from apartgen.stages.plan.reader.topics import Reading, Topic
from apartgen.stages.plan.reader.vocabulary import Det, Relation, Trait

TOPICS, PLACED = 4, 3
"""Rooms that a description says something of, and of whose place it does."""
SMALLEST, LARGEST = 0.2, 8.0
"""Part of a type's least area below which, and times its usual one above which, a size is a slip."""


def described(words: list[Lexeme], said: Said) -> bool:
    """Whether the text is a description; what it says is then added to `said`."""
    parts = names(words)
    reading = Reading(parts)
    topics = list(reading.topics.values())
    named = {part.name for part in parts if part.name is not None}
    told = sum(t.area is not None or t.placed() for t in topics)
    if told < TOPICS or sum(t.placed() for t in topics) - _faced(words) < PLACED or len(topics) < 0.6 * len(named):
        return False
    rooms = {name: _phrase(name) for name in [*reading.topics, *_beside_topics(named, reading)]}
    said.rooms += rooms.values()
    for topic in topics:
        _say(topic, rooms, said)
    _bathrooms(topics, rooms, said)
    _balconies(topics, rooms, said)
    said.only = said.described = True
    said.unread += reading.unread
    return True


def _faced(words: list[Lexeme]) -> int:
    """How many lines of a list, `kitchen: 9 m², faces north`, tell a side that a room faces and not where it lies."""
    lists = any(word.kind == "mark" and word.text in (":", "-") for word in words)
    return sum(word.kind == "side" and any(part in word.text for part in FACING) for word in words) if lists else 0


def _beside_topics(named: set[Name], reading: Reading) -> list[Name]:
    """Rooms that others are next to and of which no more is said; one may be another name of a room described."""
    kinds = {name.type for name in reading.topics}
    near = {name for t in reading.topics.values() for name in (*(n for _, n in t.links), *(b[2] for b in t.beside))}
    own = [name for name in named if name.number or name.trait in ("master", "") and name.type == "bedroom"]
    others = [name for name in named - set(reading.topics) if name.type not in kinds or name in own]
    kept = [n for n in others if n.number or n.trait == "master" or (n in near and n.type != "hallway")]
    reading.unread += [name.type.replace("_", " ") for name in others if name not in kept]
    return sorted(kept)


def _bathrooms(topics: list[Topic], rooms: dict[Name, RoomPhrase], said: Said) -> None:
    """Of several bathrooms, one that is next to bedrooms alone opens off the first of these, others do not."""
    baths = [t for t in topics if t.name.type == "bathroom"]
    for topic in baths if len(baths) > 1 else []:
        near = [name for _, name in topic.links]
        if near and all(name.type in ("bedroom", "balcony", "bathroom") for name in near):
            bedrooms = [name for name in near if name.type == "bedroom"][:1]
            said.statements += [Statement(Relation.DOOR, [rooms[topic.name]], [rooms[n]]) for n in bedrooms]
        else:
            rooms[topic.name].labels.add(Trait.SEPARATE)


def _balconies(topics: list[Topic], rooms: dict[Name, RoomPhrase], said: Said) -> None:
    """A balcony that is said to be next to bedrooms, and to no room one lives in, opens off the first of these.

    So does one that lies at the other side of the home than the living room, off what it is next to at its own side.
    """
    sides = {t.name: set("_".join(t.places[:1]).split("_")) - {""} for t in topics}
    living = next((name for name in sides if name.type == "living_room"), None)
    for topic in [t for t in topics if t.name.type == "balcony"]:
        around = [(one, other) for t in topics for one, _, other in t.beside if topic.name in (one, other)]
        around += [(t.name, name) for t in topics for _, name in t.links if topic.name in (t.name, name)]
        near = [one if other == topic.name else other for one, other in around]
        bedrooms = [name for name in near if name.type == "bedroom" and name in rooms]
        if living is not None and _opposed(sides[topic.name], sides[living]):
            bedrooms = [name for name in bedrooms if not _opposed(sides[topic.name], sides.get(name, set()))]
        elif not all(name.type in ("bedroom", "bathroom", "balcony") for name in near):
            bedrooms = []
        if bedrooms:
            said.statements.append(Statement(Relation.ONLY, [rooms[topic.name]], [rooms[bedrooms[0]]]))


def _opposed(one: set[str], other: set[str]) -> bool:
    """Whether one lies at a side and the other at that across from it."""
    across = {"north": "south", "south": "north", "east": "west", "west": "east"}
    return any(across.get(side) in other for side in one)


def _phrase(name: Name) -> RoomPhrase:
    traits = {Trait(name.trait)} if name.trait else set()
    text = " ".join(part for part in (name.trait, name.type.replace("_", " "), str(name.number or "")) if part)
    return RoomPhrase(name.type, traits, quantifier=Det.ANOTHER, text=text)


def _say(topic: Topic, rooms: dict[Name, RoomPhrase], said: Said) -> None:
    """Adds size, places, neighbours and doors of one room."""
    room = rooms[topic.name]
    usual = max(sense()["least"][room.type] * SMALLEST, 0.5), sense()["area"][room.type] * LARGEST
    if topic.area is not None and usual[0] <= topic.area.values[0] <= usual[1]:
        room.areas, room.sides, room.bounds = topic.area.values[:1], topic.area.sides, topic.area.bounds
    elif topic.area is not None:
        said.unread.append(topic.area.text)
    for value in topic.places[:1]:
        said.asked.append(Asked("position", [room], "", value, f"{room.text} {value}"))
    first = set("_".join(topic.places[:1]).split("_"))  # more is said of parts of the room
    said.unread += [value.replace("_", " ") for value in topic.places[1:] if not set(value.split("_")) <= first]
    for one, value, other in dict.fromkeys(topic.beside):
        if one in rooms and other in rooms and value != "centre":
            text = f"{rooms[one].text} {value} of {rooms[other].text}"
            said.asked.append(Asked("position", [rooms[one]], [rooms[other]], value, text))
    known = [{id(s.left[0]), id(s.right[0])} for s in said.statements]
    for relation, name in dict.fromkeys(topic.links):
        if name in rooms and {id(room), id(rooms[name])} not in known:
            words = "next to" if relation == Relation.NEAR else "door to"
            said.statements.append(Statement(relation, [room], [rooms[name]], relation=words))
