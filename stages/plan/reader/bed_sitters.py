"""Homes of one room, in which a bed is a bed: `studio, 30 m2: bed, desk`, `one room with bed and table`."""

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import reworded, rules

_BED = r"(?:mattress or )?bed"
_ONE = rules((
    # "just one room of 20 m2 with bed, stove and table, plus a bathroom"
    (r"(?:^|(?<=[ ,.;:]))(?:just |only )?(?:one|a single) (?:big |large |small )?room(?P<size> of [^,.;]{2,12}?"
     r"(?:m2|sqm|feet|ft))?(?= (?:with|that has|has) (?:an? )?(?:bed|mattress|stove)\b(?!.*\brooms?\b))",
     r"studio\g<size>"),
))
_STUDIO = late(r"\bstudio\b(?! (?:bed ?room|room|couch|with (?:a|one) (?:separate )?bed ?room))")
_BEDROOM = late(r"bed ?rooms?\b|\bbr\b")
_BARE = rules((
    (rf"(?P<before>(?:[,:(]|\band|\bor|\bwith) ){_BED}(?=,| and\b| or\b| near| next| in | by |[.;)]|$)",
     r"\g<before>a bed"),
))


def bed_sitters(text: str) -> str:
    """One room in which one cooks or sleeps as a studio, and the bare beds of studios as things."""
    text = reworded(text, _ONE)
    return reworded(text, _BARE) if _STUDIO.search(text) and not _BEDROOM.search(text) else text
