"""The stages of reading chained: tokens, lexemes, phrases, statements."""

from dataclasses import replace

from apartgen.stages.plan.reader.about import about
from apartgen.stages.plan.reader.anaphora import bind, counted, exceptions, says_what_is_there, shared_verb, unfolded
from apartgen.stages.plan.reader.apiece import bedrooms_apiece
from apartgen.stages.plan.reader.articles import definite
from apartgen.stages.plan.reader.asides import having_something
from apartgen.stages.plan.reader.attachments import attach_owned
from apartgen.stages.plan.reader.beside_things import beside_things
from apartgen.stages.plan.reader.comparisons import compared_again, comparisons, summed
from apartgen.stages.plan.reader.corrections import corrected
from apartgen.stages.plan.reader.denied import all_denied
from apartgen.stages.plan.reader.descriptions import described
from apartgen.stages.plan.reader.distributed import each_beside_one
from apartgen.stages.plan.reader.elided import written_out
from apartgen.stages.plan.reader.ensuites import merge_ensuites
from apartgen.stages.plan.reader.exactly import furnished, names_all, sleeps_only
from apartgen.stages.plan.reader.home_working import working_at_home
from apartgen.stages.plan.reader.in_between import at_table
from apartgen.stages.plan.reader.intended import beyond_usual, intended
from apartgen.stages.plan.reader.known_words import in_known_words
from apartgen.stages.plan.reader.lexemes import lexemes
from apartgen.stages.plan.reader.lexicon import read_lexicon
from apartgen.stages.plan.reader.limited import limited, mutual, undoored
from apartgen.stages.plan.reader.measures import attach_areas, mark_headlines
from apartgen.stages.plan.reader.mention import Item, RoomPhrase, is_mark, rooms_of
from apartgen.stages.plan.reader.openplan import open_groups
from apartgen.stages.plan.reader.orders import orders
from apartgen.stages.plan.reader.people import housed
from apartgen.stages.plan.reader.persons import for_people
from apartgen.stages.plan.reader.phrases import Phraser
from apartgen.stages.plan.reader.positions import positions, role_of
from apartgen.stages.plan.reader.purposes import purposes
from apartgen.stages.plan.reader.quantities import quantities
from apartgen.stages.plan.reader.relations import place, relations
from apartgen.stages.plan.reader.remarks import of_that_home
from apartgen.stages.plan.reader.resized import of_the_last
from apartgen.stages.plan.reader.rooms_in_all import rooms_in_all
from apartgen.stages.plan.reader.scope import drop_alternatives, negate_links, spread_negation
from apartgen.stages.plan.reader.sized_things import sized_things
from apartgen.stages.plan.reader.stands_where import stands_where
from apartgen.stages.plan.reader.statements import Said, Statement, between_pairs, door_pairs, lists_doors, sentences
from apartgen.stages.plan.reader.tokens import tokenize
from apartgen.stages.plan.reader.unread import can_be_met, limits, without_taken
from apartgen.stages.plan.reader.uses import for_whom, sharers, uses
from apartgen.stages.plan.reader.vocabulary import Det, Trait

DONE = ("style", "only", "graph", "shape", "side", "side_role", "main_rooms", "flat_size", "unit", "ordinal")
"""Kinds that say nothing more once the whole prompt has been looked through."""
GUESTS = ("guests", "visitors")
"""Whom the second of `two bathrooms (one for guests)` is for."""


def parse(prompt: str) -> Said:
    """Everything a prompt says, as room phrases and statements between them."""
    lexicon = read_lexicon()
    working, text = working_at_home(prompt)
    text, in_all = rooms_in_all(text)
    text, sizes = sized_things(text)
    text, spots = stands_where(text)
    folded = in_known_words(text)
    placed, beyond = beside_things(without_taken(folded))
    people, text = housed(placed)
    whole, text = about(text)
    whole = replace(whole, people=people or whole.people or working.people, lived=whole.lived or working.speaking)
    words = lexemes(tokenize(text), lexicon)
    words = bedrooms_apiece(quantities(words), whole.people.count if whole.people else 0)
    words = purposes(for_people(words))
    beyond = [*sizes, *spots, *limits(folded), *beyond]
    said = Said(about=whole, prompt=prompt, working=working, in_all=in_all, beyond=beyond)
    said.corrected = [slip for word in words for slip in word.slips]
    if described(words, said):
        return said
    phraser = Phraser(lexicon).walk(words)
    said.unread += phraser.unread
    phraser.items = definite(written_out(corrected(phraser.items)))
    _whole(phraser.items, said)
    phraser.items = _asked(all_denied(phraser.items), said)
    before: list[RoomPhrase] = []
    known = 0
    last: list[Item] = []
    listed: list[Item] = []
    said.graph = said.graph or lists_doors(phraser.items)
    items = between_pairs(beyond_usual(phraser.items, rooms_of(phraser.items)))
    for sentence in sentences(door_pairs(items) if said.graph else items):
        sentence = sharers(unfolded(sentence))
        for_whom(sentence, last)
        bind(sentence, last, listed)
        listed = [*listed, *sentence] if says_what_is_there(sentence) else []
        last = [*last, *sentence]
        trail = place(said.statements[known:])
        known = len(said.statements)
        before = _sentence(sentence, said, before, trail)
    said.rooms += [room for room in said.seen_from if room not in said.rooms]
    each_beside_one(said)
    said.statements = at_table(can_be_met(said))
    return said


def _asked(items: list[Item], said: Said) -> list[Item]:
    """Adds what is asked of rooms beside doors and areas to `said`; returns the items without it."""
    items = limited(mutual(undoored(items), said), said)
    return positions(orders(uses(items, said), said), said)


def _whole(items: list[Item], said: Said) -> None:
    """What concerns the flat as a whole, wherever it stands."""
    for k, item in enumerate(items):
        match item.kind:
            case "only" if item.text == "nothing else" and furnished(items[:k]):
                pass
            case "only" if item.text == "nothing but" and [i.kind for i in items[k + 1 : k + 2]] == ["object"]:
                pass
            case "only" if item.text.endswith("all") and sleeps_only(items[:k]):
                pass
            case "only":
                said.only = said.only or item.value == "only" or names_all(items, k)
            case "graph":
                said.graph = True
            case "style":
                said.styles.append(item.value)
            case "open" if "plan" in item.text or "concept" in item.text:
                around = (items[k - 1] if k else Item("mark"), items[k + 1] if k + 1 < len(items) else Item("mark"))
                said.open_plan = said.open_plan or all(i.kind in ("mark", "dwelling") for i in around)
            case "opening" | "unneeded" | "instead":
                said.unread.append(item.text)
            case "shape" if _of_room(items[k + 1 : k + 3]):
                said.unread.append(item.text)
            case "shape":
                said.shape = item.value
            case "side_role" if item.value == "party_wall" and not any(
                i.kind == "side" for i in items[max(0, k - 4) : k + 5]
            ):
                said.unread.append(item.text)
            case "main_rooms" if said.main_rooms and item.number == 1:
                pass  # "three rooms apartment: one room for me, one for my brother"
            case "main_rooms":
                said.main_rooms = int(item.number) + _beside_living(items, k)
                said.equal = said.equal or _alike(items[k + 1 : k + 3])
            case "flat_size":
                said.flat_size *= item.number
            case "side" if role := role_of(items, k):
                said.sides.append((role, item.value))


def _beside_living(items: list[Item], k: int) -> bool:
    """`a living room and three other rooms`: it is none of the three."""
    around = (*items[max(k - 2, 0) : k], *items[k + 1 : k + 3])
    near = [i.value for i in around if i.kind in ("room", "conjunction")]
    return set(near[:2]) in ({"living_room", "and"}, {"living_room", "plus"})


def _alike(after: list[Item]) -> bool:
    """`three rooms of equal size`."""
    said_of = [i for i in after if i.kind != "copula"][:1]
    return bool(said_of) and said_of[0].kind == "compare" and said_of[0].number == -1


def _of_room(after: list[Item]) -> bool:
    """`an L-shaped living room` says nothing of the flat's outline."""
    room = after[0].room if after else None
    return room is not None and not room.headline and all(i.kind != "dwelling" for i in after)


def _sentence(items: list[Item], said: Said, before: list[RoomPhrase], trail: list[RoomPhrase]) -> list[RoomPhrase]:
    """Add one sentence to `said`; returns what "it" may mean in the next."""
    items = shared_verb(exceptions(counted(negate_links(drop_alternatives(items, said)))))
    spread_negation(items)
    mark_headlines(items, said)
    for item in items:
        if item.kind == "dwelling":
            said.dwelling = said.dwelling if said.dwelling == "studio" else item.value
    _it_is(items)
    summed(items)
    items = compared_again(items, before)
    items = [i for i in merge_ensuites(intended(of_that_home(items))) if i.kind != "stop"]
    if any(i.room is not None and i.room.type == "" and Trait.GUEST in i.room.labels for i in items):
        said.unread = [word for word in said.unread if word not in GUESTS]
    items = having_something(_closed(attach_areas(of_the_last(items, before), said)))
    items = [
        i for k, i in enumerate(items) if i.kind not in DONE and not (i.kind == "pronoun" and not _of_link(items, k))
    ]
    items = _adjectives(items, said)
    items, found = open_groups(items)
    said.statements += found
    items = attach_owned(items, said)
    items, found = comparisons(items)
    said.statements += found
    said.rooms += [r for r in rooms_of(items) if r not in said.rooms]
    doors = relations(items, before, trail, said.graph, said.statements)
    _two_halls(doors)
    said.statements += doors
    last = doors[0 if before else -1].left if doors else [r for r in rooms_of(items) if not r.negated][-1:]
    return last or before


def _two_halls(doors: list[Statement]) -> None:
    """`from the hall a passage leads to …`: no hallway leads to itself."""
    for s in doors:
        pairs = [(a, b) for a in s.left for b in s.right if a.type == b.type == "hallway"]
        for phrase in [p for pair in pairs for p in pair if p.quantifier == Det.A][-1:]:
            phrase.quantifier = Det.ANOTHER


def _closed(items: list[Item]) -> list[Item]:
    """Without the brackets of `kitchen (11 m²)`, once the area is taken."""
    empty = [k for k in range(len(items) - 1) if is_mark(items[k], "(") and is_mark(items[k + 1], ")")]
    return [item for k, item in enumerate(items) if k not in empty and k - 1 not in empty]


def _of_link(items: list[Item], k: int) -> bool:
    """`it` as the object of a relation: `the bedrooms open off it`."""
    return k > 0 and items[k].value == "it" and items[k - 1].kind == "link"


def _adjectives(items: list[Item], said: Said) -> list[Item]:
    """`the kitchen is small`: a size after its room."""
    out: list[Item] = []
    for k, item in enumerate(items):
        told = _second_adjective(items, k)
        said_of = [i for i in (out[:-1] if told else out) if i.kind != "copula" and i.text != "but"]
        last = said_of[-1].room if said_of else None
        if item.kind == "size":
            last = last or _headed_by(out)
            if last is not None:
                last.factor *= item.number
            else:
                said.unread.append(item.text)
        elif item.kind != "label":
            out.append(item)
        elif last is not None or (last := _headed(items, k)) is not None:
            last.labels.add(Trait(item.value))
        elif not any(i.kind == "dwelling" for i in out):
            said.unread.append(item.text)
    return out


def _second_adjective(items: list[Item], k: int) -> bool:
    """The `small` of `the kitchen is separate and small`."""
    kinds = [i.kind for i in items[max(k - 3, 0) : k]]
    return kinds == ["copula", "label", "conjunction"] and not any(i.kind == "negation" for i in items[:k])


def _headed_by(before: list[Item]) -> RoomPhrase | None:
    """The room of `living room: large`."""
    return before[-2].room if len(before) > 1 and is_mark(before[-1], ":") else None


def _it_is(items: list[Item]) -> None:
    """`there is a study for my work and it is small`, `12 m²`, `far from the bathroom`: said of the study."""
    for k, item in enumerate(items):
        told = _it(items[:k])
        if told is None:
            continue
        if item.value == "it" and [i.kind for i in items[k + 1 : k + 3]] == ["copula", "link"]:
            items[k] = Item("room", told.type, item.text, told)
        elif [i.kind for i in items[max(k - 2, 0) : k]] != ["pronoun", "copula"]:
            continue
        elif item.kind == "size":
            told.factor *= item.number
            items[k] = Item("stop", "", item.text)
        elif item.kind == "area" and not item.value and not told.areas and not told.headline:
            told.areas, told.sides, told.bounds = item.values, item.sides, item.bounds
            items[k] = Item("stop", "", item.text)


def _it(before: list[Item]) -> RoomPhrase | None:
    """What `it` is after a clause: its subject, or the last of the rooms that it lists."""
    at = [k for k, i in enumerate(before) if i.room is not None and not i.room.plural and (i.room.count or 1) == 1]
    if not at:
        return None
    verb = any(i.kind == "link" or i.value == "has" for i in before[at[0] :])
    return before[at[0 if verb else -1]].room


def _headed(items: list[Item], k: int) -> RoomPhrase | None:
    """`hub: living room`."""
    return items[k + 2].room if k + 2 < len(items) and is_mark(items[k + 1], ":") else None


def mentions(statements: list[Statement]) -> set[int]:
    """Ids of the phrases that stand in a statement, which more often speak of known rooms."""
    return {id(p) for s in statements for p in (*s.left, *s.right)}
