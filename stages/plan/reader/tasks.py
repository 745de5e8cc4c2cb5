"""What is no room and no furniture though its words are: tasks of robots, people who are living somewhere."""

import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import reworded

_DOING = (r"(?:making|folding|cleaning|washing|setting|clearing|opening|closing|sorting|loading|unloading|fetching|"
          r"finding|"
          r"tidying|watching|serving|vacuuming|mopping|sweeping|ironing|drying|dusting|wiping|rearranging|"
          r"rearrangement|"
          r"assembly|search|navigation|delivery|loading|polishing)")  # fmt: skip
_NOUN = (r"(?:bed|laundry|dish|dishes|table|window|door|drawer|sofa|chair|kitchen|bathroom|toilet|shelf|shelves|fridge|"
         r"cabinet|wardrobe|clothes|bed ?room|living room|utility room|pantry|floor|room|furniture|lamp|book|books|cup|"
         r"plant|dishwasher|carpet|rug)")  # fmt: skip
_WHAT = (r"(?:robots?|tasks?|agents?|benchmarks?|demos?|scenes?|experiments?|stud(?:y|ies)|tests?|missions?|skills?|"
         r"episodes?|"
         r"policy|policies|arm|humanoid|challenge|trials?|work|practice|training|data ?sets?)")  # fmt: skip
_SCENE = r"(?:environment|scene|scenario|simulation|world|level|map|setting|layout|task)"
_A_ROOM = r"an? (?:[a-z]+ )?(?:kitchen|bath ?room|bed ?room|living room|study|dining room|lounge)\b"
_SKILL = (r"(?:manipulation|grasping|exploration|perception|interaction|locomotion|mapping|planning|robots?|agents?|"
          rf"{_DOING})")  # fmt: skip
_MANY_ROOMS = (r"(?:kitchens|bath ?rooms|bed ?rooms|living rooms|dining rooms|hallways|corridors|halls|studies|offices|"
               r"laundry rooms|storage rooms)")  # fmt: skip
_THEY = (r"(?:i|we|he|she|they|(?:both|all) of us|(?:my|our) [a-z]+)"
         r"(?: (?:both|all|each|only|often|usually|always|mostly|still|just|now|can|will))*")  # fmt: skip
_AWAY = r"(?:the |an? |my |our |his |her |their )?(?:office|gym|library|cinema|workshop)"
_DOWNTOWN = r"(?: (?:downtown|in town|in the city|elsewhere|across town|outside|abroad))"
_THERE_ENDS = (r"(?= ?(?:[.,;:!?]|$)| (?:every|each|daily|on|during|for work|to work|and|so|anyway|instead|most|"
               r"twice|once|all|in the (?:morning|evening))\b)")  # fmt: skip
_SAID = [(late(pattern), words) for pattern, words in (
    # "I play the piano, so a living room big enough for a grand piano"
    (r"\b(i|we|she|he) (?:also )?plays? (?:the )?(?:piano|guitar|violin|cello|drums),? so (?:(?:i|we) "
     r"(?:want|need|would like) )?(?=(?:an?|the) )", r"\1 want "),
    # "for a bed-making robot", "for a laundry folding task"
    (rf"(?<!-)\b{_NOUN}[- ]{_DOING}(?:[- ](?:and|or|&)[- ]{_DOING})? (?={_WHAT}\b)", ""),
    (rf"\b(?:for|to test|to train|to learn|a test of|about) {_NOUN}[- ]{_DOING}(?= ?[:,.;]| with )", "for research"),
    # "Long-horizon laundry task. One-bedroom flat with a utility room"
    (rf"^(\W*(?:[a-z]+[ -]){{0,3}}?)(?<!-){_NOUN}(?:[- ]{_DOING})? "
     r"((?:task|benchmark|scenario|episode|experiment|mission|challenge|demo|test|trial)s?)"
     r"(?=(?: only)? ?[.:;-])", r"\1\2"),
    # "my wife teaches piano, … a piano in the study": one of them
    (r"\b(teach|play|practi[cs]e?|learn|stud)(e?s|ies|y|ing)? (?:the )?piano\b(?=.*\bpiano\b)", r"\1\2 music"),
    # "Single-room environment: a kitchen of 14 m2", "one room only: a kitchen"
    (rf"(?:\b(?:an? )?(?:single|one)[- ]room {_SCENE}(?: for [^:.;,]*(?=:))?|\b(?:an? )?{_SCENE} (?:of|with) "
     rf"(?:just |only )?(?:an?|one) (?:single )?room(?= ?[:,]))(?: ?[:,-]| with| of)? (?={_A_ROOM})", "only "),
    (rf"(?:^|(?<=[.;!] ))(?:just |only )?(?:an?|one) (?:single )?room(?: only)? ?: ?(?={_A_ROOM})", "only "),
    # "we evaluate manipulation in kitchens"
    (rf"\b{_SKILL}(?: (?:tasks?|skills?|policies))? in (?:(?:real|simulated|small|large|realistic|domestic|different|"
     rf"various|many) )*{_MANY_ROOMS}(?: and {_MANY_ROOMS})?(?= ?(?:[.,;:!?]|$))", ""),
    # "no study, we both go to the office", "my wife works at the office", "in an office downtown"
    (rf"\b{_THEY} (?:go(?:es)?|commutes?|drives?|travels?|cycles?) (?:back |out )?(?:in)?to {_AWAY}{_DOWNTOWN}?"
     rf"{_THERE_ENDS}", ""),
    (rf"\b{_THEY} works? (?:at {_AWAY}{_DOWNTOWN}?|(?:in|from) {_AWAY}{_DOWNTOWN}){_THERE_ENDS}", ""),
    # "a dog bed in the living room": no bed, and no thing that is known
    (r"\b(dog|cat|pet)(?:'s)?[ -](bed|basket|couch|sofa|table|chair)(s?)\b", r"\1\2\3"),
    # "Co-op apartment for two players", "Task: …", "nodes: …"
    (r"\bco-?op (?=(?:flat|apartment|home|house|game|map|level)\b)", ""),
    (r"\bfor (?:one|two|three|four|five|six|[1-6])(?: to (?:two|four|six|eight|[2-8]))? players\b", "for players"),
    (r"(?:^|(?<=[.;\n] )|(?<=\n))(?:task|nodes|vertices|query) ?: ?", ""),
    # "our grandfather is living with us"
    (r"\b(is|are|am|was|were|be|who|that|[a-z]+) living (?=(?:with (?:us|me|my|our|him|her|them)|together|alone|in "
     r"an? |here|"
     r"at home)\b)", r"\1 staying "),
    # "Sunday lunch is at ours"
    (r"\b(?:at|over at|round at|back at) (?:ours|mine|theirs)\b", ""),
    # "dataset entry: four-bedroom house"
    (r"\b(?:data ?set|data ?base|dictionary|log|list|catalogue|table|json|csv|blog|diary|benchmark|corpus) entry(?= ?"
     r"(?:[:,.]|$|\d|#|for\b))", ""),
)]  # fmt: skip


def without_tasks(text: str) -> str:
    """A folded text without such words."""
    return reworded(text, _SAID)


_EDGE = late(r"\b([a-z]+(?: ?room)?(?: \d)?) ?(?:<?-+>?|to|/|,|&|\+) ?([a-z]+(?: ?room)?(?: \d)?) ?"
             r"\((?:open(?:ing)?|open[- ]plan|archway|no door|no wall|doorless|open connection)\)")  # fmt: skip
_KEY = (r"(bed ?room|bath ?room|kitchen|living room|study|office|storage(?: room)?|closet|hall(?:way)?|toilet|"
        r"balcony|dining room)")  # fmt: skip
_COUNTS = re.compile(rf"(?:(?<=[,;.:({{\n] )|(?<=[,;.:({{\n])|^)\"?{_KEY}\"?: ?(\d)(?= ?(?:[,;.)}}\n]|$))")
_MOST = {"bedroom": 7, "bathroom": 4}
"""How many of a room a list of counts may say; of others it is two."""


def as_listed(text: str) -> str:
    """`kitchen-lounge (open)` as an opening, `bedroom: 4, bathroom: 2` as counts where no number can be an area."""
    text = _EDGE.sub(r"\1 <-> \2: open", text)
    found = [(key.replace(" ", ""), int(number)) for key, number in _COUNTS.findall(text)]
    small = all(number <= _MOST.get(key, 2) for key, number in found)
    if len(found) < 2 or not small or "bedroom" not in dict(found) or dict(found)["bedroom"] < 2:
        return text
    return _COUNTS.sub(lambda one: f"{_named(one[1])}: {one[2]}", text)


def _named(key: str) -> str:
    """The plural of a key that counts rooms."""
    return key if key.endswith("ing room") else f"{key[:-1]}ies" if key.endswith("y") and key[-2] != "a" else f"{key}s"
