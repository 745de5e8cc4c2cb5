"""Whose of several children's rooms is whose: `the two boys share, the girl has her own, the baby sleeps with us`."""

import re

from apartgen.stages.plan.reader.about import numbers
from apartgen.stages.plan.reader.families import COUNTED
from apartgen.stages.plan.reader.patterns import Late
from apartgen.stages.plan.reader.pieces import END

_COUNT = (r"[2-6]|two|three|four|five|six|zwei|drei|vier|funf|sechs|deux|trois|quatre|cinq|dos|tres|cuatro|cinco|"
          r"[两二三四五]")
_ONE = r"an?|one|eine?n?|une?|una?|1|一"
_ZH = {"一": 1, "两": 2, "二": 2, "三": 3, "四": 4, "五": 5}
_NOUNS = {
    "boys": r"boys?|sons?|jungs?|jungen?|sohne?n?|garcons?|fils|chicos?|varones|儿子|男孩子?",
    "girls": r"girls?|daughters?|madchen|tochtern?|tochter|filles?|chicas?|ninas?|hijas?|女儿|女孩子?",
    "twins": r"twins|zwillingen?|jumeaux|jumelles|gemel[oa]s|melliz[oa]s|双胞胎",
    "all": r"ones|teenagers?|toddlers?|kids?|children|child|kind(?:ern?)?|enfants?|hijos?|ninos?|孩子|小孩",
}  # fmt: skip
_CHILD = "|".join(words.removeprefix("ones|") for words in _NOUNS.values()) + "|teenagers?|baby|bebe"
_NOUN = "|".join(f"(?P<{kind}>{words})" for kind, words in _NOUNS.items())
_ANY = "|".join(_NOUNS.values())
_MY = (r"(?:(?:the|an?|eine?|une?|una|our|my|his|her|their|both|all|die|der|das|den|unsere?n?|meine?n?|beiden?|les|la|"
       r"le|nos|mes|notre|mon|ma|los|las|el|nuestr[oa]s?|mis?|我们?的?) )*(?:l')?")  # fmt: skip
_AGE = (r"(?:(?:older|younger|elder|eldest|oldest|youngest|little|small|big|teenage|young|grossen?|kleinen?|"
        r"altere[nr]?|jungere[nr]?|petit[es]*|grand[es]*|pequen[oa]s?|mayor(?:es)?|other|only|个) ?)*")  # fmt: skip
_WHO = (rf"(?<![a-z'])(?<!that )(?<!which )(?<!where )(?<!for )(?<!of )(?<!of the )(?<!of our ){_MY}(?:(?P<n>{_COUNT}) "
        rf"?)?{_AGE}(?:{_NOUN})(?![a-z'])")  # fmt: skip
_SHARE = (r"(?:(?:will|can|should|must|may|are|do|want to|would like to|to|can all|both|always|happily|werden|sollen|"
          r"konnen|doivent|pueden|deben) )*(?:share(?: (?:an?|one|the same|the) (?:bed ?)?room| one| together)?|"
          r"(?:both |all )?together(?= ?[.,;!]|$)|sharing(?: (?:an?|one|the same) (?:bed ?)?room)?|sleep(?:ing|s)? "
          r"(?:together|in (?:one|the same|a shared|a) (?:bed ?)?room|in the same one)|(?:stay|are|live|go|be|being|"
          r"put) (?:together|in (?:one|the same|a shared) (?:bed ?)?room)(?: in (?:one|a) (?:bed ?)?room)?|together "
          r"in (?:one|the same|a) (?:bed ?)?room|in one (?:bed ?)?room|schlafen (?:zusammen|gemeinsam|in einem zimmer|"
          r"im (?:gleichen|selben) zimmer)|teilen(?: sich)? (?:ein|das)(?: gemeinsames)? zimmer|sich ein zimmer "
          r"teilen|zusammen schlafen|(?:se )?partagent (?:une|la meme|leur)? ?chambre|dorment (?:ensemble|dans la "
          r"meme chambre)|partagent|comparten(?: (?:una |la misma )?(?:habitacion|dormitorio|cuarto))?|duermen juntos|"
          r"duermen juntas|duermen en (?:la misma|una) habitacion|(?:一起|合|共)(?:住|睡|用)(?:一?[间个](?:房间?|"
          r"卧室)?)?|(?:住|睡)(?:在)?(?:同)?一?[间个](?:房间?|卧室)?)")  # fmt: skip
_OWN = (r"(?:(?:will|can|should|must|may|is to|would like to|wants to|soll|doit|debe) )*(?:(?:has|have|gets?|needs?|"
        r"wants?|with|takes?|having|to have|hat|bekommt|braucht|hat|a|aura|tiene|necesita|quiere) )?(?:(?:her|his|"
        r"their|its) own(?: (?:bed ?)?room)?|(?:an?|one) (?:own |separate |single )?(?:bed ?)?room (?:of (?:her|his|"
        r"their) own|to (?:her|him)self|alone|for (?:her|him)self)|(?:an?|one) (?:own|separate) (?:bed ?)?room|the "
        r"other(?: (?:bed ?)?room| one)?|another(?: one| (?:bed ?)?room)|one alone|(?:(?:sleeps?|stays?|is|schlaft|"
        r"dort|duerme) )?(?:alone|on (?:her|his) own|by (?:her|him)self|in (?:her|his|its) own(?: (?:bed ?)?room)?|in "
        r"(?:another|the other|a separate|the second)(?: (?:bed ?)?room| one)?|allein|seule?|sol[oa]|im (?:anderen|"
        r"eigenen)(?: zimmer)?)|(?:ein|ihr|sein) eigenes(?: zimmer)?|(?:sa|une) propre chambre|la sienne|sa chambre|"
        r"(?:su|una) (?:propia )?habitacion(?: propia)?|la suya|el suyo|su propio (?:cuarto|dormitorio)|(?:自己|单独|"
        r"独自|另外?)+(?:住|睡|有|要)*一?[间个]?(?:房间?|卧室)?)")  # fmt: skip
_WITH_US = (r"(?:(?:will|can|should|still|also|for now) )*(?:sleeps?|stays?|is|goes|schlaft|dort|duerme|bleibt)(?: "
            r"still| noch| encore)?(?: in)? (?:with (?:us|me|(?:his|her|its|their|the) parents|mum and dad)|in (?:our|"
            r"my|the parents'|the main)(?: bed)? ?room|bei (?:uns|den eltern)|(?:in|mit) unserem (?:schlafzimmer|"
            r"zimmer)|avec (?:nous|ses parents)|dans notre chambre|con (?:nosotros|sus padres)|en nuestr[oa] "
            r"(?:habitacion|dormitorio|cuarto))|(?:和|跟|与)(?:我们|父母|爸妈)(?:一起)?(?:睡|住)")  # fmt: skip
_BABY = (rf"(?<![a-z']){_MY}{_AGE}(?:baby|babys|bebe|newborn|toddler|youngest|little one|kleinste|jungste|cadet|宝宝|"
         rf"婴儿)(?: one)?")  # fmt: skip
_ELDEST = (rf"(?<![a-z']){_MY}(?:eldest|oldest|youngest|older one|big one|third|other|last|teenager|smallest|alteste|"
           rf"jungste|"
           r"grosse|dritte|aine|ainee|mayor|tercer[oa]?|老大|老三|大的)(?: (?:one|child|kid|son|daughter|boy|girl|"
           r"kind|enfant|hij[oa]))?")  # fmt: skip
_JOINT = (r"(?:[,;:.-]| |\b(?:and|while|but|whereas|who|und|wahrend|aber|die|et|qui|mais|tandis que|y|que|pero|"
          r"mientras que)\b)*")  # fmt: skip
_SOME = (rf"(?:(?:{_COUNT}|{_ONE}) ?{_AGE}(?:{_ANY}|baby|bebe|babys|宝宝)|twins|zwillingen?|jumeaux|jumelles|"
         rf"gemel[oa]s|双胞胎)")  # fmt: skip
_MENTION = Late(rf"(?<![a-z\d']){_SOME}(?:(?:,|,? and|,? und|,? et|,? y|,? plus|和) ?{_SOME})*(?![a-z'])(?! ?(?:bed "
                rf"?)?rooms?)")
_PART = Late(rf"(?<![a-z])(?:(?P<count>{_COUNT}|{_ONE}) ?)?{_AGE}(?:{_NOUN}|(?P<baby>baby|bebe|babys|宝宝))(?![a-z'])")
_SHARED = Late(rf"{_JOINT}{_WHO},? ?(?:who |die |qui |que )?{_SHARE}(?={END}|,? (?:and|while|but|und|et|y|aber|mais|"
               rf"pero) |$)")
_ALONE = Late(rf"{_JOINT}(?:{_WHO}|(?P<eldest>{_ELDEST})),? ?(?:who |die |der |das |qui |que )?{_OWN}(?={END}| and | "
              rf"while | und | et | y |$)")
_BABIES = Late(rf"{_JOINT}{_BABY} ?(?:{_WITH_US})(?={END}| and | und | et | y |$)")
_TOGETHER = re.compile("[一合共]起?[住睡用]")
_FAMILY = re.compile(r"(?:\b(?:we are|wir sind|nous sommes|somos) )?(?:\b(?:an?|the|eine?|une|una) )?\bfamil(?:y|ie|"
                     r"le|ia)(?: (?:with|of|has|mit|avec|con|de|von|die hat))? ?$")  # fmt: skip
"""What stands before children of whom only the rooms are left."""
_ELSE = re.compile(r"(?<!our )(?<!our own )(?<!parents' )(?<!master )(?<!main )\b(?:bed ?rooms?|schlafzimmer|"
                   r"chambres?|dormitorios?|habitacion(?:es)?)\b|卧室|\b(?:parents?|eltern|padres|each|own|us in|in a "
                   r"third|another|others?|jeder?|chacune?|cada)\b|"
                   rf"父母|(?<![a-z'])(?:{_CHILD})(?![a-z'])")  # fmt: skip
_OTHERS = ("kids room", "children's room", "nursery", "kinderzimmer", "儿童房", "guest room",
           "grand", "except", "friend", "student",
           "mates", "colleague", "my parents", "meine eltern", "mes parents", "mis padres")
"""Rooms that are told of otherwise: then nothing is summed here."""


def siblings(text: str) -> str:
    """A folded text with the rooms of such children in the place of what it says of them."""
    told = _told(text)
    if told is None:
        return text
    rooms, rest, at = told
    known = re.search(r"\b(?:parents'|master|our) (?:bed ?)?room|elternschlafzimmer|主卧", rest)
    ours = "" if known else "a parents' bedroom and "
    kids = f"{ours}{len(rooms)} kids rooms" if len(rooms) > 1 else f"{ours}a kids room"
    return f"{_FAMILY.sub('', rest[:at])} {kids}{rest[at:]}".strip()


def sleepers(text: str) -> list[int] | None:
    """How many children sleep in each of their rooms, the most first; None where a folded text does not tell."""
    told = _told(text)
    return None if told is None else told[0]


def _told(text: str) -> tuple[list[int], str, int] | None:
    """Children by room, the text without them, and where they stood."""
    shared = [one for one in _SHARED.finditer(text) if one[0].isascii() or one["n"] or _TOGETHER.search(one[0])]
    babies = list(_BABIES.finditer(text))
    if not (shared or babies) or COUNTED.search(text) or any(word in text for word in _OTHERS):
        return None
    groups = {kind: 0 for kind in _NOUNS}
    mention = next(_MENTION.finditer(text), None)
    for part in _PART.finditer(mention.group()) if mention else []:
        kind = next((kind for kind in _NOUNS if part[kind]), None)
        if kind:
            groups[kind] += _value(part["count"]) if part["count"] else 2
    alone = [one for one in _ALONE.finditer(text) if not any(_within(one, other) for other in [*shared, *babies])]
    each = list(alone)
    total = sum(groups.values())
    rooms = [max(_of(one, groups), 2) for one in shared]
    rooms += [2 for one in alone if _several(one)]  # "our boys sleep in one room, our girls in another"
    alone = [one for one in alone if not _several(one)]
    single = sum(1 if one["eldest"] or not one["n"] else _value(one["n"]) for one in alone)
    left = total - sum(rooms) - single - (len(babies) if groups["all"] else 0)
    rooms = sorted([*rooms, *[1] * (single + max(left, 0))], reverse=True)
    gone = sorted(shared + babies + each + ([mention] if mention else []), key=lambda one: one.start())
    rest, at = _without(text, gone)
    return (rooms, rest, at) if rooms and not _ELSE.search(rest) else None


def _of(found: re.Match[str], groups: dict[str, int]) -> int:
    """How many share: as is said of them, or where they were counted."""
    kind = next(kind for kind in _NOUNS if found[kind])
    return _value(found["n"]) if found["n"] else 2 if kind == "twins" else groups[kind]


def _value(said: str) -> int:
    said = said.strip()
    return int(said) if said.isdigit() else _ZH.get(said) or numbers().get(said) or 1


def _several(found: re.Match[str]) -> bool:
    """Whether several sleep in `another` room: they share it."""
    nouns = [found[kind] for kind in _NOUNS if found[kind]]
    one = found["n"] is None and nouns and nouns[0] != "fils" and nouns[0].endswith(("s", "sohne", "children"))
    return bool(one) and re.search(r"\b(?:another|other|anderen|autre|otr[oa])\b", found.group()) is not None


def _within(one: re.Match[str], other: re.Match[str]) -> bool:
    return one.start() < other.end() and other.start() < one.end()


def _without(text: str, gone: list[re.Match[str]]) -> tuple[str, int]:
    """A text without some of its clauses, which may overlap, and where the first of them stood."""
    kept, end = "", 0
    for one in gone:
        kept += text[end : one.start()]
        end = max(end, one.end())
    return kept + text[end:], gone[0].start()
