"""Labels and lists of programs, and imperatives of agents, in words the rules know: `study no`, `Constraint 1:`."""

import re

from apartgen.stages.plan.reader.constraints import as_constraints
from apartgen.stages.plan.reader.pieces import ROOM, reworded, rules

_ROOM = rf"(?:{ROOM}|laundry|storage|garage|basement)"
LABEL = (r"(?:constraint|requirement|rule|condition|step|criterion|clause|demand|instruction|goal|task|wish|spec|"
         r"objective|need|request)")
"""What is numbered in lists of wishes."""
_OWN = {
    "room": _ROOM,
    "begin": r"(?P<begin>^|[.;,\n(] ?|[-*] )",
    "end": r"(?= ?(?:[.;,\n)]|$))",
    "label": LABEL,
    "code": r"(?:c|r|rq|req|con|cond)",
    "least": r"(?:min(?:imum|imal)?|least|smallest|minimal)\.?",
    "most": r"(?:max(?:imum|imal)?|greatest|largest|maximal)\.?",
    "metres": r"(?P<n>\d+(?:\.\d+)?) ?(?P<unit>m|cm|ft|met(?:er|re)s?|feet)\b(?! ?[2²x])",
}
_COUNTED = r"(?:(?:^|[:,\n] ?){0}(?= ?(?:[,\n]|$))|{0}s?: ?1|(?<![\d.])(?:1|one|single)[ -]{0})\b"
_HEAD = re.compile(rf"(?P<begin>\n|[.;] ?)(?P<room>{_ROOM}) ?: ?(?!(?:yes|none|no|\d+(?! ?[a-z]))\b)")
"""A heading with what is said of its room behind it: no truth value and no count."""


def _wide(least: str) -> tuple[tuple[str, str], ...]:
    """`min width 1.3 m`, `with a minimum width of 1.3 m`, `width min: 1.3 m`."""
    words = "at least" if least == "least" else "at most"
    return tuple(
        (rf"(?:\bwith an? |\b(?:its|the) )?{{{least}}} {name}(?: ?:| of| is| should be| must be)? ?{{metres}}",
         rf"{words} \g<n> \g<unit> {said}")
        for name, said in (("width", "wide"), ("length", "long"))
    )  # fmt: skip


_SAID = rules([
    # "Constraint 1: one bathroom", "Step 2) add", "C1: two bedrooms"
    (r"{begin}{label} ?#?\(?\d{1,2}\)? ?[:.)-] ?", r"\g<begin>"),
    (r"{begin}{label} [a-h] ?: ?", r"\g<begin>"),
    (r"{begin}{code}-?\d{1,2} ?: ?(?=[a-z\d])", r"\g<begin>"),
    # "study no | balcony none", "Study: not needed"
    (r"{begin}(?P<room>{room}) (?:no|none){end}", r"\g<begin>no \g<room>"),
    (r"{begin}(?P<room>{room}) ?: ?(?:not? (?:needed|required|wanted|necessary|applicable)|"
          r"unneeded|not|n/?a|absent|excluded|omit(?:ted)?){end}",
     r"\g<begin>no \g<room>"),
    *_wide("least"), *_wide("most"),
    # "Do not connect the kitchen to the living room.", "Connect bathroom 1 to bedroom 1.", "Connect A and B."
    (r"\b(?:do not|don't|never) (?:connect|link|join) (?P<a>(?:the )?{room}(?: \d)?) "
          r"(?:to|with|and) (?P<b>(?:the )?{room}(?: \d)?)\b", r"no door between \g<a> and \g<b>"),
    (r"(?P<begin>^|[.;,\n] ?(?:and )?|[-*] )(?:please |then )?(?:connect|link|join) "
          r"(?P<a>(?:the )?{room}(?: \d)?) and (?P<b>(?:the )?{room}(?: \d)?){end}",
     r"\g<begin>\g<a> is connected to \g<b>"),
    (r"(?P<begin>^|[.;,\n] ?(?:and )?|[-*] )(?:please |then )?(?:connect|link|join|attach) "
          r"(?P<a>[a-z][a-z\d '-]*?) (?:to|with) (?!each other|one another)(?=(?:the |a |an |each |all )?[a-z])",
     r"\g<begin>\g<a> is connected to "),
], **_OWN)  # fmt: skip


def itemized(text: str) -> str:
    """A folded text with such labels and lists in words; a heading of the only room of its kind is that room."""
    if re.search(r"(?:^|[:.,;\n] ?)\(1\) ", text) and "(2) " in text:
        text = re.sub(r"[.,;]? ?\(\d\) ", ". ", text)  # "(1) two bedrooms (2) one bathroom"
    return _HEAD.sub(_the_one, reworded(as_constraints(text), _SAID))


def _the_one(found: re.Match[str]) -> str:
    """`bedroom: 1 double bed` below `1 bedroom` as `the bedroom: …`."""
    before = found.string[: found.start() + 1]
    named = re.search(_COUNTED.replace("{0}", found["room"].replace(" ", " ?")), before)
    return f"{found['begin']}the {found.group()[len(found['begin']) :]}" if named else found.group()
