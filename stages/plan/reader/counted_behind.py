"""Rooms counted behind their name: `bedrooms, three of them`, `Bäder, zwei davon`, with the count before it."""

import re

from apartgen.stages.plan.reader.pieces import UNIT, reworded, rules

_N = r"(?P<n>two|three|four|five|six|seven|eight|[2-8])"
_EN = (r"(?P<room>(?:(?:kids'?|children'?s?|guest|double|single|private|en[- ]?suite) )?(?:(?:bed|bath|shower|store|"
       r"storage|guest|dining|living) ?rooms|studies|home offices|offices|balconies|terraces|toilets|wcs|closets|"
       r"baths|kitchens))")  # fmt: skip
_SIZED = (r"(?P<sized>(?:(?:large|small|big|bright|equal|nice|quiet|spacious|tiny|medium(?:-sized)?|good-sized) |"
          rf"\d+(?:[.,]\d+)?(?: ?(?:-|to) ?\d+(?:[.,]\d+)?)? ?-?{UNIT} )*)")
_OF = (r"(?P<of>(?: (?:of|with|at|about|around|measuring|between))*(?: ?(?:(?:at least|about|around|from|to|and|-) ?)*"
       rf"\d+(?:[.,]\d+)? ?(?:{UNIT})?)*(?: each)?)")
_THEM = (r"(?:of (?:them|those|these|it)|in (?:number|total|all)|altogether|overall|total|to be (?:exact|precise)|"
         r"pieces|pcs|units|if possible|all told|thereof|exactly|(?:is|would be) (?:enough|fine|ideal|good))")
_DE_N = r"(?P<n>zwei|drei|vier|funf|sechs|[2-8])"
_DE = (r"(?P<room>(?:kinder|schlaf|gaste|bade|arbeits|dusch|abstell)zimmern?|schlafraume|bader[n]?|balkone[n]?|"
       r"abstellraume|toiletten|wcs)")
_FR_N = r"(?P<n>deux|trois|quatre|cinq|six|[2-8])"
_FR = (r"(?P<room>(?:grandes |petites )?(?:chambres(?: d'enfants?| d'amis)?|salles? de bains?|salles d'eau|bureaux|"
       r"balcons|toilettes|wc))")
_ES_N = r"(?P<n>dos|tres|cuatro|cinco|seis|[2-8])"
_ES = r"(?P<room>(?:dormitorios|habitaciones|banos|aseos|despachos|balcones|terrazas|estudios))"
_JOINT = (r" ?(?:[,;:(]|-+) ?(?:(?:and|i want|we (?:want|need)|there (?:are|should be)|make it|say|und zwar|y son|"
          r"hay) )*")


def _before(found: re.Match[str]) -> str:
    """The count and what is said of size where the other rules know them."""
    said = found.groupdict()
    return f"{said['n']} {said.get('sized') or ''}{said['room']}{said.get('of') or ''}"


_SAID = rules((
    # "10-12 m2 bedrooms, three of them", "bedrooms of 12 m2, three of them", "bedrooms – 3 of them –"
    (r"(?<![a-z\d])(?<!two )(?<!three )(?<!four )(?<!five )(?<!\d )(?:(?:the|some|several) "
     r")?{sized}{en}{of}{joint}{n}(?: {them})+\)?(?: please)?(?: ?-)?(?={end}| and | with | plus |$)", _before),
    (r"(?<![a-z\d])(?:(?:the|some) )?{sized}{en}{of}(?: ?\(|, | - ){n}\)(?={end}| and | with | plus |$)", _before),
    (r"\b{de}(?P<of>(?: (?:von|mit|zu|je|a))*(?: ?\d+(?:[.,]\d+)? ?(?:m2|qm|quadratmeter)?)*){joint}{de_n}(?: "
     r"(?:stuck|davon|an der zahl|insgesamt|derer|von (?:ihnen|denen)))+\)?(?={end}| und | mit | sowie |$)", _before),
    (r"\b{de}(?P<of>(?: (?:von|mit|zu|je|a))*(?: ?\d+(?:[.,]\d+)? ?(?:m2|qm|quadratmeter)?)*), davon {de_n}(?={end}| "
     r"und )", _before),
    (r"\b(?:des |les )?{fr}(?P<of>(?: de)?(?: ?\d+(?:[.,]\d+)? ?m2)*){joint}{fr_n}(?: (?:d'entre elles|au total|en "
     r"tout|en nombre|unites|pieces|exactement))+\)?(?={end}| et | avec |$)", _before),
    (r"\b(?:des |les )?{fr}(?P<of>(?: de)?(?: ?\d+(?:[.,]\d+)? ?m2)*) ?[,;:(] ?il (?:y en a|en faut|m'en faut|nous en "
     r"faut) {fr_n}\)?(?={end}| et | avec |$)", _before),
    (r"\b{es}(?P<of>(?: de)?(?: ?\d+(?:[.,]\d+)? ?m2)*){joint}{es_n}(?: (?:de ell[oa]s|en total|unidades|en numero|"
     r"exactamente))+\)?(?={end}| y | con |$)", _before),
    (r"(?<![间个室])(?P<room>卧室|卫生间|浴室|儿童房|书房|阳台),(?:要|一共|"
     r"共)?(?P<n>[两二三四五2-6])(?P<of>[间个])(?=[,.;]|$)",
     lambda found: f"{found['n']}{found['of']}{found['room']}"),
), n=_N, en=_EN, sized=_SIZED, of=_OF, them=_THEM, joint=_JOINT, de_n=_DE_N, de=_DE, fr_n=_FR_N, fr=_FR, es_n=_ES_N,
   es=_ES)  # fmt: skip


def counted_behind(text: str) -> str:
    """A folded text with such counts before the names of their rooms."""
    return reworded(text, _SAID)
