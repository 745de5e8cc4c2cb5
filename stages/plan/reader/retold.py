"""What is said of the rest, of whose each is, or taken back, in words the rules know."""

import re

from apartgen.stages.plan.reader.faced import facing
from apartgen.stages.plan.reader.kin import pattern
from apartgen.stages.plan.reader.lexicon import read_lexicon
from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import CHILD, YOUNG

_YOUNG = rf"(?:{YOUNG}|{CHILD}|babies)"
_AGE = (r"(?:aged? )?(?:\d{1,2}|two|three|four|five|six|seven|eight|nine|ten)(?:,? ?(?:and|&) ?\d{1,2})*"
        r"(?: years?(?: old)?| months?(?: old)?)?")
_DO = r"(?:each|both|all|has|have|gets?|needs?|wants?|shares?|sleeps?|takes?)"


_NAMED = late(rf"\b[a-z]{{3,}} \({_AGE}\)(?:(?:,| and|, and| &) [a-z]{{3,}} \({_AGE}\))* (?={_DO}\b)")


def _children(found: re.Match[str]) -> str:
    """`Emma (9) and Noah (5)` as children, where words of the lexicon are none of them."""
    lexicon = read_lexicon()
    names = re.findall(r"([a-z]+) \(", found.group())
    kinds = {e.kind for name in names for e in lexicon.entries.get((name,)) or ()}
    known = kinds & {"room", "furniture", "dwelling"} or any(n.endswith(tuple(lexicon.suffixes)) for n in names)
    grown = any(int(age) > 17 for age in re.findall(r"\d+", found.group()))
    if known or grown or any(pattern("^(?:{who})$").search(name) for name in names):
        return found.group()
    return f"{len(names)} children " if len(names) > 1 else "a child "


def children_named(text: str) -> str:
    """A folded text with children in the place of names with ages, of whom it says what they have."""
    return _NAMED.sub(_children, text)


def _theirs(found: re.Match[str]) -> str:
    """`two baths: hers off the bedroom, his off the hall` as the first and the second."""
    names = iter(("the first", "the second", "the third"))
    return re.sub(r"\b(?:his|hers|mine|ours|theirs)\b", lambda one: next(names, one.group()), found.group())


_KIND = r"(?:an?|the|one|two|my|our|home|small|large|big|quiet|separate|guest|with|for|second)"
"""With which begins what is said of a study that is a room."""
_SAID = [(late(said), words) for said, words in (
    # "all face south except the smallest, which faces north", "two baths: hers off the bedroom, his off the hall"
    (r"\b(except|apart from|other than) (the [a-z]+(?: one| bed ?room| bath ?room)?),? which "
     r"(?=(?:faces|is|has|gets|opens|lies)\b)", r"\1 \2. \2 "),
    (r"\b(?:two|2) (?:bath ?rooms|baths|studies|offices|balconies|closets)\b[^.;:]{0,20}[:;.,-] ?(?:and )?"
     r"(?:his|hers|mine)\b[^.;]*", _theirs),
    # "The kitchen is 10 m² - er, 12.", "the balcony can go", "half of it for the living room"
    (r"(?:,| -)+ ?(?:erm?|uhm?|umm?|ah|eh),? (?=\d|no\b|make|sorry|rather|i mean)", ", sorry, "),
    (r"\bthe ([a-z ]{4,16}?) (?:can|may|has to|should|must) (?:also )?go(?= ?(?:[.,;!]|$))", r"forget the \1"),
    (r"\b(half|a third|a quarter|two thirds|\d\d ?%) of (?:it|that|this)(?: is| goes| being)? (?:for|to) the "
     r"([a-z]+(?: room)?)",
     r"the \2 is \1 of the area"),
    # "a door to the bedroom and none from the hall"
    (r"\b(and|but) none from (?=the )", r"\1 none to "),
    # "two ways into the bathroom, one door from the bedroom and one from the hallway"
    (r"(?:,? (?:with|and)|\bthere are) two (?:ways in(?:to)?|entrances (?:in)?to|doors (?:in)?to) "
     r"(the [a-z]+(?: room)?)[,:]? one(?: door)? (?:from|off) (the [a-z ]+?) and (?:one|another|the other)(?: door)? "
     r"(?:from|off) (the [a-z ]+?)(?= ?(?:[.,;]|$))", r". \1 has a door to \2 and a door to \3"),
    # "twins of six who share a room", "as the plan allows"
    (rf"\b({_YOUNG}),? (?:\({_AGE}\)|(?:of|aged?) {_AGE})(?=,? (?:who\b|that\b|{_DO}\b)|[.,;:])", r"\1"),
    (r"\bas (far|close|near) (apart |together |away )?as (?:the (?:plan|layout|flat|space)|it|space) "
     r"(?:allows?|permits?|can be)\b", r"as \1 \2as possible"),
    # "the last is grandma's", "they share one and sleep in two beds", "with a shower room entered only from it"
    (r"\b(shares? (?:one|an? (?:bed ?)?room|the [a-z ]{0,12}room)) and sleeps? in (?=(?:an?|two|three|[234]) )",
     r"\1 with "),
    (r"\bwith an? ((?:shower|bath) ?room|shower|toilet),? (?:(?:which|that) (?:is|can be) )?"
     r"(?:entered |reached |accessible )?only (?:entered |reached |accessible )?from (?:it|there)\b",
     r"with its own \1"),
    (r"\b(?:one|the (?:last|other|second|third|fourth))(?: one| room| bed ?room)? is (?:for )?"
     r"((?:my |our |the )?[a-z]+)'s(?:,(?= with))?(?= ?(?:[.,;]|$)| (?:and|with)\b)", r"\1 has a room"),
    # "a bedroom of their own", "Lidar occlusion study: two bedrooms"
    (r"\ban? ((?:bed ?)?room) of (?:their|his|her|its) own\b", r"their own \1"),
    (rf"^(?!{_KIND}\b)(?:[a-z-]+ ){{1,4}}study ?: ?(?=[^.;]{{0,40}}\bbed ?rooms?\b)", ""),
)]  # fmt: skip


def retold(text: str) -> str:
    """A folded text with such clauses in the words of rooms."""
    for said, words in _SAID:
        text = said.sub(words, text)
    return facing(text)
