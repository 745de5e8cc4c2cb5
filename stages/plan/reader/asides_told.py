"""Lists with dashes, ages, whose the rooms are by a copula, second doors: what stands beside the point, in plain "
"words."""

import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import reworded
from apartgen.stages.plan.reader.retold import children_named

_PIECE = ("(?:single bed|double bed|bed|desk|chair|armchair|sofa|lamp|wardrobe|table|nightstand|bookshelf|rug|plant|"
          "mirror)")
_COUNTED = re.compile(r"(?:an?|one|two|three|four|five|six|no|\d) ?[a-z][a-z /-]*")
_DOORS = re.compile(r"->|\b(?:connections?|connected|edges|graph|topology|adjacency|links|doors?)\b")
_FOR = re.compile(
    r"\bthe (big|bigger|biggest|large|larger|largest|small|smaller|smallest|middle|medium|second|third|other|"
    r"first)(?: one| bed ?room| room)? "
    r"(?:is|will be|should be) for ((?:my|our|the) [a-z]+(?: and (?:me|i))?|me(?: and my [a-z]+)?|us)(?= ?(?:[.,;]|$|"
    r"and ))"
)
_SAID = [(late(pattern), words) for pattern, words in (
    # "the kitchen is the only way to the balcony"
    (r"\b(the [a-z]+(?: room)?) is the only (?:way|access|entrance|entry|door) (?:in|on)?to (the [a-z]+(?: room)?)\b",
     r"\2 is reached only from \1"),
    # "a door to the kitchen and a second one to the balcony"
    (r"(\bdoor to (?:the |an? )?[a-z]+(?: room)?),? and (?:a second|another|one more)(?: one| door)? to (?=the |an? )",
     r"\1 and a door to "),
    # "no doors between the kitchen and the lounge, just one open space", "between kitchen and dining room no wall"
    (r"\b(?:no|without) doors? between ((?:the )?[a-z]+(?: room)?) and ((?:the )?[a-z]+(?: room)?),? (?:just|only|but|"
     r"but just) (?:one |an? )?"
     r"(?:big |large |single )?(?:open space|open plan|open room)\b", r"\1 and \2 in one open space"),
    (r"\bbetween ((?:the )?[a-z]+(?: room)?) and ((?:the )?[a-z]+(?: room)?),? (?:there )?(?:is |should be |must be "
     r")?no walls?(?= ?(?:[.,;]|$))",
     r"\1 and \2 in one open space"),
    (r"\bopen (?:doorway|archway)\b", "opening"),
    # "the bathroom must be near my bedroom and at least 5 m2", "the largest one also an armchair"
    (r"\b((?:the|my) [a-z]+(?: room)?) ((?:must|should|has to|needs to) be (?!at )[^.;,]*?),? and (at least|at most|"
     r"about) (\d+(?:[.,]\d+)?) ?(m2|sqm)\b",
     r"\1 of \3 \4 m2 \2"),
    (r"(\b(?:has|gets|have|needs|get)\b[^.;]*?,) (?:and )?(the (?:largest|biggest|smallest|other|first|second|"
     r"third)(?: one| bed ?room)?) "
     r"(?:also|additionally|in addition|too) (?=an? |one |two )", r"\1 \2 has "),
    (r"\bmit (?:einer )?tur(?:en)? (?:zum|zur) (\w+) und (?:zum|zur) (\w+)", r"with a door to the \1 and a door to "
     r"the \2"),
    (r"\botr[oa] para cada un[oa] de (?:nuestr[oa]s|los|las|mis) (dos|tres|cuatro) (?:hij[oa]s|nin[oa]s)\b",
     r"\1 kids rooms"),
    (r"\bune (?:autre )?pour chacune? de (?:nos|mes|leurs) (deux|trois|quatre) (?:enfants|filles|fils)\b",
     r"\1 kids rooms"),
    (r"\bfree (?:of|from) (?=[a-z])", "with no "),
    (r"\bvom (\w+)(?: aus)? (?:(?:soll|kann|muss|will|kommt|gelangt) )?man (?:direkt )?(?:auf|in|zu) (?:den|die|das|"
     r"einen|eine) (\w+)(?: (?:kommen|gelangen|gehen))?(?: (?:soll|kann|konnen))?", r"\2 zuganglich vom \1"),
    (r"\b(el balcon|la terraza) (?:esta|debe estar|tiene que estar|va) en (el|la) (\w+)(?:,? y no en (?:el|la) \w+)?",
     r"\1 accesible desde \2 \3"),
    # "a room each for our two daughters"
    (r"\ban? (?:bed ?)?room each for (?:our |my |the )?(two|three|four|[2-4]) (?:daughters|sons|children|kids|boys|"
     r"girls|teenagers)\b",
     r"\1 kids rooms"),
    # "the girls (8 and 10) share"
    (r" ?\((?:aged? )?\d{1,2}(?:,? (?:and|&) \d{1,2}|, \d{1,2}(?:,? (?:and|&) \d{1,2})?)?(?: years?(?: old)?)?\)(?= "
     r"(?:share|has|have|need|want|get))", ""),
    (r",? (?:the )?toilet (?:is |should be |must be )?(?:together|in one|combined|joint)(?: with| in)? (?:the )?bath "
     r"?room\b", ""),
    # "not less 6 m2"
    (r"\b(?:be )?not (?:be )?less (?:than |then |as )?(?=\d)", "at least "),
    (r"\b(?:be )?not (?:be )?more (?:than |then |as )?(?=\d)", "at most "),
    (r"\b(?:an?|one) (toilet|wc) (?:extra|more|in addition)\b", r"a separate \1"),
    # "two bedrooms …; the bathroom between them"
    (r"(\btwo (?:[a-z]+ )?bed ?rooms\b[^.]*?)[;,] (?:and )?(the|an?|one) bath ?room between them ?(?:[.,;]|$)",
     r"\1. \2 bathroom is between the two bedrooms. "),
    (r"\bzwei balkone?(?: haben)?,? einen? (?:am|vor dem|beim|im|an der|vor der|zum|zur) (\w+) und (?:noch )?einen? "
     r"(?:weiteren )?"
     r"(?:am|vor dem|beim|im|an der|vor der|zum|zur) (\w+)", r"ein balkon am \1 und ein weiterer balkon am \2"),
    (rf"\b({_PIECE}) ?x ?(\d)\b(?! ?[xm.\d])", r"\2 \1s"),
    (r"我和[^,.;和]{1,4}各(?:要|住)?一间(?:卧室|房间|房)?", "两间次卧"),
    (r"爸妈", "父母"),
)]  # fmt: skip


def beside_told(text: str) -> str:
    """A folded text with such clauses in the words of rooms."""
    text = reworded(children_named(text), _SAID)
    if len(_FOR.findall(text)) > 1:
        text = _FOR.sub(_whose, text)
    return _dashed(text)


def _whose(found: re.Match[str]) -> str:
    """`the small one is for my son` as what the son has."""
    who = found[2]
    ours = who == "us" or " and " in who
    size = "large" if found[1].startswith(("big", "larg")) else found[1]
    return f"{'we have' if ours else 'i have' if who == 'me' else f'{who} has'} the {size} bedroom"


def _dashed(text: str) -> str:
    """`three beds - two baths - lounge` as a list; dashes between rooms alone are doors."""
    parts = text.split(" - ")
    listed = len(parts) > 3 and any(_COUNTED.fullmatch(part.strip()) for part in parts) and not _DOORS.search(text)
    return ", ".join(parts) if listed else text
