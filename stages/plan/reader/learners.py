"""English as those write it who learn it, in the words and the order of those who do not."""

import re

from apartgen.stages.plan.reader.pieces import ROOM, reworded, rules

_HELPED = "".join(rf"(?<!\b{verb} )" for verb in "must should may shall can could will would need do does did".split())
"""No verb before that makes a `not` English: `must not have`."""
_LIVING = re.compile(r"\b(?:living|lounge|sitting|main room|salon)")


def _big_room(found: re.Match[str]) -> str:
    """`hall, kitchen, big room and bedroom`: the big one is the living room, where none is named."""
    return found.group() if _LIVING.search(found.string) or "bedroom" not in found.string else f"{found[1]}living room"


def _of_a_home(found: re.Match[str]) -> str:
    """`a table where we can eat`: who we are says nothing but that it is a home, which other words may say."""
    return found[1] if re.search(r"\b(?:flat|apartment|house|home|bed ?rooms?)\b", found.string) else found.group()


_MOST = {"big": "biggest", "large": "largest", "small": "smallest"}
_SAID = rules((
    # "kitchen no have door", "I not need a balcony", "there is not balcony", "it is not balcony"
    (r"{helped}\b(no|not) (have|has) (?:an? |any )?", "has no "),
    (r"{helped}\b(?:no|not) (need|want|like|wish)s?(?= (?!to\b|for\b|of\b)[a-z])", r"do not \1"),
    (r"\b(?:there is|there are|it is) not (?:an? |any )?(?=(?:balcony|hall|corridor|study|dining|toilet|pantry|"
     r"storage|tv|sofa|"
     r"table|desk|bathtub|[a-z]+room)\b)", "there is no "),
    # "it is not needed a dining room", "two times so big as the kitchen", "a small room for to wash the clothes"
    (r"\b(?:it )?is not (?:needed|necessary|wanted|required) (?:an? |the |any )?(?={room}\b)", "there is no "),
    (r"\b(?P<n>two|three|four|2|3|4) times (?:so|more) (?:big|large|bigger|larger) (?:as|than|like)\b",
     r"\g<n> times as large as"),
    (r"\b(an? )?(?P<size>small |little |separate |extra )?(?:room|place|space) (?:for to|for|to|where (?:we|i) can) "
     r"(?:wash|do|dry)(?:ing)? (?:and (?:dry|iron)(?:ing)? )?(?:the |our |my )?(?:clothes|laundry|washing|linen)\b",
     r"\1\g<size>laundry room"),
    # "the parents have bedroom with own bathroom"
    (r"\b(?:the )?parents (?:have|has|get|need|want|should have|must have)(?: an?| the| their)?(?: own)? bed ?room "
     r"with (?:an? |the |their )?(?:own |private |separate )?(?=(?:bath ?room|shower|ensuite|toilet)\b)",
     "the parents' bedroom has its own "),
    # "Big room is 25 meters", "kitchen of 10 meters"
    (r"({room}) ?(is|are|has|of|about|:|,|-)? ?(about )?(\d{1,2}(?:\.\d)?) met(?:er|re)s?\b(?! ?(?:long|wide|by|x|"
     r"high|from|away|"
     r"square|deep|in|of|and \d))", r"\1 \2 \3\4 m2"),
    (r"(^|[.;,] ?)({room}) (is|must be|should be) (?!one\b|two\b|three\b|for\b|\d (?:room|bed)|in the plan)",
     r"\1the \2 \3 "),
    (r"\b((?:the |one |a )?)(?:big|large|great) room(?= ?(?:[.,;]|is|and|with|$))", _big_room),
    # "balcony not in bedroom but in kitchen"
    (r"\b((?:the |an? )?(?:balcony|terrace|closet|pantry|storage room)) not (?:in|off|on|at) (?:the |an? )?{room},? "
     r"but "
     r"(?:in|off|on|at) (?:the |an? )?({room})\b", r"\1 off the \2"),
    # "two balcony: one on living room, second on bedroom"
    (r"\b(?:two|2) (balcony|balconies|terraces?)[:,] (?:one|first) (?:on|in|at|from|off|near) (?:the )?({room}),? "
     r"(?:and )?(?:the )?"
     r"(?:second|other|one|another|the other)(?: one)? (?:on|in|at|from|off|near) (?:the )?({room})\b",
     r"a balcony off the \2 and another balcony off the \3"),
    # "in living room not must be table"
    (r"\bnot (must|should|can|may) be\b", r"\1 not be"),
    (r"(^|[.;,] ?|\band )(?:in|at) (?:the |my )?({room}) (?:there )?(?:must|should|can|may) not (?:be|have) (?:an? |"
     r"any )?"
     r"([a-z]+)", r"\1no \3 in the \2"),
    # "bathroom must have the door from bedroom, but also second door from corridor"
    (r"({room}) (?:must |should )?(?:has|have) (?:the |an? |one )?door (?:from|to|in) (?:the )?({room}),? (?:but |"
     r"and )?(?:also )?(?:the |an? )?"
     r"(?:second|another|other|one more|one)(?: door)? (?:from|to|in) (?:the )?({room})", r"\1 has a door to the \2 "
     r"and a door to the \3"),
    (r"({room}) without (?:an? |the )?doors? to (?:the )?{room},? (?:but )?only to (?:the )?({room})",
     r"\1 reached only from the \2"),
    # "in one bedroom two bed, in other one bed", "balcony for kitchen"
    (r"\bin (?:the )?one (?:bed ?room )?(two|three|one|an?) (?:single |double )?beds?,? (?:and )?in (?:the )?(?:other|"
     r"second|another)"
     r"(?: one| bed ?room)? (one|two|an?) (?:double |single )?beds?\b", r"the first bedroom has \1 double beds, the "
     r"second bedroom has \2 double bed"),
    (r"\b(balcony|terrace) for (?:the )?({room})\b", r"\1 off the \2"),
    (r"(\boff the {room}[.,;] ?(?:(?:no|sorry|actually|rather|better|wait),? )+)for the (?={room})", r"\1off the "),
    # "in bedroom stay bed and table for work", "the third is smallest", "no need balcony"
    (r"(^|[.;] ?)in (?:the |my )?({room}) (?:must |should )?(?:stays?|stands?|is standing|are standing) (?=[a-z])",
     r"\1the \2 has "),
    (r"\btable for (?:work|working|study|studying|writing)\b", "desk"),
    (r"\b(is|are) (smallest|largest|biggest)(?= ?(?:[.,;]|$))", r"\1 the \2"),
    (r"\b(is|are) (?:not|no) need(?= ?(?:[.,;]|$)| and | but )", r"\1 not needed"),
    (r"\bno doors? from (?:the )?({room}) (?:in|into|to|on) (?:the )?({room})\b", r"no door between the \1 and the \2"),
    (r"\bno need (?:of |for |to have )?(?:an? )?(?=[a-z])", "no "),
    (r"(?:^|[.;,] ?)(?:and )?in (?:the )?({room}) ((?:an? |one |two )?[a-z]+) and no ([a-z]+)(?= ?(?:[.,;]|$))",
     r". the \1 has \2 and no \3"),
    # "two bathrooms from the corridor"
    (r"\b(bath ?rooms?|toilets?) from the (?={hall})", r"\1 off the "),
    # "not make the kitchen open"
    (r"\b(?:please )?(?:do not|don't|not|never|no) (?:to )?(?:make|want|have|leave|like) (?:the |an? )?kitchen (?:to "
     r"be |be |which is )?"
     r"open\b(?! to)", "separate kitchen"),
    # "drawing and dining are having an opening", "each should be having a room", "the lounge is largest room"
    (r"\b(?:am|are) having (?=(?:an?|one|two|three|four|own|opening|no)\b)", "have "),
    (r"\bis (largest|biggest|smallest) room\b", r"is the \1 room"),
    (r"\bstudy tables?\b(?! lamp)", lambda found: "desks" if found.group().endswith("s") else "desk"),
    (r",? (?:as per|according to|following) vastu\b", ", vastu"),
    # "the bathroom is entering from the bedroom"
    (r"\b(is|are) (entering|accessing|reaching) from\b", r"\1 entered from"),
    (r"\b(from|to) ((?:the )?[a-z]+) and (?:from|to) ((?:the )?[a-z]+) (?:also|too)\b", r"\1 \2 and \1 \3"),
    # "the kitchen must be the most small room"
    (r"\b(?:the )?most (big|large|small)(?=(?: room| one)?(?:{end}| of | in ))", lambda found: f"the "
                                                                                               f"{_MOST[found[1]]}"),
    (r"\bmost (?:far|distant)(?: away)? from\b", "far from"),
    (r"\bmost (near|close)(?: to)?\b", "near"),
    # "bedroom are three", "bedroom is two, size is 13 m2 and 10 m2"
    (r"\b(bed|bath)( ?)rooms? (?:is|are|:) ?(two|three|four|five|[2-5])(?:{end}|(?= and ))", r"\3 \1\2rooms"),
    (r"(\b(?:two|three|four|[2-4]) (?:bed|bath) ?rooms)[,;:.]? ?(?:and |with )?(?:the |their |its )?(?:sizes?|areas?"
     r") (?:is |are |of |being |: ?)?"
     r"(?=\d)", r"\1 of "),
    # "one bed for two persons", "table for computer", "one near bedroom and other near door of entrance"
    (r"\b(?:one |an? )?(?:big )?bed for two(?: persons?| people)?\b", "a double bed"),
    (r"\b(?:one |an? )?bed for one(?: person)?\b", "a single bed"),
    (r"\b(?:cloth(?:es)? )?wash(?:er)?[ -]?machine\b", "washing machine"),
    (r"(\btables?(?: for [a-z]+)?),? (?:where|at which|on which) (?:i|we|you|one|they|the family) (?:can |could )?"
     r"(?:all )?(?:eat|dine|have (?:our )?(?:meals|dinner|breakfast))(?: together)?\b", _of_a_home),
    (r"\btable for (?:the |an? |my )?(?:computer|pc|laptop)\b", "desk"),
    (r"\band other (?=(?:one )?(?:near|next|beside|off|in|on|at|close|from)\b)", "and the other "),
    (r"\b(?:the )?door of (?:the )?entrance\b", "the entrance"),
    # "from living room is possible to go in the kitchen and in the balcony, but in bedroom only from corridor"
    (r"\bfrom (?:the )?({room}) (?:it )?is possible to (?:go|enter|come) (?:in|into|to|on) (?:the )?({room}) and "
     r"(?:in|into|to|on) (?:the )?({room})\b", r"the \1 has a door to the \2 and a door to the \3"),
    (r"\bfrom (?:the )?({room}) (?:it )?is possible to (?:go|enter|come) (?:in|into|to|on) (?:the )?({room})\b",
     r"the \1 has a door to the \2"),
    (r",? (?:but|and) (?:in|into|to) (?:the )?({room}) only from (?:the )?({room}){end}",
     r". the \1 is reached only from the \2"),
    # "we are students, four peoples, everyone wants own room", "two bathrooms from the corridor"
    (r"\bpeoples\b", "people"),
    (r"\bwe are {grown}, ({number}) (?=(?:{grown}|of us)\b)", r"we are \1 "),
    (r"(\b(?:bed|bath) ?rooms?|\btoilets?) from (?=(?:the )?{hall}{end})", r"\1 off "),
    # "kitchen is open with salon"
    (r"(?<!not )\bopen with (?=(?:the |our )?(?:salon|living|lounge|sitting|dining|kitchen|hall))", "open to "),
    # "flat for three person, each person must have own room"
    (r"\b({several}) person\b(?![ -](?:flat|family|household|home|apartment|house|bed))", r"\1 persons"),
    (r"\beach (?:person|people|one|of them|of us|of you)? ?(?:must |should |has to |have to |needs? to |will )?"
     r"(?:have|has|get|gets|needs?|wants?) (?:his |her |their |an? |the )?own (?:bed ?)?rooms?\b",
     "each has their own bedroom"),
), room=rf"(?:{ROOM}|room)", helped=_HELPED)  # fmt: skip


def as_learnt(text: str) -> str:
    """A folded text with such clauses put right."""
    return reworded(text, _SAID)
