"""Rules that are read only where a text has a word of theirs: most have none, and no first text is kept waiting."""

from collections.abc import Callable
from functools import cache
from importlib import import_module

from apartgen.stages.plan.reader.patterns import late

_RULES = (
    (late(r"stud(?:y|ie)|estudio"), "studied"),
    (late(r"rather|instead|in (?:place|lieu) of|opposed|prefer|not (?:in )?an? |statt|an ?stelle|plutot|au lieu|a la "
          r"place|en (?:vez|lugar) de|而不是|不要|不需|代替"), "no_room_apart"),
    (late(r"of (?:them|those|these)|in (?:number|total|all)\b|to be (?:exact|precise)|pieces|pcs|units|\(\d\)|"
          r"\((?:two|three|four|five)\)|stuck|davon|an der zahl|insgesamt|elles|au total|en tout|il y en a|faut|"
          r"ell[oa]s|en total|[室间房台],.{0,2}[两二三四五2-6][间个]"), "counted_behind"),
    (late(r"\benter|\bentr(?:y|ance|er|ee|a\b|e\b|a[ds])|front door|(?:main|apartment|flat|house|home) door|comes? in|"
          r"walks? in|on entering|steps? in|(?:tur|eingang) |\bman (?:betritt|kommt|tritt)|la porte|on arrive|la "
          r"puerta|acce[ds]|入户|大门|正门|入口|进门|进户|进屋"), "one_enters"),
    (late(r"between|middle|midway|halfway|zwischen|\bentre\b|medio|milieu|中间|之间|当中"), "between_them"),
    (late(r"\bapart\b|separ|\bsplit|own room|on its own|by itself|getrennt|\bextra|aparte|a part\b|independ|分开|分离|"
          r"独立"), "toilets_apart"),
    (late(r"\b(?:at|into|on|to|inside|next of|of|for|in|by) (?:the )?(?:[a-z']+ ){0,2}(?:bed ?)?room|\bmaster\b|(?:at|"
          r"into|on|to|inside|next) (?:of )?(?:the )?(?:kitchen|lounge|study|entrance)|balcon|terrasse|阳台|露台"),
     "odd_places"),
    (late(r"famil|every(?:one|body)|nobody|no one|none of|per (?:person|head)|for (?:each|every)|of us|room each|"
          r"equal|same|identical|alike|gleich|\bpro person|\bpar personne|por persona|\bsomos|\bwg\b|meme|egal|igual|"
          r"mismo|每个?人|人人|一样|相同|(?:habitaciones|dormitorios|cuartos) (?:de|para|infantil)"), "each_own"),
    (late(r"shar(?:e|ing)|sleep|together|in one (?:bed ?)?room|(?:with|in with) us|in our|schlaf(?:en|t) |teilen|"
          r"dor(?:t|ment) |partagent|duerme|comparten|一起|合住|共用|[住睡]"), "siblings"),
    (late(r"dining|eating|breakfast|to eat|for meals|ess(?:platz|ecke|bereich|nische)|sitzecke|repas|coin|diario|"
          r"desayunador|para comer|comedor|餐区|用餐角"), "eating_places"),
    (late(r"\bopen|\bdoor|keine tur|porte entre|puerta entre|(?:flat|apartment|house|home) \d|"
          r"\ball\b|everything|whole|entire|combined|together|total|in sum|kitchen ?[-/+]|[-/+] ?kitchen"),
     "specified"),
    (late(r"office [a-z ]+[:-]|ensuite|en[ -]suite|(?:separat|divid|part|off)[a-z]* .*door|door "
          r"(?:.*(?:separat|divid|part)|between)|(?:end|side)s? of"), "briefly"),
    (late(r"studio|(?:one|single) (?:[a-z]+ )?room"), "bed_sitters"),
    (late(r"and (?:i|we)\b|shower (?:instead|rather|and no)|\bis for\b|\bbureau|"
          r"with (?:[a-z]+ )?chairs|\b(?:fetch|pick|bring|take|carry|move|grab|get|"
          r"deliver|put|place|find|collect|navigate|drop|return|retrieve)\b|"
          r"[卧房厅厨阳玄].*?, ?.{0,8}[有放摆配带]"), "things_told"),
)  # fmt: skip
"""Words of which one stands in every text that a module changes; the module, whose function has the same name."""


def on_occasion(text: str) -> str:
    """A folded text in the words of those rules whose words it has."""
    for words, name in _RULES:
        if words.search(text):
            text = _rule(name)(text)
    return text


@cache
def _rule(name: str) -> Callable[[str], str]:
    rule: Callable[[str], str] = getattr(import_module(f"apartgen.stages.plan.reader.{name}"), name)
    return rule
