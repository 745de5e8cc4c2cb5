"""What holds nowhere, once more, for each, or in another way than was said, in words the rules know."""

import re

from apartgen.stages.plan.reader.pieces import reworded, rules

_THINGS = r"(?:an?|one|two|three|four|no|\d) (?:(?!has |have |is )[a-z]+,? ?){1,8}?"
_SAME = r"(?:the same|ditto|likewise)(?: things| furniture| pieces| again)?"
_FIXED = r"(?!(?:doors?|stairs?|steps?|walls?|windows?|corridors?|hall(?:way)?s?|passages?|(?:[a-z]+ )?rooms?)\b)"
_WHOLE = r"(?:anywhere|in any of the rooms|in any room|in the (?:whole |entire )?(?:flat|apartment|home|house))"
_SIDES = ("north(?:[- ]?(?:east|west))?|south(?:[- ]?(?:east|west))?|east|west|norden|suden|osten|westen|"
          "nord|sud|ouest|norte|sur|este|oeste")  # fmt: skip
_ANEW = ("no wait|wait no|wait|no|nein|non|sorry|pardon|perdon|i mean|i meant|actually|correction|or rather|rather|"
         "better|besser|quatsch|plutot|mejor")  # fmt: skip
_COUNTED = {"one": "one", "two": "one", "three": "two", "four": "three", "2": "one", "3": "two", "4": "three"}
_FEWER = {"one": "one", "two": "one", "three": "two"}
_PARENTS = r"(?:\b(?:we are )?(?:an? |the )?(?:couple|family|parents) (?:with|and|of) )?"
_OLD = (r"(?:the )?(?:eldest|oldest|youngest|third|fourth|other|boy|girl|one|big one|little one|baby)"
        r"(?: (?:one|child|boy|girl|son|daughter))?")  # fmt: skip
_WITH_US = (r"(?:sleeps?|stays?) (?:in|with) (?:us|ours|our (?:own )?(?:bed ?)?room|(?:the|his|her|its|their) parents"
            r"(?:' (?:bed ?)?room)?)")  # fmt: skip
_OURS = re.compile(r"\bfor us\b(?! alone)|"
                   r"\b(?:our|parents'?|master|main) (?:own )?bed ?room\b|\bbed ?room for (?:us|me)\b")
_MIND = (r"(?:on reflection|on second thoughts?|thinking about it|come to think of it|having thought about it|actually|"
         r"better|no|sorry|correction)")  # fmt: skip


def _with_parents(found: re.Match[str], rooms: str) -> str:
    """Rooms for children and, where nothing is said of it, one for those whose children they are."""
    rest = found.string[: found.start()] + "|" + found.string[found.end() :]
    ours = "" if _OURS.search(rest) else " and a parents' bedroom"
    return f"{rooms} kids room{'' if rooms == 'one' else 's'}{ours}"


def _sharing(found: re.Match[str]) -> str:
    """`three children: two of them share, the eldest has her own` as two rooms for them; grown people's are all.

    Whoever sleeps with the parents has none.
    """
    rooms = _COUNTED[found["n"]]
    rooms = _FEWER[rooms] if found["ours"] or found["and_ours"] else rooms
    return f"a flat with {rooms} bedrooms" if found["grown"] else _with_parents(found, rooms)


def _for_both(found: re.Match[str]) -> str:
    """`two kids, one room for both`, `three children in two rooms`."""
    return _with_parents(found, {"1": "one", "2": "two", "3": "three", "a": "one"}.get(found["rooms"], found["rooms"]))


def _summed(found: re.Match[str]) -> str:
    """`a home office each, so two studies` as the two of them."""
    return f"{found['n']} {found['rooms']}"


_SAID = rules((
    # "no tv anywhere", "no room has a television"
    (r"\b(?:no|not an?|not a single|without (?:an?|any)|(?:do not|don't) want any) ({fixed}[a-z]+(?: [a-z]+)?) "
     r"{whole}\b", r"no \1 in every room"),
    (r"\bnowhere an? ({fixed}[a-z]+)\b", r"no \1 in every room"),
    (r"(^|[.;,] ?)(?:no room|none of the rooms) (?:has|have|should have|must have|may have) an? ({fixed}[a-z]+)\b",
     r"\1no \2 in every room"),
    # "a desk in the study, the same in the main bedroom"
    (r"\b({things}) in ((?:the|each|every|both)(?: of the (?:two|three|four))? {kind}s?)(?:[,;.] ?|,? )"
     r"(?:and |but )?{same} in the ({kind})\b", r"\1 in \2 and \1 in the \3"),
    (r"\bthe ({kind}) (has|gets|needs|with) ({things})(?:[,;.] ?|,? )(?:and |but )?{same} "
     r"(?:in|for|goes for|holds for|applies to) the ({kind})\b", r"the \1 \2 \3, the \4 \2 \3"),
    (r"\bthe ({kind}) (has|gets|needs) ({things})(?:[,;.] ?|,? )(?:and |but )?the ({kind}) "
     r"(?:has|gets|needs|too has|also has) {same}(?= ?(?:[.,;]|$))", r"the \1 \2 \3, the \4 \2 \3"),
    # "a room that is open to the kitchen"
    (r"\b(an?|one) ((?:big |large |small |bright |spacious )?)room,? (?:(?:that|which) (?:is |should be )?)?"
     r"(open|opens|opening) (to|onto|into) the kitchen\b", r"\1 \2living room that is open to the kitchen"),
    # "the rooms are all equal in size"
    (r"(?<!bed )(?<!bath )\b(?:the )?rooms (?:are |should be |must be )?all (?=(?:of )?(?:the same|equal))",
     "all rooms are "),
    # "three children: two of them share, the eldest has her own"
    (r"{parents}\b(?:our |my )?(?P<n>three|four|[34]) (?:{young}|(?P<grown>{grown}))"
     r"(?:[:,;.] ?| - | (?:who|of whom) ?)(?:the )?two (?:of (?:them|us|whom) |of the {young} )?"
     r"(?:little |small |younger |older )?(?:ones? )?(?:{young} )?"
     r"(?:can |will |should )?"
     r"share(?: an?| one| the same| the (?:bigger|larger|big|large|smaller|small))?(?: bed ?room| room| one)?[,;.]? "
     r"?(?:and |but |while )?"
     r"{old} (?:(?:has|have|gets?|needs?|wants?) (?:her|his|"
     r"their|its|an?) own(?: bed ?room| room)?|(?:has|gets|takes) the (?:smaller|bigger|small|big|other|second)(?: "
     r"one| room| bed ?room)|sleeps? alone|is alone|(?P<ours>{with_us}))"
     r"(?:,? (?:and |while |but )?{old} (?P<and_ours>{with_us}))?", _sharing),
    # "two kids, one room for both", "three children in two rooms", "one room for the two children"
    (r"\b(?:two|2|three|3|our|my) {young}(?:, | with |: ?| - )(?P<rooms>one|a|two|1|2) (?:bed ?)?rooms? for "
     r"(?:both|all|the two|all three|them|the three)(?: of them)?\b", _for_both),
    (r"\b(?:two|three|four|[234]) {young} in (?P<rooms>one|two|three|[123]) (?:bed ?)?rooms?\b", _for_both),
    (r"\b(?P<rooms>one|a|1) (?:bed ?)?room for (?:both|the two|our two|my two) {young}\b", _for_both),
    # "a home office each, so two studies", "a study each for my wife and me"
    (r"\ban? {kind} each(?: for [^.,;:]*)?[,;:]? (?:so|that is|that's|i\.? ?e\.?|meaning|which makes|that makes|"
     r"in other words|hence|thus),? (?P<n>two|three|four|five|\d) (?P<rooms>{kind}s|studies|balconies)\b", _summed),
    (r"\ban? ({kind}) each for (?:my [a-z]+ and (?:me|i)|me and my [a-z]+|(?:both|the two) of us)\b",
     lambda found: f"two {re.sub('y$', 'ie', found[1])}s"),
    # "the bathroom faces north, no, south"
    (r"\b(?:{sides})(?:,| -|;|:)? (?:{anew})(?:,? wait)?,? (?:to the |the |nach |au |al )?(?=(?:{sides})\b)", ""),
    # "on reflection the study should be a second bedroom"
    (r"\b{mind},? (?:the|that|this) ({kind}|pantry|storage room|utility room|closet|nursery|guest room) "
     r"(?:should|had|would|could|must|ought to|shall|will)(?: rather| better| preferably| instead)? (?:be|become) "
     r"(?:better )?(?=an? )", r"make the \1 "),
), things=_THINGS, same=_SAME, fixed=_FIXED, whole=_WHOLE, sides=_SIDES, anew=_ANEW, parents=_PARENTS, old=_OLD,
    mind=_MIND, with_us=_WITH_US)  # fmt: skip


def once_more(text: str) -> str:
    """A folded text with such clauses in the words of rooms and furniture."""
    return reworded(text, _SAID)
