"""Studies that are research: `an interaction study`, `our study compares two robots`, no room of any home."""

from apartgen.stages.plan.reader.pieces import reworded, rules

_TOPIC = (r"(?:hri|hci|user|users|case|usability|research|field|pilot|lab|laboratory|perception|navigation|robots?|"
          r"robotics|manipulation|accessibility|feasibility|longitudinal|cohort|clinical|ablation|simulation|"
          r"empirical|comparative|comparison|observational?|ergonomics?|behaviou?r(?:al)?|cognitive|cognition|"
          r"psycholog(?:y|ical)|ageing|aging|dementia|design|wayfinding|eye[- ]tracking|human(?:[- ]factors|"
          r"[- ]robot(?:[- ]interaction)?)?|interaction|preference|embodied(?: ai)?|scientific|academic|doctoral|"
          r"ethnographic|evaluation|exploratory|preliminary|follow-up|(?:within|between)-subjects?|wizard-of-oz|"
          r"in-home|motion|gait|housing|care|telepresence|assist(?:ance|ive))")  # fmt: skip
_HOME = (r"(?:(?:[a-z0-9]+[- ]){0,4}?(?:flat|apartment|home|house|studio|layout|floor ?plan|scene|environment|"
         r"bed(?:room)?s?)\b)")  # fmt: skip
_ASKS = (r"(?:compares?|investigates?|examines?|looks? (?:at|into)|aims?|involves?|explores?|evaluates?|measures?|"
         r"concerns?|focus(?:es)?|asks? (?:how|whether|people|participants|users)|tests? (?:how|whether|if|robots?|"
         r"two|the|a)|is about|deals? with|studies|will (?:test|compare|examine|investigate|evaluate|run))")
_THEY = (r"(?:an? (?:[a-z]+ )?robots?|robots?|participants|subjects|people|users|volunteers|agents?|we (?:test|"
         r"compare|ask|observe|measure|evaluate|investigate|examine|look|let|study|have robots|have people)|the "
         r"(?:robots?|participants|agents?|users|subjects))\b")  # fmt: skip
_SAID = rules((
    # "an interaction study", "HRI studies"
    (r"\b(?:(?:an?|our|my|the|this) )?(?<!for a )(?<!for an )(?<!for our )(?<!for my )(?<!for the )"
     r"(?:{topic}[ -](?:and )?)+stud(?:y|ies)\b(?! ?-?rooms?\b| of \d)", "research"),
    # "study participants", "the participants of our study"
    (r"\bstudy (participants?|subjects?|volunteers?|protocol|design|conditions?|sessions?)\b", r"research \1"),
    (r"\b(participants|subjects|volunteers) (of|in|for) (?:our|the|this|my|a) study\b", r"\1 \2 our research"),
    # "in our study, a robot fetches things", "the study compares two robots"
    (r"\b(in|for|during|throughout) (?:our|my|the|this|an?) (?:[a-z-]+ )?study,? (?=(?:where |in which )?{they})",
     r"\1 our research "),
    (r"\b(?:our|my|the|this|an?) (?:[a-z-]+ )?study {asks}\b", "our research on"),
    (r"\b(?:our|my|the|this|an?) (?:[a-z-]+ )?study (?=(?:requires?|needs?|uses?|takes place in|is set in|happens in|"
     r"runs in|wants?) (?:an? |the |two |three |several |\d+ )?{home})", "our research "),
    # "eine Studie zur Navigation", "una investigación"
    (r"\b(?:(?:eine?r?|unsere?r?|die|der) )?(?:[a-z]+-?)?studien?\b(?! ?-?raum)", "research"),
    (r"\bestudios? (?=(?:de (?:usuarios?|usabilidad|interaccion|casos?|campo|navegacion|investigacion|mercado|robots?|"
     r"percepcion|manipulacion|comportamiento|accesibilidad|personas)|sobre|piloto|cientificos?|clinicos?|"
     r"longitudinal(?:es)?|comparativos?|empiricos?)\b)", "investigacion "),
), topic=_TOPIC, home=_HOME, asks=_ASKS, they=_THEY)  # fmt: skip


def studied(text: str) -> str:
    """A folded text with such studies as research."""
    return reworded(text, _SAID)
