"""Rooms that nobody is to plan, homes only thought of: `don't give us a study`, `we thought of a studio, but no`."""

import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import reworded

_DO = (r"(?:give|giv|includ|add|plan|put in|put|provid|build|draw|design|bother with|bother about|install|squeeze in|"
       r"fit|"
       r"foresee|insert|create|creat|schedule|allow for|allow|hav|offer)(?:e|ing)?")  # fmt: skip
_FOR = r"(?: (?:us|me|him|her|them|in|for us|for me|with))*"
_WORD = (r"(?!(?:studio|facing|off|near|in|on|at|with|without|to|from|next|between|that|which|of|opening|for|like|by|"
         r"under|"
         r"over|"
         r"along|would|is|are|should|must|can|will|has|have|it|this|them|more|too|and|or|nor|but|as|please|either|the|"
         r"so|because|if|when|where|who|whose|open to|instead|less|than|connected|adjacent|beside|bigger|larger|"
         r"smaller)\b)[a-z]+")  # fmt: skip
_NOUN = rf"{_WORD}(?:[ -]{_WORD}){{0,2}}"
_ENDS = (r"(?= ?(?:[.,;:!?)]|$)| (?:at all|either|please|here|for us|for me|this time|any ?more|any longer|in it|but|"
         r"so|as|because)\b)")  # fmt: skip
_LIST = (rf"({_NOUN}(?:(?:, (?:an? |any )?{_NOUN})*,? (?:or|nor|and) (?:an? |any )?{_NOUN})?)"
         rf"{_ENDS}")
_WHO = (r"(?:(?:the|my|our|your|his|her) (?!two|three|four)[a-z]+(?: and i)?|he|she|they|we|i|you|people|the [a-z]+ "
        r"and "
        r"the [a-z]+)")  # fmt: skip
_NOT = r"(?:do not|does not|don't|doesn't|did not|didn't|would not|wouldn't|will not|won't|no longer)"
_WANT = r"(?:wants?|needs?|likes?|asks?(?:ed)? for|cares? for|wishe?s? for|requires?|insists? on)"
_SEVERAL = re.compile(r",| (?:and|or|nor) ")
_HOUSED = r"(?:studio|one[- ]room flat|bedsit)(?: (?:flat|apartment))?"
_CLAUSE = r"[^.;!?:,]"
_LATER = re.compile(r"\bbed(?:s\b|\b| ?rooms?\b)|\b\w*schlafzimmer\b|\b(?:zwei|drei|vier|[2-5])[- ]?zimmer|"
                    r"\bchambres?\b|"
                    r"\bdormitorios?\b|\bhabitacion(?:es)?\b|[一二两三1-5]室|卧室")  # fmt: skip
"""What a home has that is no studio."""
_ANEW = re.compile(
    r"^[ ,;:.!?-]*(?:(?:but|and|then|so|yet|now|in the end|finally|instead|rather|actually|on second thoughts?|"
    r"well|aber|dann|doch|mais|finalement|pero|luego|al final|但是?|不过|可是|还是)[ ,]*)*"
    r"(?:(?:no|nope|nein|non|not any ?more|不)(?:[ ]?[,:;.!]+ ?| (?=(?:an?|one|two|three|four|[1-6])[ -])))?"
    r"(?:(?:please )?make (?:it|that) )?"
)
"""What joins what is wanted to what was thought of."""
_THOUGHT = [late(pattern) for pattern in (
    rf"(?:^|(?<=[.;!?] ))(?:{_CLAUSE}|, (?=who|which|that))*?\b(?:thought|thinking|considered|considering|wondered|"
    rf"wanted|planned|meant|looked at|dreamt|dreamed|imagined|had|live|lived|living|currently|initially|originally|"
    rf"at first|first)\b{_CLAUSE}*?\b{_HOUSED}\b(?:{_CLAUSE}(?!\b(?:but|and)\b))*",
    rf"(?:^|(?<=[.;!?] ))(?:an? |the |our |my )?{_HOUSED} (?:is|was|would be|will be|seems|gets) (?:far |much |"
    rf"really )?"
    rf"(?:too (?:small|tiny|little|cramped|tight)|not (?:enough|big enough|large enough|for us))\b{_CLAUSE}*",
    rf"(?:^|(?<=[.;!?] ))(?:(?:we|i|they|he|she) (?:do not|don't|no longer) (?:want|need) (?:an? )?|no |not (?:an? )?)"
    rf"{_HOUSED}(?= ?[.,;!])",
    rf"(?:^|(?<=[.;!?] ))(?:an? )?{_HOUSED} ?(?=\? ?no\b|(?:-|,|\.\.\.|…) ?(?:but )?(?:no|sorry|actually)\b[,:.])",
    r"(?:^|(?<=[.;!?] ))[^.;!?:,]*?\b(?:dachte|dachten|wollte|wollten|uberlegte|uberlegten|wohne|wohnen|gedacht)\b"
    r"[^.;!?:,]*?\b(?:studio|einzimmerwohnung|einraumwohnung)\b[^.;!?:,]*",
    r"(?:^|(?<=[.;!?] ))[^.;!?:,]*?\b(?:pens\w+|vou\w+|songe\w*|habit\w+|viv\w+|envisage\w*)\b[^.;!?:,]*?\bstudio\b"
    r"[^.;!?:,]*",
    r"(?:^|(?<=[.;!?] ))[^.;!?:,]*?\b(?:pens\w+|quer\w+|viv\w+)\b[^.;!?:,]*?\bestudio\b[^.;!?:,]*",
    r"(?:^|(?<=[.;!?,]))[^.;!?:,]*?(?:想过|想要过|考虑过|原来想|本来想|住在)[^.;!?:,]*?(?:开间|单间|一居室)[^.;!?:,]*",
)]  # fmt: skip
_LIST_OF = (r"(?:the|our|my|this|your|that) (?:[a-z]+ ){0,2}(?:list|plans?|brief|wish ?list|program(?:me)?|request|"
            r"order|layout)")  # fmt: skip
_SAID = [(late(pattern), words) for pattern, words in (
    # "the client does not want a second bathroom", "nobody needs a study"
    (rf"\b{_WHO} {_NOT} (?:really |actually |also )?{_WANT}(?: to have)? (?:an?|any) {_LIST}",
     lambda found: _denied(found[1])),
    (rf"\b(?:nobody|no one|none of us)(?: here)? (?:really )?{_WANT} (?:an?|any) {_LIST}",
     lambda found: _denied(found[1])),
    # "please don't give us a guest room", "there is no need to add a balcony"
    (rf"\b(?:please,? )?(?:do not|don't|never|you (?:needn't|need not|don't (?:have|need) to|do not (?:have|need) to|"
     rf"shouldn't|should not|must not)|(?:there is |there's )?no (?:need )?(?:for you )?to|{_WHO} {_NOT} want you to) "
     rf"(?:please |also |even )?{_DO}{_FOR} (?:an? |any )?{_LIST}", lambda found: _denied(found[1])),
    (rf"\b(?:never mind|spare (?:us|me)|skip|no point in (?:having|adding|planning)) (?:an?|any) {_LIST}",
     lambda found: _denied(found[1])),
    (rf"\bspare (?:us|me) the ({_NOUN}){_ENDS}", r"forget the \1"),
    (rf"(^|[.;,] ?|\band |\bbut )(?:an?|any) ({_NOUN}) (?:is|are) not (?:wanted|needed|required|necessary){_ENDS}",
     r"\1no \2"),
    (rf"\b{_WHO} {_NOT} {_WANT} (?:an? |any )?open[- ](?:plan )?kitchens?\b", "no open kitchen"),
    # "don't forget the balcony"
    (r"\b(?:please )?(?:do not|don't) forget (?:about )?(?:to (?:add|include|plan) )?(?=the |an? |my |our |two |one )",
     "with "),
    (r"\b(?:bitte )?nicht (?:zu )?vergessen ?: ?|\b(?:und )?verg(?:iss|esst|essen sie) (?:bitte )?nicht (?=d|ein)",
     "mit "),
    (r"\bn'oubliez pas |\bn'oublie pas ", "avec "), (r"\bno (?:te )?olvid\w+ ", "con "),
    (r"(?:请)?别忘了?|不要忘了?", "有"),
    # "strike the study from our list", "take the study off the plan", "cross out the balcony"
    (rf"\b(?:please )?(?:strike|cross|take|drop|cut|leave|delete|remove|scratch|erase|keep)(?: out| off)? the ("
     rf"{_NOUN}) "
     rf"(?:from|off|out of) {_LIST_OF}(?: of [a-z]+)?", r"forget the \1"),
    (rf"(^|[.;,] ?|\band )(?:please )?(?:strike|cross out|cross off|leave off|cut out|strike out|axe) the ({_NOUN})"
     rf"{_ENDS}",
     r"\1forget the \2"),
    (r"\bwhat (?:stays|remains|is left|we keep|i keep)(?: then)?(?: is| are|:) ", ""),
    # "no incluyas un despacho", "plant bitte kein Arbeitszimmer ein"
    (r"\bno (?:(?:nos|me|le|hace falta|hay que) )?(?:pong\w+|incluy\w+|anad\w+|metas|metan|des|den|hag\w+|proyect\w+|"
     r"prev\w+) (?:ni )?(?:un[oa]? |ningun[oa]? )?(?=[a-z]+(?: de [a-z]+)? ?(?:[.,;]|$))", "sin "),
    (r"\b(?:plan(?:t|e|en sie)|bau(?:t|e|en sie)) (?:bitte )?(?=kein)", ""),
)]  # fmt: skip


def _denied(rooms: str) -> str:
    """A room as one that there is none of, `a balcony or a study` as what we do not want."""
    several = _SEVERAL.search(rooms)
    return f"we don't want {'an' if rooms[0] in 'aeiou' else 'a'} {rooms}" if several else f"no {rooms}"


def declined(text: str) -> str:
    """A folded text with such rooms denied, without homes that were only thought of."""
    text = reworded(text, _SAID)
    for thought in _THOUGHT:
        text = _settled(text, thought.search(text))
    return text


def _settled(text: str, found: re.Match[str] | None) -> str:
    """What is wanted behind a studio that was thought of, where that has bedrooms."""
    if found is None:
        return text
    rest = _ANEW.sub("", text[found.end() :])
    return text[: found.start()] + rest if _LATER.search(rest) and not _LATER.search(found.group()) else text
