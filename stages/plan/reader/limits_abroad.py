"""Limits of areas and lengths in French, Spanish and German as English ones: `no puede medir más de 4 m de largo`."""

import re

from apartgen.stages.plan.reader.pieces import reworded, rules

_N = r"(?P<n>\d+(?:[.,]\d+)?)"
_UNIT = (r" ?(?P<unit>m2|m 2|metros? cuadrados?|metres? "
         r"carres?|quadratmetern?|qm|metros?|metres?|meter|m|cm|centimet(?:"
         r"ros|res))\b")  # fmt: skip
_ALONG = (r"(?: (?:de|en) (?P<along>largo|larga|longitud|ancho|anchura|ancha|long|longueur|large|largeur)|"
          r" (?P<wie>lang|breit)\b)?")  # fmt: skip
_ES_BE = (r"(?:(?:puede|pueden|debe|deben|debera|podra|tiene que|ha de|tenga que) )?"
          r"(?:(?:ser|medir|tener|mida|tenga|sea|mide|es) )?")  # fmt: skip
_FR_BE = (r"(?:(?:doit|doivent|peut|devra|pourra) (?P<pas>pas "
          r")?)?(?:(?:etre|mesurer|faire|avoir|mesure|fait|fasse|est) "
          r"(?P<pas2>pas )?)?")  # fmt: skip


def _limit(found: re.Match[str]) -> str:
    """Of a room before it: `is at most 4 m long`; Spanish `largo` is long, French `large` wide."""
    said = found.groupdict()
    unit, along = said["unit"], (said.get("along") or said.get("wie") or said.get("how") or "").strip()
    square = unit.startswith(("m2", "m 2", "qm", "quadrat")) or "cuadrad" in unit or "carre" in unit
    long = along.startswith(("long", "lang", "cort", "court")) or (bool(said.get("es")) and along.startswith("larg"))
    short = "m2" if square else "cm" if unit.startswith("c") else "m"
    side = "" if square or not along else " long" if long else " wide"
    return f" is at {'least' if said.get('less') else 'most'} {found['n']} {short}{side}"


_SAID = rules((
    # "no puede medir más de 4 metros de largo", "no debe ser más largo de 4 m", "no debe superar los 4 m"
    (r" (?P<es>no) {es_be}(?:(?:mas(?: (?P<how>larg[oa]|anch[oa]|grande))?|mayor) "
     r"(?:de|que)|(?:superar|supere|supera|exceder|exceda|"
     r"excede|sobrepasar|sobrepase|pasar|pase|pasa)(?: de)?)(?: los)? {n}{unit}{along}", _limit),
    (r" (?P<es>no) {es_be}(?P<less>(?:menos|menor|mas (?P<how>estrech[oa]|cort[oa]|pequen[oa])) (?:de|que))(?: "
     r"los)? {n}{unit}{along}", _limit),
    (r" (?P<es>(?:debe|deben|tiene que|ha de|puede|debera)) (?:ser |medir |tener |de )*(?P<less>al menos|como "
     r"minimo|por lo menos|minimo|mas "
     r"de) (?:de )?{n}{unit}{along}", _limit),
    (r" (?P<es>(?:debe|deben|tiene que|ha de|puede|debera)) (?:ser |medir |tener |de )*(?:como maximo|a lo "
     r"sumo|maximo|menos de) (?:de )?{n}{unit}"
     r"{along}", _limit),
    (r" de {n}{unit}{along} (?P<es>como|a lo) maximo\b", _limit),
    (r" de {n}{unit}{along} (?P<es>como) (?P<less>minimo)\b", _limit),
    # "ne doit pas faire plus de 4 m de long", "ne doit pas dépasser 4 m"
    (r" ne {fr_be}(?:pas )?(?:plus (?:(?P<how>longu?e?|larges?|grande?) )?(?:de|que)|(?:depasser?|exceder?)(?: "
     r"pas)?)(?: les)? {n}{unit}{along}",
     _limit),
    (r" ne {fr_be}(?:pas )?(?P<less>(?:moins|plus (?P<how>courte?|etroite?|petite?)) "
     r"(?:(?:longu?e?|larges?|grande?) )?(?:de|que)) {n}{unit}{along}",
     _limit),
    (r" (?:doit|devra) (?:mesurer|faire|avoir|etre)(?: d')? ?(?P<less>au moins|au minimum|plus de) "
     r"{n}{unit}{along}", _limit),
    (r" (?:doit|devra) (?:mesurer|faire|avoir|etre)(?: d')? ?(?:au plus|au maximum|moins de) {n}{unit}{along}", _limit),
    # "soll nicht mehr als 4 m lang sein"
    (r" (?:darf|soll|sollte|muss) (?:nicht (?:mehr|langer|breiter) als|maximal|hochstens) {n}{unit}(?P<wie> "
     r"lang| breit)(?: sein)?\b",
     _limit),
), n=_N, unit=_UNIT, along=_ALONG, es_be=_ES_BE, fr_be=_FR_BE)  # fmt: skip


def limits_in_english(text: str) -> str:
    """A folded text with such limits in English."""
    return reworded(text, _SAID)
