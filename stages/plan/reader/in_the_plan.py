"""What people note of a plan, in clauses that the other rules know: loops, pairs of neighbours, ways, limits."""

import re

from apartgen.stages.plan.reader.pieces import ELDER, reworded, rules

_NOTED = {
    "living": "living room",
    "lounge": "living room",
    "bath": "bathroom",
    "hall": "hallway",
    "dining": "dining room",
}
"""Rooms as lists of pairs have them."""
_PLAIN = r"(?:(?:living|dining|bed|bath|guest|utility|laundry|storage) ?(?:rooms?)?|[a-z]+)(?: ?\d)?"
_HALLS = re.compile(r"\b(?:no|without(?: an?| any)?) (?:hall(?:way)?|corridor|passage)s?\b")


def _in_full(name: str) -> str:
    """`bed1` as `bedroom 1`."""
    word, number = re.fullmatch(r"(.*?) ?(\d?)", name.strip()).groups()  # type: ignore[union-attr]
    return f"the {'bedroom' if word == 'bed' else _NOTED.get(word, word)} {number}".rstrip()


def _neighbours(found: re.Match[str]) -> str:
    """`adjacency: kitchen-living, bed1-bath`: each pair lies side by side."""
    pairs = [re.split(r" ?- ?", pair) for pair in re.split(r" ?[,;] ?", found["pairs"])]
    return ". ".join(f"{_in_full(a)} is next to {_in_full(b)}" for a, b in pairs)


def _loop(found: re.Match[str]) -> str:
    """`a loop between kitchen, dining room and living room`: a door from each to the next."""
    a, b, c = (f"the {found[name]}" for name in "abc")
    return (
        f". there is a door between {a} and {b}. there is a door between {b} and {c}. "
        f"there is a door between {c} and {a}"
    )


def _around_bedrooms(found: re.Match[str]) -> str:
    """`the bathroom must be reachable without passing through a bedroom`: from what all share."""
    return f"the {found['of']} is reached from the {'living room' if _HALLS.search(found.string) else 'hallway'}"


_SAID = rules((
    # "layout for assistive robot study": no room
    (r"\b(robot(?:ics)?) stud(?:y|ies)\b(?! room)", r"\1 research"),
    (r"\b(study|office) (?:for|as)(?: an?| my| the| our)? (?:home[ -]office|home working|working from home)\b", r"\1"),
    # "a loop between kitchen, dining room and living room"
    (r"(?:[,;]? ?\band )?\b(?:there(?: is|'s) |i want |we want |make |with )?(?:an? |the "
     r")?(?:loop|circuit|ring|circular "
     r"(?:route|walk|path))(?: of doors)? (?:between|through|from|of|around|connecting|linking) (?:the "
     r")?(?P<a>{room}),? "
     r"(?:to |and )?(?:the )?(?P<b>{room}),? (?:and|to|then)(?: back to)? (?:the )?(?P<c>{room})", _loop),
    # "adjacency: kitchen-living, bed1-bath"
    (r"\badjacen(?:cy|cies)(?: list| pairs| requirements)? ?: ?(?P<pairs>{plain} ?- ?{plain}(?: ?[,;] ?{plain} ?- "
     r"?{plain})*)"
     r"(?= ?(?:\.|$))", _neighbours),
    # "bathroom must be reachable without passing through a bedroom"
    (r"(?:\bthe )?\b(?P<of>(?:main |guest )?(?:bath ?room|toilet|kitchen|living room|study)) (?:{must} )?(?:be |is )?"
     r"(?:reachable|accessible|reached|accessed|entered) without (?:passing|going|walking|crossing|having to \w+)"
     r"(?: through| via)? (?:an?|any|the|another) bed ?rooms?\b", _around_bedrooms),
    # "one bathroom between the two bedrooms with a door from each (jack and jill)"
    (r"\b(?:one|an?|the|shared) (?:shared )?bath ?room between (?:the |both )?(?:two |2 )?bed ?rooms,? "
     r"(?:with|and) (?:an? |one )?"
     r"doors? (?:from|to|into|in) (?:each|both)(?: of them| bed ?rooms?| one)?(?: \(?,? ?(?:an? )?jack[ "
     r"-](?:and|&)[ -]jill\)?)?,? ?(?:and |plus )?",
     "a jack and jill bathroom between the two bedrooms. "),
    # "kitchen with an island, living room with a sofa, connected by a wide opening"
    (r"(?P<said>\b(?P<a>kitchen|living room|dining room|lounge|study|hallway)\b[^.;:]*?[,;] (?:and )?(?:an? |the )?"
     r"(?P<b>kitchen|living room|dining room|lounge|study|hallway)\b[^.;:]*?),? (?:both |which are |the two )?"
     r"(?:connected|joined|linked) (?:by|through|via|with) an? (?:wide |large |broad |big "
     r")?(?:opening|archway|arch){end}",
     r"\g<said>. the \g<a> is open to the \g<b>"),
    (r"\bsingle (bed ?room)(?= (?:with|has|having|and)\b[^.;,]*\b(?:double|king|queen)(?:[ -]size)? bed)", r"one \1"),
    # "knock the kitchen through to the living room"
    (r"\bknock(?:ing)? (?:through )?(?:the )?(?P<a>{room}) (?:through )?(?:in)?to (?:the )?(?P<b>{room})",
     r"the \g<a> is open to the \g<b>"),
    (r"\bknock(?:ing)? (?:through|down|out) the wall between (?:the )?(?P<a>{room}) and (?:the )?(?P<b>{room})",
     r"the \g<a> is open to the \g<b>"),
    (r"\b(not be|n't be|not) opened to (?=(?:the )?{room})", r"\1 open to "),
    # "Bedroom is after living room", "the balcony must to be in the side of kitchen"
    (r"\b(?:the )?(?P<of>{room}) (?:is|comes|lies) (?:right |directly )?(?:after|past|beyond) (?:the "
     r")?(?P<by>{room})\b",
     r"the \g<of> is reached through the \g<by>"),
    (r"\b(must|should|can) to (?=be\b|have\b)", r"\1 "),
    (r"\b(?:in|on|at) the side of (?:the )?(?={room})", "next to the "),
    (r"\b(balcony|terrace|loggia) (?:must |should )?(?:be|is) next to the (kitchen|living room|bed ?room)\b",
     r"\1 is off the \2"),
    # "Three bedrooms, the one of parents is the most big"
    (r"\bthe one (?:of|for) (?:the |my |our )?(?P<who>parents|guests|children|kids),? (?P<be>is|must be|should "
     r"be) (?:the )?"
     r"(?:most |very )?(?P<big>big|larg|small)(?:e|g?est)?(?: one)?{end}",
     lambda found: f"the {found['who']}' bedroom is the {'small' if found['big'] == 'small' else 'larg'}est bedroom"),
    # "My grandmother she live with us so she need a room near to bathroom"
    (r"\b(?P<my>my|our) (?P<who>{elder}) (?:she |he )?lives? with us,? (?:so|and) (?:she|he) (?:will "
     r")?(?:needs?|wants?|must have|"
     r"should have) (?:an? |her |his )?(?:own )?(?:bed ?)?room (?P<where>(?:near|next|close|beside)[^.;,]*)",
     r"\g<my> \g<who> lives with us. the \g<who>'s bedroom is \g<where>"),
    # "Flat has not corridor. You enter direct in the living room. Two doors: one for bedroom and one for bathroom"
    (r"\b(?:has|have) not (?:an? |any )?(?={room}s?\b|entrance hall\b)", "has no "),
    (r"\b(?:you|we|one|i) enter (?:direct|directly) in(?:to)? "
     r"(?:the )?"
     r"(?P<to>living room|lounge|kitchen)\b", r"the entrance is in the \g<to>"),
    (r"\b(living room|lounge) with (?:the |an? )?kitchen (?:inside|in it|within)\b", r"\1 with an open kitchen"),
    (r"(?:(?<=[.;] )|^)two doors ?[:,] ?one (?:for|to|into|in) (?:the |an? )?(?P<a>{room}),? (?:and )?"
     r"(?:one|the other|another) (?:for|to|into|in) (?:the |an? )?(?P<b>{room}){end}",
     r"the living room has a door to the \g<a> and a door to the \g<b>"),
    # "One bedroom with big wardrobe and place for washing machine": it is not the bedroom's
    (r"(\bbed ?rooms?\b[^.;]*?),? and (?:an? |some )?(?:place|space|room) for (?:the |an? |our )?washing[ -]?machine\b",
     r"\1. a washing machine"),
    # "2 bathrooms; max area 80"
    (r"(^|[;,.] ?)max(?:imum|imal)?\.? (?:total |floor |overall )?(?:area|size|surface)(?: is| of| ?[:=])? ?(\d{2,3})"
     r"(?: ?(?:m2|sqm|{unit}))?{end}", r"\1at most \2 m2 in total"),
), elder=ELDER, plain=_PLAIN)  # fmt: skip


def in_the_plan(text: str) -> str:
    """A folded text with such clauses in other words."""
    return reworded(text, _SAID)
