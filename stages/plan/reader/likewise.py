"""What is said of one room and then, in fewer words, of another: `neither must the study`, `as the bathroom does`."""

import re

from apartgen.stages.plan.reader.pieces import MUST, reworded, rules

_MUST = rf"(?:{MUST}|does|do|is|are)"
_BY = (r"(?:share (?:a |any )?walls? with|touch|adjoin|border|(?:be )?(?:next|adjacent|close|opposite)(?: to)?|"
       r"(?:be )?near|(?:open|lead|give) (?:on|off|into|onto|to)|have a door to|face)")  # fmt: skip
_WHOSE = r"(?:my|our|the) [a-z]+(?:'s|s')(?: (?:bed ?)?room)?"
_ONE = {"my": "one", "our": "one", "mein": "ein", "mon": "un", "mi": "un"}


def _hers(found: re.Match[str]) -> str:
    """`my study faces east, hers north` as one and the other."""
    other = {"mein": "das andere", "mon": "l'autre", "mi": "el otro"}.get(found["my"], "the other")
    return f"{_ONE[found['my']]} {found['room']}{found['said']}{other}"


_SAID = rules((
    # "my study should face east, hers should face north"
    (r"\b(?P<my>my|mein|mon|mi) (?P<room>study|office|home office|closet|walk-in closet|bed ?room|arbeitszimmer|buro|"
     r"schlafzimmer|bureau|estudio|despacho|dormitorio)(?P<said> [^.;]+?[,;] ?(?:and |while |but |und |et |y )?|"
     r" [^.;]+? (?:and|while|und|et|y) )(?:hers|his|(?:my|your) (?:wife|husband|partner)'s|ihres|seines|le sien|"
     r"el suyo)(?= (?:{must}|faces?|is|has|gets?|looks?|at|in|on|to|north|south|east|west|nach|soll|hat|au|a|doit|al|"
     r"debe|tiene)\b)", _hers),
    # "must not share a wall with the living room, and neither must the study with the kitchen"
    (r"\b(?P<must>{must}) not (?P<by>{by}) (?P<to>{the}),? ?(?:and |but )?(?:neither|nor) {must} (?P<of>{the}),? "
     r"(?:with|to|next to|near|on|into|be next to|touch) (?P<other>{the}){end}",
     r"\g<must> not \g<by> \g<to>. \g<of> \g<must> not \g<by> \g<other>"),
    (r"\b(?P<must>{must}) not (?P<by>{by}) (?P<to>{the}),? ?(?:and |but )?(?:neither|nor) {must} "
     r"(?P<of>{the}){end}", r"\g<must> not \g<by> \g<to>. \g<of> \g<must> not \g<by> \g<to>"),
    # "the bedrooms face south, and so does the living room"
    (r"\b(?P<verb>faces?|looks?|lies?|is|are) (?P<side>(?:(?:to|on|at|in|near|far from|close to) )?(?:the )?"
     r"(?:north|south|east|west|back|front|entrance)\b(?: side)?),? ?"
     r"(?:and so|as) (?:does|do|is|are) (?P<of>{the}){end}", r"\g<verb> \g<side>. \g<of> \g<verb> \g<side>"),
    (r"\b(?P<verb>faces?|looks?|lies?|is|are) (?P<side>(?:(?:to|on|at|in|near|far from|close to) )?(?:the )?"
     r"(?:north|south|east|west|back|front|entrance)\b(?: side)?),? ?(?:just )?(?:as|like) (?P<of>{the})"
     r"(?: (?:does|do|is|are))?{end}", r"\g<verb> \g<side>. \g<of> \g<verb> \g<side>"),
    # "my room has a desk, and so does my sister's"
    (r"\b(?P<verb>has|have|needs?|gets?) (?P<what>(?:an?|one|two|its own) [^.;,]+?)[,;]? ?(?:and )?so "
     r"(?:does|do|should) (?P<of>{the}|{whose}){end}", lambda found: _theirs(found)),
    (r"\b(?P<verb>has|have|needs?|gets?) (?P<what>(?:an?|one|two|its own) [^.;,]+?)(?:[,;]| and|, and) (?P<of>{whose})"
     r"(?: does| has one)?,? (?:too|as well){end}", lambda found: _theirs(found)),
    # "the bedrooms open off the hallway, as the bathroom does", "and so does the bathroom"
    (r",? (?:as|like|just as|just like) ({the}) (?:also )?(?:does|do|is|are)(?: too)?{end}", r", as is \1"),
    (r",? (?:and )?so (?:does|do|is|are|should|must) ({the}){end}", r", as is \1"),
    # "another door leads from the hall into the bedroom"
    (r"\b(?:another|a second|a further|one more|a third) door (?=(?:leads|opens|goes|connects|is|links|takes) )",
     "a door "),
    # "2BR/2BA, one bath en suite, the other off the hall"
    (r"\bone bath(?: ?room)?,? (?:(?:is|being|as) )?(?:an? )?en[- ]?suite\b(?! to| of| with)", "one en suite bathroom"),
    # "swap the study for a second bathroom"
    (r"(?:,? (?:and|but))?\b(?:please )?(?:swap|exchange|trade|replace|substitute) (?:out )?(?:the|my|our) ({kind}) "
     r"(?:for|with|against|by) (?=(?:an?|one|two|another) )", r". forget the \1. "),
    # "其中一个卫生间在主卧里", "爷爷奶奶的卧室朝南"
    (r"其中一(?:个|间)(?:卫生间|卧室|浴室|厕所)(?=在|朝|带|是|要)", "其中一个"),
), whose=_WHOSE, must=_MUST, by=_BY)  # fmt: skip


def likewise(text: str) -> str:
    """A folded text that says such things of each room in full."""
    return reworded(text, _SAID)


def _theirs(found: re.Match[str]) -> str:
    """The same furniture of a second room, which may be told by whose it is."""
    room = f"{found['of']} room" if found["of"].endswith("'") or found["of"].endswith("'s") else found["of"]
    return f"{found['verb']} {found['what']}. {room} {found['verb']} {found['what']}"
