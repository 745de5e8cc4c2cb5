"""What lies between two rooms just named, said before it: `two bedrooms and, in between them, a bathroom`."""

from apartgen.stages.plan.reader.pieces import KIND, reworded, rules

_LIES = (r"(?:(?:is|are|lies|sits|goes|stands|comes|set|placed|located|situated|sandwiched|wedged|squeezed|tucked|"
         r"nestled|positioned|with|and|exactly|right|directly) )*")  # fmt: skip
_THEM = (r"(?:in[ -]?between(?: (?:them|these|those|both|the two|the 2|the bedrooms|the rooms))?|between (?:them|"
         r"these|both|the two))")  # fmt: skip
_ONE = rf"(?P<room>(?:the|an?|one|our|their)(?: (?:shared|common|small|single|large))* {KIND})"
_TWO_ZH = r"(?P<two>[两二2][间个](?:卧室|房间|儿童房|次卧))"
_SAID = rules((
    # "two bedrooms and in between them a bathroom", "…, sandwiched between them, the bathroom"
    (r"(?P<two>\b(?:two|both|2) (?:[a-z']+ )?{kind}s?|{kind} and (?:an? |the )?{kind})(?:[,;:]? and|[,;.:] ?| "
     r"with|,)+ ?{lies}{them},? {lies}{one}(?={end}| with | and )", r"\g<two>, \g<room> in between"),
    # "the bathroom sits sandwiched between them", "in the middle between them"
    (r"\b(?:sandwiched|wedged|squeezed|tucked|nestled) (?=(?:in[ -]?)?between\b)", ""),
    (r"\b(?:in the middle|midway|halfway|right in the middle|centrally),? (?=(?:in[ -]?)?between\b)", ""),
    (r"\b(?:in the middle|midway|halfway) of (?:them|the two|both|the two bedrooms|both bedrooms)\b", "in between"),
    # "zwei Schlafzimmer, dazwischen das Bad"
    (r"\b(?:und |mit )?(?:dazwischen|zwischen (?:ihnen|beiden|den beiden)|in der mitte dazwischen)(?: liegt| ist| "
     r"kommt| befindet sich| soll)? (?P<room>(?:das|ein|eine|die|der|dem|einem) (?:gemeinsame[sn]? )?{de})(?: liegen| "
     r"sein)?(?={end}| und | mit )", r"mit \g<room> dazwischen"),
    # "dos dormitorios con el baño en medio", "entre medias"
    (r"(?P<two>\b(?:dos|2) {es}s?(?: [a-z]+?)?,? (?:y |con )?(?:el|un|la|una) {es})(?: (?:est[ae]|situado|queda|va))? "
     r"(?:en medio|entre medias|en el medio|por medio)(?: de (?:ellos|ambos|los dos))?\b", r"\g<two> entre ellos"),
    (r"(?P<two>\b(?:dos|2) {es}s?(?: [a-z]+?)?)(?:,| y|, y) (?:entre (?:ellos|ellas|ambos|los dos)|en medio),? "
     r"(?P<room>(?:el|un|la|una) {es})", r"\g<two> con \g<room> entre ellos"),
    # "deux chambres et, entre elles, la salle de bain", "au milieu"
    (r"(?P<two>\b(?:deux|2) {fr}s?(?: [a-z]+?)?)(?:,| et| avec|, et)+,? (?:entre (?:elles|les deux|eux)|au milieu),? "
     r"(?P<room>(?:la |le |une? |l'){fr})", r"\g<two> avec \g<room> entre les deux"),
    # "两间卧室,中间是卫生间"
    (r"{two_zh},?(?:在)?(?:它们|两者|两间)?(?:的)?(?:中间|之间)(?:是|有|夹着|为|放)一?[个间]?(?P<room>{zh})",
     r"\g<two>,\g<room>在两间卧室之间"),
    (r"{two_zh},(?P<room>{zh})(?:夹?在|位于|放在|处于)(?:它们|两者|两间|中)?的?(?:中间|之间|当中)",
     r"\g<two>,\g<room>在两间卧室之间"),
), lies=_LIES, them=_THEM, one=_ONE, two_zh=_TWO_ZH)  # fmt: skip


def between_them(text: str) -> str:
    """A folded text with such rooms before the words that say where they lie."""
    return reworded(text, _SAID)
