"""Doors told of rooms together: those around one, a chain of them, what neither of two may have, two ways into one."""

import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import KIND, reworded, rules

_NAMED = (rf"(?:(?:the|my|our|an?|one|his|her|their) )?(?:[a-z]+(?:'s|s') )?"
          rf"(?:{KIND}(?: \d)?|bed ?room \d|room)\b")  # fmt: skip
_FOUND = late(_NAMED)
_STEP = r"(?:(?:the |an? |our |my )?(?:entrance(?: hall)?|front door|{kind}))"
_EACH = (r"(?:(?:each|all|every one)(?: of them)?,? (?:(?:with|having|has|have) (?:(?:an?|its|their|one|own|separate|"
         r"direct) )+(?:doors?|access|opening) (?:on ?to|in ?to|to|from|off) it|(?:opening|opens?|leading|accessible|"
         r"reached|entered) (?:(?:directly|straight) )?(?:in ?to|on ?to|to|from|off) it))")  # fmt: skip
_THERE = r"(?:from it|from there|from that)"
_TO = (r",? (?:there (?:is|'s|should be) )?(?:(?:an?|one|another|the next) "
       r"(?:door )?)?(?:(?:leads?|goes|opens?|on) )*(?:in|on)?to (?:the |an? )?(?:{kind})")  # fmt: skip
_STEPS = late(rf"to (?:the |an? )?({KIND})(?=,|\.|;|$| and )")
_PARTS = re.compile(r"[;:] ?|,? (?=with\b)|, ?")
_WAY = (r"(?:one|another|an?|the other|the second)(?: way| door)?(?: in)? (?:from|off|through|via|by) "
        r"(?P<{}>(?:the|its|my|our)(?: own)? {{kind}})")  # fmt: skip

_SIDE = r"(?:once )?(?:from|off|through|via) (?P<{}>(?:the|my|our) {{kind}})"


def _known(room: str) -> str:
    """`a bedroom` as one that was named."""
    return "the " + re.sub(r"^(?:the|an?|one|our|my|its(?: own)?) ", "", room)


def _doors(rooms: list[str]) -> str:
    """A door from each to the next."""
    return ". ".join(f"there is a door between {a} and {b}" for a, b in zip(rooms, rooms[1:], strict=False))


def _ring(found: re.Match[str]) -> str:
    """`a lounge in the middle and around it, each with a door to it, a kitchen and two bedrooms`: doors of the one."""
    before, listed = re.sub(r",? and$", "", found["before"].rstrip(" ,")), found["listed"]
    if not listed:
        parts = _PARTS.split(before, maxsplit=1)
        before, listed = parts[0], re.sub(r"^with ", "", parts[1]) if len(parts) > 1 else ""
    hub = next(_FOUND.finditer(before), None)
    if hub is None or not listed:
        return found.group()
    return f"{before}. {_doors_to(hub.group(), listed)}"


def _doors_to(hub: str, listed: str) -> str:
    """One list of rooms, none of which is told apart by its article."""
    rooms = listed.strip(" ,")
    rooms = re.sub(r"(, |and )an? ", r"\1the ", rooms) if rooms.startswith("the ") else rooms
    return f"{_known(hub)} has doors to {rooms}"


def _chain(found: re.Match[str]) -> str:
    """`entrance, then lounge, then kitchen`: a door from each to the next."""
    named = re.split(r"(?:,| and|, and)? then (?:the |an? )?", found["rooms"])
    rooms = [_known(re.sub(r"\b(?:entrance|front door)$", "entrance hall", room)) for room in named]
    return f". {_doors(rooms)}{'. ' if found['end'] else ''}"


def _from_there(found: re.Match[str]) -> str:
    """`the start is the bath. from it a door to the bedroom, from there one to the study`: one after another."""
    before = [m.group() for m in _FOUND.finditer(found.string[: found.start()])]
    rooms = [m[1] for m in _STEPS.finditer(found.group())]
    return _doors([_known(room) for room in [*before[-1:], *rooms]]) if before else found.group()


def _neither(found: re.Match[str]) -> str:
    """`A must be next to B, and neither may open into C`."""
    a, b = found["a"], found["b"]
    return f"{a}{found['said']}{b}. neither {_known(a)} nor {_known(b)} {found['rest']}"


def _between_them(found: re.Match[str]) -> str:
    """`bedrooms 2 and 3 share a bathroom between them`: it lies beside both."""
    who = found["both"] or f"bedroom {found['n']} and bedroom {found['m']}"
    kind = "bathroom" if found["kind"] == "bath" else found["kind"]
    return f"{who} share a {kind} which is next to {who}{'. ' if found['goes_on'] else ''}"


def _ways(found: re.Match[str]) -> str:
    """`two ways into the kitchen, one from A and one through B, which also opens to C`."""
    also = f". {_known(found['b'])} also opens to {found['also']}" if found["also"] else ""
    doors = f"{_known(found['to'])} has a door to {_known(found['a'])} and a door to {_known(found['b'])}"
    return f". {doors}{also}"


def _ways_in(found: re.Match[str]) -> str:
    """`a bedroom with two ways in: one from A and one through B`."""
    return f"{found['to']}{_ways(found)}"


_SAID = rules((
    # "a lounge in the middle, and around it, each with a door to it, a kitchen, a study and two bedrooms"
    (r"(?P<before>[^.]*?\b{named}[^.]*?)[,;]? (?:(?:and|is|are|all|arranged|grouped|set|placed|clustered|lie) )*"
     r"around it,? {each}(?:[,:] (?P<listed>[^.;]+))?", _ring),
    (r"(?P<of>(?:^|(?<=[.;:] ))[^.;:]*?) surround(?:ing)? (?P<hub>(?:the|an?) {kind}(?: in the (?:middle|centre|"
     r"center))?),? "
     r"{each}", lambda found: _doors_to(found["hub"], found["of"])),
    # "from it a door to the bedroom, from there one to the study", "only from the study can you reach the lounge"
    (r"\b(?:{there}|from the {kind}){to}(?:[,;]? ?(?:and )?{there}{to})+", _from_there),
    (r"(?:\band )?\bonly (?:from|through|via|by) (?P<by>the {kind}),? (?:can|do|should|may) (?:you|we|one|i|people) "
     r"(?:reach|enter|access|get (?:in)?to|go (?:in)?to|come (?:in)?to) (?P<of>the {kind})",
     r"\g<of> is reached only from \g<by>"),
    # "entrance, then lounge, then kitchen in one straight chain", "the bath as a dead end off the bedroom"
    (r"(?:\b(?:the )?(?:level|layout|plan|flat|house|home|route|rooms?|sequence|order|path)(?: should| must)? "
     r"(?:flows?|goe?s?|runs?|leads?|reads?|form an? (?:chain|row|line)|is|are)(?: from| like this)?:? )?"
     r"(?P<rooms>{step}(?:(?:,| and|, and)? then {step}){2,})"
     r"(?P<end>,? (?:all )?in (?:one |an? )?(?:straight |single |long )?(?:chain|row|line|sequence)(?:,? with)?)?",
     _chain),
    (r"\b(?P<of>{kind}) (?:as|is|being) an? dead[ -]end (?:off|from|behind|beyond) (?P<by>the {kind})",
     r"\g<of> is reached only from \g<by>"),
    # "the bathroom must be en suite to the larger bedroom only"
    (r"\b(?P<of>the bath ?room) (?:(?:{must}|is|be) )*(?:an? )?en[ -]?suite (?:to|with|of|off|in) "
     r"(?P<by>the (?:[a-z]+ )?bed ?room),? (?:only|alone|exclusively)\b", r"\g<of> is reached only from \g<by>"),
    # "A must be next to B, and neither may open into C", "neither A nor B has a door to C"
    (r"(?P<a>\b{named})(?P<said> (?:(?:{must}|is|are|be|lies?|right|directly) )*(?:next to|beside|near|adjacent to|"
     r"close to|adjoining) )(?P<b>{named}),? (?:and|but) neither(?: of (?:them|the two)| one| room)? "
     r"(?P<rest>(?:{must}|is|has|have|opens?|leads?) )", _neither),
    (r"\bneither (?P<a>{named}) nor (?P<b>{named}) (?:(?:{must}|have|has|get|gets) )*an? (?:direct )?door (?:in)?to "
     r"(?P<c>{named})", r"no door between \g<a> and \g<c>. no door between \g<b> and \g<c>"),
    (r"\bneither (?P<a>{named}) nor (?P<b>{named}) (?:{must} |is |are )(?:be |lie )?(?P<by>next to|beside|near|"
     r"adjacent to|close to|adjoining|opposite) (?P<c>{named})",
     r"\g<a> must not be \g<by> \g<c>. \g<b> must not be \g<by> \g<c>"),
    (r"\bweder (?P<a>(?:der|die|das) {de}) noch (?P<b>(?:der|die|das) {de}) (?:(?:darf|durfen|soll|sollen|hat|haben) )"
     r"(?:eine )?(?:direkte )?tur (?:zum|zur|ins|in d(?:as|ie|en)) (?P<c>{de})(?: haben| bekommen)?",
     r"keine tur zwischen \g<a> und \g<c>. keine tur zwischen \g<b> und \g<c>"),
    (r"\bni (?P<a>(?:el|la) {es}) ni (?P<b>(?:el|la) {es}) (?:(?:deben?|pueden?) )?(?:(?:se )?(?:dan?|dar|abren?|"
     r"comunican?)|(?:tienen?|tener) (?:una )?puerta) (?:al?|con) (?:el |la )?(?P<c>{es})",
     r"sin puerta entre \g<a> y \g<c>. sin puerta entre \g<b> y \g<c>"),
    (r"\bni (?P<a>(?:le |la |l'){fr}) ni (?P<b>(?:le |la |l'){fr}) ne (?:(?:doi(?:ven)?t|peu(?:ven)?t) )?(?:donner|"
     r"donnent|"
     r"s'ouvrent|s'ouvrir|avoir de porte|communiquent) (?:sur|avec|vers) (?P<c>(?:le |la |l'){fr})",
     r"pas de porte entre \g<a> et \g<c>. pas de porte entre \g<b> et \g<c>"),
    # "bedrooms 2 and 3 share a bathroom between them"
    (r"\b(?:bed ?rooms? (?P<n>\d) and (?:bed ?room )?(?P<m>\d)|(?P<both>the two [a-z' ]{0,20}(?:bed ?)?rooms)) "
     r"(?:(?:must|should|will|can) )?share (?:an?|one)(?: single| common)? "
     r"(?P<kind>bath ?room|bath|shower room|toilet|balcony) between (?:them|the two)\b(?! [^.]*\bshare )"
     r"(?!,[^.]*\bshare )(?P<goes_on>, )?", _between_them),
    # "two ways into the kitchen: one from the hall and one through the pantry, which also opens to the garden"
    (r"(?:,? (?:with|has|and)|\bthere are|(?<=[.;:]))? ?\btwo (?:ways|doors|entrances) (?:in)?to (?P<to>(?:the|my|our) "
     r"{kind})[,:]? {way_a},? and {way_b}(?:,? which (?:also )?opens (?:in|on)?to (?P<also>the {kind}))?", _ways),
    (r"\b(?P<to>the {kind}) (?:{must} )?(?:be |is )?(?:entered|reached|accessed|accessible|reachable) (?:from two "
     r"sides|"
     r"(?:in )?two ways)[,:]? {side_a},? and {side_b}(?P<also>)", _ways),
    (r"\b(?:you|we|one|i) (?:{must} )?(?:get|come|go|walk) (?:in)?to (?P<to>the {kind}) (?:from two sides|(?:in "
     r")?two ways)"
     r"[,:]? {side_a},? and {side_b}(?P<also>)", _ways),
    (r"(?P<to>(?:an? |one |the ){kind}) (?:with|has|having) two (?:ways|doors)(?: in)?[,:]? {way_a},? and {way_b}"
     r"(?:,? which (?:also )?opens (?:in|on)?to (?P<also>the {kind}))?", _ways_in),
), named=_NAMED, each=_EACH, there=_THERE, to=_TO.replace("{kind}", KIND), step=_STEP.replace("{kind}", KIND),
   side_a=_SIDE.format("a").replace("{kind}", KIND), side_b=_SIDE.format("b").replace("{kind}", KIND),
   way_a=_WAY.format("a").replace("{kind}", KIND), way_b=_WAY.format("b").replace("{kind}", KIND))  # fmt: skip


def round_it(text: str) -> str:
    """A folded text with the doors of such rooms one by one."""
    return reworded(text, _SAID)
