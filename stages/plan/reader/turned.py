"""Clauses in an order the rules do not follow, and adverbs that part a verb from its room, in words they know."""


from apartgen.stages.plan.reader.patterns import late

_ROOM_EN = r"(?:the |an? |our |my )?[a-z'-]+(?: (?:room|hall|closet|wc))?"
_ROOM_DE = r"(?:de[rmn] |die |das )?[a-z-]+"
_ROOM_FR = r"(?:la |le |les |l')[a-z-]+(?: (?:de |d'|a )(?!cote)[a-z]+)?"
_ROOM_ES = r"(?:el |la |los |las )[a-z]+(?: de [a-z]+| principal)?"
_ROOM_ZH = r"[^,.;:和与跟之间]{1,6}"
_BE = r"(?:there )?(?:is|are|must|should|shall|may|can|will|has|have)? ?(?:to )?(?:there )?(?:be )?"
_END = r"(?= ?(?:[.,;:!)]|$|and |but |so |und |et |y |because ))"
_MORE = r"bed ?room|bath ?room|toilet|wc|balcony|study|room|shower room|store ?room|storage room|closet|terrace|office"
_VERB = ("flows?|opens?|leads?|connects?|runs?|merges?|blends?|extends?|goes|go|spills?|passes|gives|"
         "open|opening|flowing|leading|connected|linked|joined|attached|accessible|reachable|reached|entered|next|"
         "adjacent|close")  # fmt: skip
_SAID = [(late(pattern), words) for pattern, words in (
    # "flows openly into the kitchen", "is connected seamlessly to it"
    (rf"\b({_VERB}) (?!only\b|solely\b|merely\b|simply\b|exclusively\b|family\b)[a-z]+ly (?=(?:in|on)?to |from |off |"
     r"with |via |through )", r"\1 "),
    # "Between kitchen and bathroom should not be a door", "… there is no door"
    (rf"\bbetween ({_ROOM_EN}) and ({_ROOM_EN}),? {_BE}(?:no|not|without)(?: be| have)?(?: an?| any)? "
     rf"(?:direct |connecting )?doors?(?: be)?{_END}", r"no door between \1 and \2"),
    (rf"\bzwischen ({_ROOM_DE}) und ({_ROOM_DE}) (?:(?:soll|sollen|darf|durfen|muss|ist|sind|gibt|gabe|braucht)(?: es)? "
     rf")?keinen? (?:direkten? )?(?:verbindungs)?tur(?:en)?(?: (?:sein|geben|bestehen))?{_END}",
     r"keine tur zwischen \1 und \2"),
    (rf"\bentre ({_ROOM_FR}) et ({_ROOM_FR}),? (?:(?:il )?(?:n'y a|ne doit pas y avoir|ne doit y avoir|n'y aura) ?)?"
     rf"(?:pas de|aucune|sans|de) (?:porte|communication)s?{_END}", r"pas de porte entre \1 et \2"),
    (rf"\bentre ({_ROOM_ES}) y ({_ROOM_ES}),? no (?:(?:debe|puede|tiene que|ha de|quiero que)(?: haber)?|hay|haya|habra) "
     rf"?(?:ninguna |una )?puertas?{_END}", r"ninguna puerta entre \1 y \2"),
    # "one toilet more", "two bedrooms more"
    (rf"\b(one|two|three|an?|\d) ((?:small |big |large |guest |separate )?(?:{_MORE})s?) more{_END}", r"\1 more \2"),
    # "weder im Wohnzimmer noch im Flur"
    (r"\bweder ([^.;:]+?) noch ", r"neither \1 nor "),
    # "I hear everything", of no room
    (rf"\b(i|we|he|she|they|you|one|who) ((?:can |will |could )?(?!want|need|have|put|keep)[a-z]+) everything{_END}",
     r"\1 \2"),
)]  # fmt: skip


def turned(text: str) -> str:
    """A folded text with such clauses in the usual order."""
    for pattern, words in _SAID:
        text = pattern.sub(words, text)
    return text
