"""Places to eat in a kitchen, a table there and no dining room: `kitchen with a dining area`, `coin repas`."""

from apartgen.stages.plan.reader.pieces import reworded, rules

_KITCHEN = r"(?P<in>(?<!open )(?<!open-plan )\bkitchens?(?: of (?:about )?\d+ ?(?:m2|sqm))?)"
_SMALL = r"(?:(?:small|little|large|big|cosy|cozy|nice|proper|informal|built-in|sunny) )*"
_PLACE = (r"(?:(?:dining|eating|breakfast) (?:area|place|space|corner|nook|spot|zone)|"
          r"(?:place|space|spot|corner|area) (?:to|for) (?:eat|dine|eating|dining|meals))")  # fmt: skip
_SAID = rules((
    # "kitchen with a dining area", "the kitchen has a place to eat"; one of a measured area is told as it was
    (r"{in}(?P<has>,? (?:that )?(?:with|has|have|having|including|should have|must have|needs))"
     r" (?:an? |some |its own )?{small}{place}"
     r"(?P<for>,? (?:for|with seats for|that seats|seating) (?=(?:two|three|four|five|six|eight|\d)\b))?"
     r"(?! (?:of|open|next|between|and a dining))",
     lambda found: f"{found['in']}{found['has']} a dining table{' for ' if found['for'] else ''}"),
    (r"\b(?:an? )?{small}{place} in the kitchen(?={end}| and | for | with )", "a dining table in the kitchen"),
    # "Küche mit Essplatz"
    (r"(?P<in>\b(?:wohn)?kuche) mit (?:einem |einer |kleine[mr] |grosse[mr] |eigene[mr] |gemutliche[mr] |"
     r"integrierte[mr] )*(?:essplatz|essecke|essbereich|essnische|sitzecke)", r"\g<in> mit esstisch"),
    (r"\b(?:ein(?:en|e)? )?(?:essplatz|essecke|essbereich|essnische) in der kuche\b", "ein esstisch in der kuche"),
    # "cuisine avec coin repas"
    (r"(?P<in>\bcuisine(?: [a-z]+)?) avec (?:un |une |son )?(?:petit |grand )?(?:coin[ -](?:repas|a manger)|"
     r"espace repas|table de repas)", r"\g<in> avec une table a manger"),
    (r"\b(?:un )?coin[ -]repas dans la cuisine\b", "une table a manger dans la cuisine"),
    # "cocina con comedor de diario"
    (r"(?P<in>\bcocina) (?:con|y) (?:un |su )?(?:pequeno )?(?:comedor (?:de )?diario|desayunador|comedor auxiliar|"
     r"(?:zona|area|rincon|espacio) (?:de comedor|de comer|para comer))", r"\g<in> con mesa de comedor"),
    (r"厨房(?:里|内)?(?:带|有|要有|设)(?:一?个)?(?:小)?(?:用餐区|就餐区|餐区|用餐角)", "厨房里放一张餐桌"),
), **{"in": _KITCHEN, "small": _SMALL, "place": _PLACE})  # fmt: skip


def eating_places(text: str) -> str:
    """A folded text with a dining table in such kitchens."""
    return reworded(text, _SAID)
