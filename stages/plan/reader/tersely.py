"""What is asked for in few words, or in words that rules of other clauses would take for rooms of their own."""

import re

from apartgen.stages.plan.reader.pieces import reworded, rules


def _each_wants(found: re.Match[str]) -> str:
    """`three students … we each want a bedroom of 12 m²`: so many bedrooms of that size."""
    size = f" of {found['size']} each" if found["size"] else ""
    return f"{found['before']}{found['n']} bedrooms{size}"


def _through(found: re.Match[str]) -> str:
    """`find hallways a waste of space`, `come straight into the living room and have A, B and C open off it`."""
    return f"no hallway. the entrance leads into {found['one']}. {found['rooms']} open off {found['one']}"


def _facing(found: re.Match[str]) -> str:
    """`bedroom windows (both) east`: both bedrooms face east."""
    several = f"{found['all']} {found['a'].removesuffix('s')}s"
    return f"{several if found['all'] else found['a']} facing {found['side']}"


def _windows(found: re.Match[str]) -> str:
    """`window_facing: {bedroom: east, living_room: south}`."""
    pairs = re.findall(r"([a-z][a-z ]*?(?: \d)?) ?: ?(north|south|east|west)", found["pairs"])
    return "; ".join(f"{room} faces {side}" for room, side in pairs) or found.group()


def _without(found: re.Match[str]) -> str:
    """`exclude: [hallway, balcony]`: neither."""
    names = [name.strip('" ') for name in found["names"].split(",")]
    return f"{found['begin']}" + ", ".join(f"no {name}" for name in names if name) + ". "


_SAID = rules((
    # "exclude: [hallway, balcony]", brackets being folded
    (r"(?P<begin>^|[.;,\n(] ?)\"?(?:excluded?|exclusions?|without|omit|forbidden)(?:[ _]rooms?)?\"? ?: ?"
     r"\((?P<names>[^()]*)\) ?[.;,\n]? ?", _without),
    # "three bedrooms. Main bedroom in the north"
    (r"(?<=[.;\n] )(?P<main>(?:main|master|primary|principal|largest|biggest) bed ?room)(?= (?:in|on|at|to|facing|"
     r"faces|north|south|east|west|near|next to|left|right)\b)", r"the \g<main>"),
    # "the study has doorway to the kitchen", "the kitchen has an entrance from the hall", "immediately adjacent to"
    (r"\b(?P<has>has|have|with) (?:an? )?(?:its )?(?:own |separate )?(?:doorway|entrance|entry|passage) "
     r"(?:to|from|into|onto|towards) (?=(?:the |an? )?{one}\b)", r"\g<has> a door to "),
    (r"\bimmediately (?=(?:adjacent|next|beside|adjoining|opposite|behind)\b)", ""),
    # "unit-test scene", "layout: a bedroom and a kitchen, nothing else"
    (r"\bunit[ -]tests?\b", "test"),
    (r"^(?:[a-z]+ ){0,2}(?:layouts?|floor ?plans?|plans?|maps?|levels?)(?: with| of)? ?: ?"
     r"(?=[^:]*\b(?:nothing else|nothing more|no other rooms?)\b)", ""),
    # "two rooms for an experiment: a bedroom and a study"
    (r"^(?:(?:just|only|i (?:only |just )?(?:want|need)) )?two rooms(?: for [^:.;]*)?: "
     r"(?P<rooms>(?:an? )?{one} and (?:an? )?{one}\b[^.;]*)", r"\g<rooms>, nothing else"),
    # "study apart from kitchen"
    (r"\b(?P<a>(?:the |a )?{one}),? (?:is |lies |set |placed |must be |should be )?apart from "
     r"(?P<b>(?:the |a )?{one})\b", r"\g<a> away from \g<b>"),
    (r"\bwindows? ?(?:facing|sides?|orientation) ?:? ?\{(?P<pairs>[^{}]*)\}", _windows),
    # "kitchen = 2x bathroom", "living = biggest room"
    (r"\b(?P<a>{one}) ?: ?(?P<n>\d+(?:\.\d+)?) ?x (?P<b>{one})(?= ?(?:[,.;\n(]|$))", r"\g<a> is \g<n> times as "
     r"large as \g<b>"),
    (r"\b(?P<a>{one}) ?: ?(?:the )?(?P<most>biggest|largest|smallest)(?: room)?(?= ?(?:[,.;\n]|$))", r"\g<a> is "
     r"the \g<most> room"),
    # "no door kitchen<->hall"
    (r"\bno door:? (?P<a>{one}) ?(?:<-+>|<->|->|-|/|to) ?(?P<b>{one})\b", r"no door between \g<a> and \g<b>"),
    # "storage shares a wall with the kitchen but no door between them"
    (r"\b(?P<a>(?:the )?{one}(?: \d)?) (?:{must} )?(?:shares?|sharing) an? (?:common )?wall (?:w/ ?|with "
     r")(?P<b>(?:the )?{one}(?: \d)?),? (?:but |and |with )?(?:there is )?no door between (?:them|those two|the "
     r"two|these)",
     r"\g<a> is next to \g<b>. no door between \g<a> and \g<b>"),
    # "I don't want that the bathroom has a common wall with the kitchen", "we would hate to have a door from A to B"
    (r"\bi (?:do not|don't) want (?:that )?(?P<a>(?:the )?{one}) (?:has|have|shares?|to (?:have|share)) "
     r"(?:an? )?(?:common )?wall with "
     r"(?P<b>(?:the )?{one})", r"\g<a> must not be next to \g<b>"),
    (r"\b(?:i|we)(?: would|'d)? (?:hate|dislike|not like)(?: to have| having)? (?:a|any) door (?:straight |"
     r"directly )?(?:from|between) "
     r"(?P<a>(?:the )?{one}) (?:to|into|and) (?P<b>(?:the )?{one})", r"no door between \g<a> and \g<b>"),
    # "the study must be apart from both bedrooms"
    (r"\b({must}|{must} be kept) (?:be )?apart from (?=(?:the|both|all|every|my|our) )", r"\1 not be next to "),
    # "opens off bedroom 1 rather than off the living room"
    (r"\b(?P<of>(?:balcony|terrace|patio)(?: that| which)?(?: {must})?) (?P<verb>opens?(?: off| onto| to)|is off|"
     r"be off) (?P<a>(?:the )?{one}(?: \d)?),? (?:rather than|instead of|and not|not)(?: off| onto| to| from)? "
     r"(?:the )?living room", r"\g<of> \g<verb> \g<a>"),
    # "my bedroom is also my office", "the one bedroom should also serve as my study"
    (r"\b(?:my|the|our)(?: one| only| single)? bed ?room (?:is|{must}) (?:also|too) "
     r"(?:be |serve as |double as |work as )?(?:my|our|the|an?) (?P<use>office|study|workplace|work ?room|home "
     r"office)\b",
     "the bedroom also serves as a study"),
    # "only this one bedroom", "in bedroom I want", "one bedroom is enough"
    (r"\b(?:i|we) (?:only )?need only (?:this|that) one bed ?room\b", "one-bedroom flat"),
    (r"\b(?:and |but )?in (?=(?:bedroom|kitchen|bathroom|living room) (?:i|we) (?:want|need|would "
     r"like)\b)", r"in the "),
    # "a bedroom with minimum 15 m2 and a bathroom with maximum 6 m2"
    (r"\b(?P<a>an? {one}) with (?:an? )?(?P<limit>minimum|maximum|min|max|at least|at most)(?: of)? "
     r"(?P<n>\d+(?:\.\d+)? ?m2)",
     r"\g<a> of \g<limit> \g<n>"),
    # "it takes place in the kitchen, so it should measure 4 x 5 m", "a living room in which a dining table stands"
    (r"\bin (?P<room>the {one}),? so it (?={must} (?:be|have|measure))", r"in \g<room>. \g<room> "),
    (r"\b(?P<room>(?:an?|the) {one}) in which (?P<what>(?:an?|two|three) [a-z ]+?) "
     r"(?:stands?|is|are|belongs?|{must} (?:stand|be))"
     r"(?={end})", r"\g<room> with \g<what>"),
    # "a library twice as large as that bedroom, a bathroom, a kitchen", "a studio with a single bed in the room"
    (r"\bas (?:that|this) (?=(?:{one})\b)", "as the "),
    (r"(\bstudio with [^.;]*?) in the room,? and (?=an? )", r"\1. "),
    # "the kitchen is opposite the bathroom, and the two bedrooms are opposite one another"
    (r",? (?:and|while) (?=the two bed ?rooms are (?:opposite|next to|near) (?:one another|each other)\b)", ". "),
    # "two exits, one to the hallway and one to the balcony"
    (r"\b(has|have|with) (two|three) (?:exits|ways out)(?=,? ?(?::|one to))", r"\1 \2 doors"),
    (r"\b(?P<room>the (?:balcony|terrace|{one})) can also be reached from (?P<other>the {one})",
     r"\g<room> also has a door to \g<other>"),
    # "a hallway is lost space, I do not want one"
    (r"\b(?:for (?:me|us),? )?(?:an? |the )?(?:hallways?|corridors?) (?:is|are) (?:only |just "
     r")?(?:lost|wasted|a waste of) space"
     r"(?:,? (?:and |so )?(?:i|we) (?:do not|don't) (?:want|need|like) (?:one|any|them|it))?", "no hallway"),
    # "no_door=(kitchen, living room), adjacent=(bedroom 1, bathroom)"
    (r"\bno[ _]door ?:? ?\((?P<a>{one}(?: \d)?) ?, ?(?P<b>{one}(?: \d)?)\)", r"no door between \g<a> and \g<b>"),
    (r"\badjacent ?:? ?\((?P<a>{one}(?: \d)?) ?, ?(?P<b>{one}(?: \d)?)\)", r"\g<a> is next to \g<b>"),
    # "Inputs -> bedrooms: 2", "Size ordering -> living room larger than bedroom 1"
    (r"(?P<begin>^|[.;\n] ?)(?:inputs?|outputs?|rooms|sizes?(?: "
     r"order(?:ing)?)?|order(?:ing)?|layout|constraints?) ?-> ?", r"\g<begin>"),
    # "two bathrooms that both open from the hallway"
    (r"\b(?P<rooms>{several} (?:bath|bed) ?rooms),? (?:that|which) (?:both |all )?(?:open|go|lead) "
     r"(?:from|off|onto|to) the (?P<hall>{hall})",
     r"\g<rooms> off the \g<hall>"),
    # "dead centre of the floorplan", "doors of both bathrooms must be in the hallway"
    (r"\b(?:dead|right in the|exact) (?:centre|center|middle) of (?:the )?(?:floor ?plan|plan|map|flat|"
     r"level)\b", "in the centre"),
    (r"\b(?:the )?doors? of (?P<a>both bath ?rooms|all bath ?rooms|the bath ?room|the kitchen|both bed ?rooms|"
     r"all bed ?rooms) "
     r"(?:{must} be|is|are|open|opens) (?:in|into|to|on|onto|at) the (?P<b>{hall})", r"\g<a> open off the \g<b>"),
    # "must to be 5 meters long", "more bigger"
    (r"\b(must|should|can) to (?=[a-z])", r"\1 "),
    (r"\bmore (?=(?:bigger|larger|smaller|wider|longer)\b)", ""),
    # "two bedroom. In first one a double bed, in second one two single beds"
    (r"\bin (?:the )?(?P<nth>first|second|third)(?: one)?,? (?:(?:stands?|is|are|there is|there are|i want|put) "
     r")?(?P<what>(?:an?|one|two|three) "
     r"[a-z ]*?(?:beds?|bunk beds?|desks?|cots?|wardrobes?))(?={end}|,? and in |,? in )", r"\g<what> in the "
     r"\g<nth> bedroom"),
    # "living windows west, bedroom windows (both) east"
    (r"\b(?P<a>living(?: room)?|bed ?rooms?|kitchen|study) windows?(?: \(?(?P<all>both|all)\)?)? (?:to (?:the "
     r")?|facing )?(?P<side>north|south|east|west)(?={end})",
     _facing),
    # "not_adjacent: [guest_wc, kitchen]", "far apart: bedroom, kitchen"
    (r"\bnot (?:adjacent|next|near)(?: to)? ?: ?\[?\(?(?P<a>[a-z][a-z ]*?(?: \d)?) ?[,&] ?(?P<b>[a-z][a-z "
     r"]*?(?: \d)?)\)?\]?"
     r"(?= ?(?:[.;,\n]|$))", r"the \g<a> is not next to the \g<b>."),
    # "Three students. We each want a bedroom of 12 m²"
    (r"(?P<before>\b(?:we are|for|of) (?:(?:a|the) )?(?P<n>two|three|four|five) (?:students|friends|flatmates|"
     r"roommates|housemates|colleagues|people|adults|siblings|sisters|brothers)\b"
     r"[^.;]*[.;] ?)(?:we each|each of us|everyone|everybody) (?:want|need|get|would like|has|have|should "
     r"have)s? (?:an?|our|their) (?:own )?"
     r"(?:bed ?)?room(?: of (?P<size>\d+(?:\.\d+)? ?m2))?", _each_wants),
    # "we find hallways a waste of space. We want to come straight into the living room and have A, B and C open off it"
    (r"\b(?:i|we|my \w+ and i)? ?(?:find|consider|think) (?:hallways?|corridors?)(?: are| is)? a waste of "
     r"(?:space|room|money)", "no hallway"),
    (r"\b(?:(?:i|we) want to )?(?:come|enter|walk) (?:straight|directly|right) into (?P<one>the living room) "
     r"and have (?P<rooms>[^.;]*?) "
     r"(?:all )?open off it\b", _through),
), one=r"(?:living(?: room)?|kitchen|dining(?: room)?|bed ?rooms?|bath ?rooms?|bath|hall(?:way)?|study|office|"
     r"storage(?: room)?|"
       r"pantry|closet|balcony|utility(?: room)?|laundry(?: room)?|toilet|wc|corridor)")  # fmt: skip


def tersely(text: str) -> str:
    """A folded text with such requests in words that the rules of rooms know."""
    return reworded(text, _SAID)
