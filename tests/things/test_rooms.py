"""Types of room name only categories and uses that there are, and what they are like in any order."""

import re
from types import SimpleNamespace

import pytest

from apartgen.schemas import rooms
from apartgen.schemas.errors import BadInput
from apartgen.schemas.plugins import Plugin
from apartgen.stages.plan.reader import lexicon
from apartgen.stages.things.rooms import furnishing

BROUGHT = Plugin("mine", "mine:rooms.toml", "my-home")


@pytest.fixture
def brought(monkeypatch):
    """Brings types of room, as a package would; gives what is warned of."""
    said = []

    def bring(rows):
        monkeypatch.setattr(rooms.plugins, "facts", lambda group: iter([(BROUGHT, rows)]))
        monkeypatch.setattr(rooms, "log", SimpleNamespace(warning=lambda form, text: said.append(text)))
        return said

    for function in (rooms._all, furnishing):
        function.cache_clear()
    yield bring
    for function in (rooms._all, furnishing):
        function.cache_clear()


def test_those_that_always_exist_are_sound():
    assert all(furnishing(name).name == name for name in rooms.kinds())


def test_one_may_be_like_a_later_one(brought):
    said = brought({"den": {"like": "snug"}, "snug": {"like": "study", "area": 7}})
    assert rooms.kinds()["den"].base == "study" and said == []


@pytest.mark.parametrize("row, fault", [
    ({"like": "studdy"}, r"\[gym\] like: 'studdy' is no type of room; did you mean 'study'\?"),
    ({"like": "gym"}, r"\[gym\] like: 'gym' is no type of room"),
    ({"like": "study", "word": ["gym"]}, r"\[gym\] word: there is no fact of that name; did you mean 'words'"),
    ({"like": "study", "area": "big"}, r"\[gym\] area: 'big' is no number"),
    ({"like": "study", "area": "big" * 20}, rf"\[gym\] area: '{('big' * 20)[:40]}' is no number"),
    ({"like": "study", "objects": {"bench": -1}}, r"\[gym\] objects.bench: '-1' is less than 0"),
])
def test_a_faulty_entry_is_left_out_and_told(brought, row, fault):
    said = brought({"gym": row})
    assert "gym" not in rooms.kinds() and re.match(rf"my-home: mine = 'mine:rooms.toml': {fault}", said[0]), said


@pytest.mark.parametrize("row, fault", [
    ({"objects": {"mirrror": 1}}, r"^my-home: .*\[gym\] objects: 'mirrror' is no category; did you mean 'mirror'"),
    ({"keeps": {"cok": 1}}, r"^my-home: .*\[gym\] keeps: 'cok' is no use; did you mean .*'cook'"),
])
def test_furniture_that_there_is_not_is_told_with_the_package(brought, row, fault):
    brought({"gym": {"like": "study"} | row})
    with pytest.raises(BadInput, match=fault):
        furnishing("gym")


def test_a_type_takes_no_word_that_is_spoken_for(brought, monkeypatch):
    """But for its own name, and for what is said of what it is like, of which it is one kind."""
    words = ["bedroom", "Bedrooms", "Fitness room", "studio", "sofa", "study", "office"]
    brought({"gym": {"like": "study", "words": words},
             "library": {"like": "study", "words": ["book room", "fitness room", "library"]}})
    said = []
    monkeypatch.setattr(lexicon, "log", SimpleNamespace(warning=lambda form, text: said.append(text)))
    entries = lexicon.read_lexicon.__wrapped__().entries
    means = {word: entries.get(tuple(word.split()))[0].value for word in (
        "bedroom", "bedrooms", "fitness room", "gym", "library", "book room", "studio", "sofa", "fitness rooms",
        "study", "office", "offices", "libraries")}
    assert means == {"bedroom": "bedroom", "bedrooms": "bedroom", "fitness room": "gym", "gym": "gym",
                     "library": "library", "book room": "library", "studio": "studio", "sofa": "sofa",
                     "fitness rooms": "gym", "study": "study", "office": "gym", "offices": "gym",
                     "libraries": "library"}
    form = r"\[(\w+)\] words: '([\w ]+)' is said of another, (\w+); left out"
    told = [re.search(form, text).groups() for text in said]
    assert told == [("gym", "bedroom", "bedroom"), ("gym", "bedrooms", "bedroom"), ("gym", "studio", "studio"),
                    ("gym", "sofa", "sofa"), ("gym", "study", "study"), ("library", "fitness room", "gym")]
