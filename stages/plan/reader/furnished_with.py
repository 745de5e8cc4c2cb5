"""Furniture and rooms in words that mean others: four-poster beds, laundry closets, `barely big enough to turn in`."""

from apartgen.stages.plan.reader.pieces import reworded, rules

_SAID = rules((
    # "a bed with four posters", "a four-poster", "a canopy bed": one bed
    (r"\b(?:four|4)[ -]?post(?:er|ed)s?(?: (?:double|king|queen)(?:[ -]size)?)?(?: beds?)?\b|\bcanopy beds?\b|"
     r"\b(?:double )?bed with (?:four|4) posts(?:ers)?\b", "double bed"),
    (r"\bhimmelbett(?:en)?\b", "doppelbett"), (r"\blits? a baldaquin\b", "lit double"),
    (r"\bcamas? con dosel\b", "cama doble"),
    # "a three-seater sofa", "a two-door wardrobe": one of them, and not said of doors
    (r"\b(an? )(?:two|three|four|five|six|eight|[2-8])[ -](?:seater|seat|door|drawer|burner|tier)s? "
     r"(?=(?:[a-z]+ )?(?:sofa|couch|settee|wardrobe|closet|dresser|chest|sideboard|cabinet|cupboard|stove|cooker|hob|"
     r"fridge|bookcase|bookshelf|dining table|table)\b)", r"\1"),
    # "in-unit laundry closet", "washer/dryer closet"
    (r"\b(?:in|on)[ -](?:unit|site),? (?=laundry (?:closet|cupboard|nook|alcove|room))", ""),
    (r"\b(?:laundry|washer|washing machine|w/d)(?: ?(?:/|and|&) ?dryer)? (?:closet|cupboard|nook|alcove)\b",
     "laundry closet"),
    # "bath 4 meters": no tub
    (r"\bbath(?=(?: of| is| ?:)? ?{amount} ?(?:m|met(?:er|re)s?)\b(?! ?(?:x|by|wide|long|tub|deep)\b))", "bathroom"),
    # "wants a kitchen of 100 sqft total house 90 m2": the room's and the home's
    (r"({amount} ?{unit}\.?),? (?:and )?(?:the )?(?:total|whole|entire|overall)(?: (?:house|home|flat|apartment|area|"
     r"size|floor|floor area))*(?: is| "
     r"of|:| will be)?"
     r" (?=(?:(?:about|maybe|around|approx\.?|roughly|some|perhaps) )*{amount} ?{unit})", r"\1; total area "),
    # "a bedroom with the bathroom inside"
    (r"\b(bed ?room)(?: ?\(|,? )(?:(?:with|has|having) )?(?:(?:an?|the|its) )?(?:own )?(?:bath ?room|shower room|bath) "
     r"inside(?: it)?\)?(?= ?[.,;]| ?$| and )", r"\1 with its own bathroom"),
    # "a kitchen barely big enough to turn around in"
    (r"(?P<room>{room}),?(?: (?:(?:that|which) )?(?:is|are)| being)? (?:(?:barely|hardly|scarcely|only just) (?:big|"
     r"large|"
     r"wide|spacious|roomy) enough|just (?:big|large|wide) enough(?= to turn))(?: to [a-z' ]{1,30}?"
     r"(?={end}| and )| for (?:one|two|three|\d|me|us)\b(?: people| persons| of us)?)?(?![a-z-])", r"small \g<room>"),
))  # fmt: skip


def furnished_with(text: str) -> str:
    """A folded text with such rooms and furniture in the words that the rules know."""
    return reworded(text, _SAID)
