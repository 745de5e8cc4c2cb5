"""What people say of a home in passing: where they come in and come from, whose each of two is, corners and sizes."""

import re

from apartgen.stages.plan.reader.languages import language
from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import HALL, reworded, rules

_HALL = late(rf"\b{HALL}\b|\bflur|\bdiele\b|\bcouloir|\bentree\b|\bpasillo|\brecibidor|\bvestibul|走廊|玄关")
_MANY = late(r"\b(?:three|four|five|six|[3-9])[ -]?(?:bed ?rooms?\b|br\b)")
_OF_ALL = ("family", "everyone", "everybody", "kids", "children", "all")
_GUESTS = ("guest", "guests", "visitors")
_WHO = r"(?:the |our |my |all )?(?P<{}>family|everyone|everybody|kids|children|guests?|visitors)"
_WITH = r"(?:with (?:only |just )?[^.,;:]*? )?"
_LIVED = r"(?:living room|lounge|main room|kitchen|living[ -]dining room|sitting room)"


def _straight_in(found: re.Match[str]) -> str:
    """`you enter directly into the living room` of a small home for which no hall is named: there is none."""
    return found.group() if hall_or_studio(found.string) else f"no hallway, {found.group()}"


def hall_or_studio(text: str) -> bool:
    """Whether a home has a hall, which is named or wanted for many rooms, or no room but one, which is entered."""
    return bool(_HALL.search(text) or _MANY.search(text)) or "studio" in text


def _bath(who: str, having: str) -> str:
    return f"a {'guest' if who in _GUESTS else 'family'} bathroom {having}"


def _whose_baths(found: re.Match[str]) -> str:
    """`two bathrooms, one with a tub for the family and one for guests` as a family and a guest bathroom."""
    one, other = found["who"], found["other"]
    if (one in _GUESTS) == (other in _GUESTS):
        return found.group()
    return f"{_bath(one, found['a'])}and {_bath(other, found['b'])}".rstrip()


def _single(rooms: str) -> str:
    return "balcony" if rooms == "balconies" else rooms.removesuffix("s")


def _one_each(found: re.Match[str]) -> str:
    """`two balconies, one for the kitchen and one for the bedroom` as those of the rooms."""
    single = _single(found["of"])
    return f"a {single} off the {found['a']} and a {single} off the {found['b']}"


def _kids_rooms(found: re.Match[str]) -> str:
    """`12 for each of the two kids` as that many rooms of that size."""
    return f"{found['n']} kids rooms of {found['size']} m2 each"


def _sized_kids(found: re.Match[str]) -> str:
    """`kids 11 + 11` of a list of sizes as the rooms of children."""
    room = {"parents": "parents' bedroom", "kids": "kids room", "kid": "kids room", "child": "kids room",
            "children": "kids room", "guest": "guest room", "guests": "guest room"}[found["who"]]  # fmt: skip
    sizes = re.findall(r"\d+(?:[.,]\d+)?", found["sizes"])
    if len(sizes) == 1:
        return f"{found['begin']}{room} {sizes[0]}"
    return f"{found['begin']}{len(sizes)} {room}s of {', '.join(sizes[:-1])} and {sizes[-1]} m2"


def _her_rooms(found: re.Match[str]) -> str:
    """Her bedroom with an own bath, of which the rest is said, too."""
    more = f". the relative's bedroom is {found['more'].strip(', ')}" if found["more"] else ""
    return f"a relative's bedroom with its own {found['bath']}{more}"


_FALSE_FRIENDS = {"gang": "gangsters", "herd": "herds"}


def _in_english(found: re.Match[str]) -> str:
    """English words that name rooms and furniture in other languages: `a gang of four`."""
    return _FALSE_FRIENDS[found.group()] if language(found.string) == "en" else found.group()


_ENGLISH = rules((
    # "my knees are bad", "brightly lit"
    (r"\b(is|are|was|were|so|very|too|not|really|feels?|looks?|smells?) bad\b", r"\1"),
    (r"\bbad (?=(?:smells?|knees?|backs?|legs?|hips?|light|noise|weather|neighbou?rs?|idea|eyes|views?)\b)", ""),
    (r"\b(?:gang|herd)\b", _in_english), (r"\b(?:well|bright|brightly|naturally)[ -]lit\b", "bright"),
    (r"\b(?:dimly|poorly|badly|softly)[ -]lit\b", "dark"),
))
_SAID = rules((
    # "un taller"
    (r"\b(un|el|y|con|de) taller\b", r"\1 sala de trabajo"),
    # "we just sold our big house", "we used to live in a villa": homes that are none any more
    (r"\b(?:just |have |had |recently |already )*(?:sold|sell|selling|left|leaving|gave up|moved out of|lived in|"
     r"used to live in|used to have|come from) (?:our|my|an?|the|their) (?:[a-z]+ ){0,2}(?:house|home|flat|apartment|"
     r"villa|bungalow|cottage)\b", "moved"),
    # "we don't mind sharing the bathroom"
    (r"\b(?:(?:we|i|they|you) )?(?:do not|don't|would not|wouldn't|does not|doesn't) mind (?:sharing|to share|having|"
     r"if we share|if they share) ", "shared: "),
    # "a home office corner in the living room"
    (r"\b(?:an? |the |one |small )*(?:home office|office|work|working|desk|study|computer|homework) (?:corner|nook|"
     r"area|space|spot|place) (?:in|inside|within) (?P<of>(?:the |my |our |each |every )?{kind})", r"a desk in \g<of>"),
    # "she should have her bedroom and her own shower room away from the living room"
    (r"\b(?:she|he) (?:(?:should|must|will) have|{has}) (?:her|his|an?) (?:own )?bed ?room and (?:her|his|an?) own "
     r"(?P<bath>shower room|bath ?room)(?P<more>,? (?:both )?(?:far )?(?:away )?from [^.;,]*)?", _her_rooms),
    # "I'm a piano teacher", "and the rest for bathroom and hall"
    (r"\b(?:piano|guitar|violin) (?=(?:teacher|player|student|lesson)s?\b)", ""),
    (r"[,;]? ?(?:and )?the (?:rest|remainder|remaining (?:area|space)) (?:is |goes |left |should be )?(?:for|to) "
     r"(?=[a-z])", ". "),
    # "12 for each of the two kids", "kids 11 + 11" beside other rooms with sizes
    (r"\b(?P<size>\d{1,2}(?:[.,]\d)?) ?(?:{unit} )?for each of (?:the|our|my) (?P<n>{several}) "
     r"(?:kids|children)\b(?!')", _kids_rooms),
    (r"(?P<begin>[a-z] ?\d{1,2}(?:[.,]\d)?(?: ?{unit})?[,;] ?(?:and )?)(?P<who>parents|kids?|child|children|guests?)"
     r"(?::| -)? (?P<sizes>\d{1,2}(?:[.,]\d)?(?: ?(?:[+&/,]|and) ?\d{1,2}(?:[.,]\d)?)*)(?! ?[a-z(]){end}", _sized_kids),
    # "bath is inside bedroom"
    (r"\b(?:the )?(?:bath|bathroom) (?:is|must be|should be|goes|will be) inside (?:of )?(?:the )?"
     r"(?P<of>(?:main |master |parents' )?bed ?room)\b", r"the \g<of> has an ensuite bathroom"),
    # "les toilettes soient près de l'entrée": one toilet; "neben Omas Zimmer"; "un salon qui donne sur la terrasse"
    (r"\b(?P<the>les|des) toilettes\b(?! (?:a part|separees?|independantes|a cote|pour|et|sont separe))",
     lambda found: "le wc" if found["the"] == "les" else "un wc"),
    (r"\b(?:oma|opa|grossmutter)s (?:schlaf)?zimmer\b", "grandma's room"),
    (r"\b(?P<a>une? (?:\w+ )?{fr}) et (?P<b>une? (?:\w+ )?(?P<of>{fr})) qui "
     r"(?=(?:donne|ouvre|s'ouvre|communique|mene) )", r"\g<a>, \g<b>. le \g<of> "),
    # "you enter the flat directly into the living room", "the front door opens into it", "the entrance is in it"
    (r"\b(?:you|one|we|i|people) (?:can |should |will )?(?:enters?|comes?|walks?|steps?|arrives?)(?: in)?{home}? "
     r"(?:directly |straight |right |immediately )(?:in|into|in to|to) the {lived}\b", _straight_in),
    (r"\b(?:you|one|we|i|people) (?:can |should |will )?enters?{home} (?:in|into|through|via) the {lived}\b",
     _straight_in),
    (r"\bthe (?:front door|entrance|entrance door) (?:should |must |to )?(?:opens?|leads?|goes|be|is) "
     r"(?:directly |straight |right )?(?:into|onto|in|to) the {lived}\b", _straight_in),
    # "two bathrooms: one with a bathtub for the family and one with only a shower for the guests"
    (rf"\b(?:two|2) (?:bath ?rooms|baths)(?:[,:;] ?| - ?)(?:one|the first) (?P<a>{_WITH})for {_WHO.format('who')}"
     rf"(?:,|,? and|,? the other|;)+ (?:one|another|the other|the second)? ?(?P<b>{_WITH})for {_WHO.format('other')}\b",
     _whose_baths),
    # "two balconies, one for the kitchen and one for the bedroom", "two closets, one for each bedroom"
    (r"\b(?:two|2) (?P<of>balconies|terraces|patios)(?:[,:;] ?| - ?)(?:one|the first) {at} the (?P<a>{kind})"
     r"(?:,|,? and|;)+ (?:one|another|the other|the second) {at} the (?P<b>{kind})", _one_each),
    (r"\b{several} (?P<of>balconies|(?:walk-in |walk in )?closets|dressing rooms|en[ -]?suites)(?:[,:;] ?| - ?)?"
     r"(?:one|1) (?:for|in|off|per|at) (?:each|every) (?:of the )?bed ?rooms?\b",
     lambda found: f"each bedroom has a {_single(found['of'])}"),
    # "every room opens off the hall, only the bathroom is accessible from the bedroom"
    (r"(\b(?:every|each|all)(?: the| other)? rooms? [^.;,]*?),? (?:and |but )?only the (?P<of>{kind}) "
     r"(?:is |are |can be )?(?:accessible|reached|entered|opens|reachable) (?P<by>from|off|through|via) (?=the {kind})",
     r"\1 except the \g<of>, which is accessible from "),
    (r"(\balle (?:anderen )?(?:zimmer|raume)\b[^.;,]*?),? (?:und |aber )?nur (?:das|der|die) (?P<of>{de}) ist "
     r"(?:vom|von der|von dem|durch das|durch die|uber das) (?P<by>{de})(?: aus)? (?:zuganglich|erreichbar)\b",
     r"\1 except the \g<of>, which is accessible from the \g<by>"),
    # "a wine cellar next to the kitchen": there is no cellar, and nothing beside the kitchen
    (r"(\b(?:wine )?cellar) (?:next to|near|beside|off|under|below|close to) (?:the )?(?P<of>{kind}){end}",
     r"\1, a \g<of>"),
    # "les toilettes sont séparées de la salle de bain", "el aseo está separado del baño"
    (r"\b(?:les |des )?(?:toilettes|wc) (?:sont|est|soient|doi(?:ven)?t etre) separee?s? de la salle de bains?\b"
     r"(?:,? et )?", "un wc separe et une salle de bain. "),
    (r"\b(?:el |un )?(?:aseo|wc|inodoro) (?:esta|estara|debe estar|este) separado del bano\b(?:,? y )?",
     "un aseo y un bano. "),
    (r"\b(?:das |ein |die |eine )?(?:wc|klo|toilette) (?:ist|soll|muss)(?: sein)? vom bad(?:ezimmer)? "
     r"getrennt(?: sein)?\b(?:,? und )?", "ein separates wc und ein bad. "),
), lived=_LIVED, home=r"(?: the (?:flat|apartment|home|house|unit))",
   at="(?:for|at|on|in|by)")  # fmt: skip


def at_home(text: str) -> str:
    """A folded text with such clauses in the words of rooms."""
    return reworded(text, _SAID)


def without_false_friends(text: str) -> str:
    """A folded text, before anything else, without English words that other languages have for rooms and things."""
    return reworded(text, _ENGLISH)
