"""What stands where a room of its own might be: `a desk in the bedroom rather than a separate room`, no room then."""

from apartgen.stages.plan.reader.pieces import reworded, rules

_RATHER = r"(?:rather than|instead of|in (?:place|lieu) of|as opposed to|in preference to|not|and not|but not)"
_OWN = r"(?:separate|own|extra|dedicated|additional|individual|special|second|different|whole|proper|another)"
_PLACE = (r"(?:desks?|tables?|work ?(?:space|station|place|area|corner)s?|dining (?:table|area|corner)s?|washing "
          r"machines?|washers?|dryers?|book ?(?:case|shel(?:f|ves))s?|piano|sofa ?beds?|wardrobes?|freezer|treadmill)")
_SAID = rules((
    # "a workspace in the bedroom rather than an office": a desk
    (r"\b(?:an? |the |my |our )?(?:(?:small|little|home) )?(?:work ?(?:space|station|place|area|corner|nook)|(?:home "
     r")?office (?:corner|nook|area)|place to work|place for work(?:ing)?)(?P<where> (?:in|within) (?:the |my |our |"
     r"an? )?{kind}),? {rather} (?:in )?(?=an? )", r"a desk\g<where> instead of "),
    # "a dining area in the living room as opposed to a separate dining room": a table
    (r"\b(?:an? |the )?(?:dining|eating) (?:area|corner|nook|space)(?P<where> (?:in|within) (?:the |my |our |an? "
     r")?{kind}),? {rather} (?:in )?(?=an? )", r"a dining table\g<where> instead of "),
    # "…, not in a separate study"
    (r"(?P<thing>\b{place}(?: (?:is|are|goes|go|stands?|should be|must be|will be|placed))? (?:in|within) (?:the |my |"
     r"our |an? |each |one )?{kind}),? (?:and |but )?not (?:in )?(?:an? |any )?(?=(?:{own} )?{kind})",
     r"\g<thing> instead of a "),
    (r"\b(?:in lieu of|as opposed to|in preference to) (?=(?:an?|any|the) )", "instead of "),
    # "I'd rather have the desk in my bedroom than a separate study", "instead of in a separate study"
    (r"\brather (?P<said>(?:have |put |use |keep )?(?:the |an? |my |our )?{place} (?:in|within) (?:the |my |our |an? "
     r")?{kind}) than (?:in )?(?=an? )", r"\g<said> instead of "),
    (r"\b(?:rather than|instead of) (?:having (?:it|them) |putting (?:it|them) )?in an? (?=(?:{own} )?{kind})",
     "instead of a "),
    (r"\b(?:an)?statt in eine[mr] (?=(?:{own_de} )?{de})", "statt eines "),
    (r"\b(?:plutot que|au lieu d'etre) dans (?=une? (?:{fr}))", "au lieu d'"),
    (r"\ben (?:vez|lugar) de en (?=una? (?:{es}))", "en lugar de "),
    # "rather than a separate room": nothing is named that there might be
    (r",? {rather} (?:(?:in|having|building|using|with|to have|on) )?(?:(?:an?|any|its|their|the) )?(?:{own} "
     r")+(?:room|space|place)s?(?: (?:for (?:it|that|this|them|work|working|dining|the [a-z]+)|of its own|of their "
     r"own))?(?={end}| and | with )", ""),
    (r",? (?:an)?statt (?:in )?eine[smr] (?:(?:separate|eigene|extra|getrennte|zusatzliche)[nms]? )?(?:zimmers?|"
     r"raum(?:e?s)?)\b", ""),
    (r",? an ?stelle (?:von )?eine[smr] (?:(?:separate|eigene|getrennte|zusatzliche)[nms]? )?(?:zimmers?|"
     r"raum(?:e?s)?)\b", ""),
    (r",? (?:et non |plutot |au lieu |a la place )(?:pas )?(?:dans |qu'|que |d')*une (?:autre )?(?:piece|chambre)(?: "
     r"(?:separee|a part|dediee|supplementaire|distincte|independante))?(?={end}| et )", ""),
    (r",? en (?:vez|lugar) de (?:en )?un(?:a habitacion| cuarto) (?:separad[oa]|aparte|propi[oa]|independiente|"
     r"extra)(?={end}| y )", ""),
    # "而不是单独的书房"
    (r"[,;]?(?:而)?(?:不要|不是|不需要?|没有|无需|不设)(?:一?[个间])?(?:单独|独立|另外|专门|"
     r"额外)的?(?:一?[个间])?(?P<room>房间)", ""),
    (r"[,;]?(?:而)?(?:不要|不是|不需要?|没有|无需|不设)(?:一?[个间])?(?:单独|独立|另外|专门|"
     r"额外)的?(?:一?[个间])?(?P<room>书房|餐厅|洗衣房|办公室|衣帽间)", r",没有\g<room>"),
), rather=_RATHER, own=_OWN, place=_PLACE, own_de=r"(?:separate|eigene|extra|getrennte|zusatzliche)[nms]?")  # fmt: skip


def no_room_apart(text: str) -> str:
    """A folded text without rooms that there are not to be."""
    return reworded(text, _SAID)
