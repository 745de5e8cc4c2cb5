"""Ways in, wishes and owners as people say them in passing, put into words that the rules know."""

import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import CHILD, ELDER, GROWN, YOUNG, reworded

_ANYONE = "(?:you|one|we|people|i)"
_THROUGH = "(?:through|via|from|by way of)"
_WISHED = "place|put|add|set up|set|we need|i need|we want|i want"
_FINITE = r"\b(?:is|are|will|can|must|should|may)\b"
_KIN = rf"{ELDER}|{CHILD}|brother|sister"
_WANT = "wants?|needs?|gets?|has|have|should have|would like"
_YOUNG = rf"{YOUNG}|brothers|sisters"
_SLEEP = "has|have|gets?|takes?|wants?|sleeps? in|use|uses"
_WHICH = "small|little|large|big|smaller|bigger|larger|other|front|back|first|second"
_SOMEBODY = r"(?:my|our|his|her) [a-z]+|i|we|he|she"
_NEEDED = (r"\b(?:needs?|wants?|gets?|has|have) an? "
           r"((?:home |small |large )?(?:study|office|bedroom|bathroom|desk|balcony))\b")  # fmt: skip


def _theirs(found: re.Match[str]) -> str:
    """`I have the little room` as a bedroom, which is not that of the parents named before."""
    other = found[1] == "i" and "parents' bedroom" in found.string[: found.start()]
    return f"{found[1]} {found[2]} {'another' if other else 'the'} {found[3] or ''}bedroom"


def _too(found: re.Match[str]) -> str:
    """`I need a study, my husband too`: another one for the husband."""
    said = found.group()
    return f"{said[: found.start(2) - found.start()]}{found[2]} needs another {found[1]}"


_ONE_DOOR = re.compile(
    r"\b(?:one|a|the first) (?:door )?(?:leads|goes|opens) (to|into|onto) (?P<first>[^.,;]+?),? "
    r"(?:and |while )?(?:another|(?:the )?other|the second|a second)(?: one| door)?(?: (?:leads|goes|opens))? "
    r"(?:to|into|onto) "
)
_IN_IT = re.compile(
    r"\b(?P<room>(?:an? |the |one )?[\w-]+(?: room)?) (?P<link>off|next to|beside|opposite|near|behind) "
    r"(?P<other>(?:the |an? )?[\w-]+(?: room)?),? (?P<things>with (?!its|their)[^.,;]+?) in it\b"
)

_ROOM = r"(?:the |an? |our )?[a-z]+(?: room)?"
_WALLESS = (r"(?:(?:there (?:is|are|should be|must be) )?(?:(?:i|we) want )?(?:no|without (?:an?|any))|"
            r"(?:(?:(?:i|we) )?(?:do not|don't) (?:want|need|like|put|build|plan) (?:an?|any|the)|"
            r"(?:leave|take|knock|cut) (?:out|away|down) (?:the|that|any)|"
            r"(?:remove|skip|omit|drop|take|knock|delete|get rid of|do without) (?:the|that|any)))")  # fmt: skip
_SAID = [(late(pattern), words) for pattern, words in (
    # "You can only get to the study through the bedroom, and to the closet only through the study."
    (rf"\b{_ANYONE} can only (?:get (?:in)?to|go (?:in)?to|reach|enter|access) ((?:the |an? )?[a-z -]{{3,30}}?) "
     rf"{_THROUGH} ", r"\1 is reachable only from "),
    (rf"(\bis reachable only from [^.;,]+),? and (?:in)?to ((?:the |an? )?[a-z -]{{3,30}}?) only {_THROUGH} ",
     r"\1, and \2 is reachable only from "),
    # "My room has a desk, my brother's a piano", "her room has a piano, his a desk"
    (r"\b(mother|father|sister|brother|son|daughter)-in-law's\b", r"\1's"),
    (rf"\b(my|our|the|his|her) ({_KIN})'s (?=(?:has|is|needs|gets|should|must|faces|opens|lies|an?|two|one|with|on|"
     r"next|opposite|off)\b)", r"\1 \2's room "),
    (r"(\bher room\b[^.]*?[,;] (?:and |while )?)his (?=(?:has|is|needs|gets|an?|two|one|with)\b)", r"\1his room "),
    # "mum and dad share", "the boys share"
    (r"\b(?:my )?(?:mum|mom|mother) and (?:dad|father) share(?= ?[,;.])", "a parents' bedroom"),
    (rf"\b((?:the|our|my|two|three) "
     rf"(?:(?:two|three|older|younger|little|small|big) ){{0,2}}(?:{_YOUNG})) "
     rf"(?:may |can |could |will )?share(?= ?[,;.])",
     r"\1 share a room"),
    # "I have the small room next to the kitchen, my sister the one with the balcony"
    (rf"\b(i|we|he|she|they) ({_SLEEP}) the ((?:{_WHICH}) )?room\b", _theirs),
    (rf"(\b(?:{_SLEEP}) the [^.;]*?bedroom\b[^.;]*?[,;] (?:and )?)((?:my|our|his|her) (?:{_KIN}) )the "
     rf"((?:{_WHICH}) )?(?:room|one)\b", r"\1\2has the \3bedroom"),
    # "I need a study; my husband does too", "and so does my wife"
    (rf"{_NEEDED}[^.;,]*?[,;.]? ?(?:and |but |so )*so (?:does|do) ({_SOMEBODY})\b", _too),
    (rf"{_NEEDED}[^.;,]*?[,;.]? ?(?:and |but |so )*({_SOMEBODY}) (?:does|do|did|(?:needs?|wants?) one)?,? ?"
     r"(?:too|as well|also)\b", _too),
    (r"\b(?:brauche|brauchen|braucht|mochte|will) ein(?:en|e)? (?P<room>[a-z]+),? (?:und )?"
     r"(?P<who>(?:mein|unser)e? [a-z]+) auch\b", r"\g<0>: noch ein weiteres \g<room>"),
    # "We are four students and each of us wants a room", "we are three and want each our own room"
    (rf"\bwe are (\d|two|three|four|five|six)(?: (?:{GROWN}))?(?: and|[,;.:])? ?(?:we )?"
     rf"(?:(?:each|everybody|everyone|all)(?: of us)? (?:{_WANT})|(?:{_WANT}) each) "
     r"(?:an?|our|his|her|their)(?: own)? (?:bed ?)?room(?: of (?:our|his|her|their) own)?\b",
     r"\1 friends, each wants a room"),
    # "a home for my sister and me. We each want our own bedroom with our own bathroom"
    (rf"\bfor my [a-z]+ and me(?:[,;.:?!]| and| so)+ ?(?:and )?(?:we each|each of us|we both) (?:{_WANT}) "
     r"(?:an?|our own|our|his|her) bed ?room with (?:our|an?|its|his|her)(?: own)? "
     r"(en ?suite|(?:bath|shower) ?room)(?: of (?:our|its) own)?(?: (?:opening|that opens|leading) off (?:it|theirs))?",
     r". two bedrooms, each with its own \1"),
    # "a balcony where you go out from the kitchen"
    (rf"\b(?:where|(?:on|in|to|onto|into) which) {_ANYONE} (?:can )?(?:go|get|come|step|walk|enter)(?: out| in)?"
     rf"(?: (?:on|in|to|into|onto))? ({_THROUGH}) ", r"that is reached \1 "),
    # "the room of my son", "I study cooking", "two bedrooms, both of 12"
    (rf"\b(?:the )?((?:bed ?)?room) of (my|our|the|his|her) ({_KIN})\b", r"\2 \3's \1"),
    (r"\b(i|we|they|who) study (?=[a-z])(?!with|and|is|has)", r"\1 "),
    (r"\b((?:bed|bath|kids |guest |children's )rooms),? (?:both|all|each) (of|with|at) (?=\d)", r"\1 \2 "),
    # "…: place a cot and a chest of drawers there"
    (rf"[:,;.] ?(?:and |so )?(?:please )?(?:{_WISHED}) "
     rf"((?:(?!{_FINITE})[^.;:])+?) there(?= ?(?:[.,;]|$))", r" and has \1"),
    # "Wheelchair study: a flat with …"
    (r"^\s*(?:an? |the )?(?!(?:small|large|big|my|our|his|her|home|private|quiet|second)\b)"
     r"(?:([a-z-]+) study|study of ([a-z-]+)) ?: ?(?=[^.;:]*\b(?:flat|apartment|house|home)\b)", r"\1\2: "),
    # "There is no wall between the kitchen and the living room.", "please leave out the wall between them"
    (rf"\b(?:please )?{_WALLESS} walls?(?:,? please,?)? between ({_ROOM}) and ({_ROOM})(?: (?:out|away|down))?\b",
     r"\1 and \2 in one open space"),
)]  # fmt: skip


def in_passing(text: str) -> str:
    """A folded text with such clauses in the words of doors and furniture."""
    text = _ONE_DOOR.sub(lambda found: f"a door leads {found[1]} {found['first']} and {found[1]} ", text)
    text = _IN_IT.sub(lambda found: f"{found['room']} {found['things']} {found['link']} {found['other']}", text)
    return reworded(text, _SAID)
