"""Clauses that anybody writes, in those that the other rules know: what is far, where windows look, what was sold."""

from apartgen.stages.plan.reader.pieces import KIND, reworded, rules

_ROOM = rf"(?:(?:the|my|our|his|her|their|[a-z]+'s) )?(?:own )?(?:{KIND}|bed ?room(?: \d)?|room)"
_COMPASS = r"(?:north|south)(?:[ -]?(?:east|west))?|east|west"
_COME_IN = (r"(?:when|as|once) (?:you|i|we|one) (?:come|enter|step|walk|go)(?:e?s)?(?: (?:in ?to|in|inside))?"
            r"(?: (?:the |my |our )?(?:flat|apartment|home|house|door|front door))?")  # fmt: skip
_OUT = r"(?:garden|street|park|courtyard|yard|river|sea|lake|road|square|mountains?|forest)"
_HOURS = r"(?:ein|zwei|drei|vier|funf|sechs|sieben|acht|neun|zehn|elf|zwolf|\d{1,2})"
_WORK = (
    r"(?:sew|make|build|design|sell|repair|fix|restore|review|import|tune|collect|paint|test|upholster|deliver|trade)"
)
_GONE = r"(?:sold|gave away|got rid of|threw out|threw away|scrapped|binned|donated|left behind|lost)"
_HOME = r"(?:flat|apartment|place|home|house)"
_SAID = rules((
    # "our flat now has two bedrooms and we queue for the loo. In the new one we want three bedrooms"
    (r"(?:^|(?<=[.!?;] ))(?:(?:our|my|the) (?:current|present|old|last|previous) {home}|(?:our|my) {home} (?:now|"
     r"currently|today|at the moment)) (?:now )?(?:has|had|have|is|was|only has)\b[^.!?;]*[.!?;] ?(?=[^.]*\b(?:new|"
     r"want|need|like|wish|looking)\b)", ""),
    (r"\bin (?:the|our|my) (?:new|next) (?:one|{home}),? (?=(?:i|we)\b)", ""),
    # "I don't want his room anywhere near mine", "nowhere near the kitchen"
    (r"\b(?:i|we)? ?(?:do not|don't|does not|would not|wouldn't|never) (?:want|like|need|put|have|place) (?P<a>{a}) "
     r"(?:to be )?(?:anywhere |any place |somewhere )(?:near|close to|next to|beside)(?: to)? ", r"\g<a> is far from "),
    (r"\b(?:nowhere|not anywhere) (?:near|close to|next to)(?: to)?\b", "far from"),
    (r"\b(?:{not}) be anywhere (?:near|close to|next to)\b", "must be far from"),
    # "55 m2 at the very most", "is to be twice as large as"
    (r"\bat the (?:very|absolute) (most|least)\b", r"at \1"),
    (r"\b(is|are) to be (?=(?:twice|half|three|at least|at most|the (?:large|small|big)|larger|smaller|bigger|next|"
     r"near|far|as|open|in|on|at|opposite)\b)", "must be "),
    # "windows of the living room to the south, of both bedrooms to the north", "the bedroom window look to the
    # garden, garden is in south"
    (r"\b(?:the )?windows? (?:of|in) (?P<a>{a}) (?:{must} )?(?:(?:be|look|face|go|are|looking|facing|open) )?(?:out "
     r")?(?:to|towards|on|onto|at)?(?: the)? ?(?P<s>{compass})(?:[,;]? (?:and )?(?:those )?(?:of|in) (?P<b>{a}) (?:to|"
     r"towards|on)?(?: the)? ?(?P<t>{compass}))?\b",
     lambda found: f"{found['a']} faces {found['s']}" + (f". {found['b']} faces {found['t']}" if found["b"] else "")),
    (r"(?P<a>{a}) windows? (?:(?:{must}|to) )?(?:looks?|faces?|goes?|opens?)(?: out)? (?:on ?to|to|on|over|at|towards|"
     r"into) the (?P<o>{out})[,;.]? ?(?:and |which |that )?(?:the )?(?:(?P=o) )?(?:is|lies) (?:in|to|on|at)(?: the)? "
     r"(?P<s>{compass})\b", r"\g<a> faces \g<s>"),
    # "when I come in, the kitchen is on the left and the living room on the right", "to the left as you come in"
    (r"\b(?:to|on|at) (?:the|your|my) (left|right)(?:[ -]hand)?(?: side)? {come}", r"to the \1 of the entrance"),
    (r"\b{come},? (?:i want |we want |there is )?(?:that )?(?P<a>{a}) (?:{must} be |is )?(?:to|on|at|in) (?:the|your|"
     r"my) (?P<s>left|right)(?:[ -]hand)?(?: side)?(?:,? and (?P<b>{a}) (?:{must} be |is )?(?:to|on|at|in) (?:the|"
     r"your|my) (?P<t>left|right)(?: side)?)?",
     lambda found: f"{found['a']} is to the {found['s']} of the entrance"
     + (f" and {found['b']} is to the {found['t']} of the entrance" if found["b"] else "")),
    # "a bathroom without a bath, only a shower", "I can't climb into a bathtub any more, so a shower, please"
    (r"\bwithout (?:an? )?bath(?:tub)?,? (?:but )?(?:only|just|but)(?: with)? (?:an? )?shower\b",
     "with a shower and no bathtub"),
    (r"\b(?:can't|cannot|can not|can no longer|not able to)(?: \w+){0,3} (?:an? |the )?bath(?:tub)?(?: any ?more| any "
     r"longer)?,? (?:so|and|but) ",
     "want no bathtub, but "),
    # "I sew curtains for a living", "we sold the piano last year", "he works with a computer"
    (r"\b(i|we|he|she|(?:my|our) [a-z]+) (?:also )?{work}s? (?:[a-z]+ )?(?!rooms\b)[a-z]+s\b(?= (?:for a living|at "
     r"home|as a hobby|for a job)\b)",
     r"\1 work"),
    (r"\b{gone} (?:the|our|my|his|her|that|an?) (?:old |big |grand |second )?[a-z]+(?: [a-z]+)?(?= (?:last|years?|"
     r"when|ago|and don't|and do not)| ?[.,;])", "did so"),
    (r"\b((?:work|play|job|lesson|stud)(?:s|ies|ing)?) (?:with|on|at|by) (?:the |an? |his |her |my )?(?:computer|"
     r"laptop|pc)s?\b", r"\1"),
    # "the guest room can be small", "make the kitchen large, with an island, and open to the living room"
    (r"(?P<a>{a}) (?:can|may|could) be (?:quite |rather |very |fairly )?(small|tiny|little)\b", r"\g<a> is small"),
    (r"\bmake (?P<a>{a}) (?P<s>large|big|small|huge|spacious),? with (?P<w>[^.;]*?),? and (?:have it |make it )?open "
     r"to (?P<b>{a}){end}",
     r"\g<a> is \g<s>. \g<a> has \g<w>. \g<a> is open to \g<b>"),
    # "a laundry room beside the kitchen with a washing machine"
    (r"\b(?P<a>(?:an? |the )?(?:laundry|utility)(?: room)?) (?P<by>(?:next to|beside|near|close to|off|opposite) "
     r"(?:the )?{kind}) with (?P<w>[^.,;]*?){end}", r"\g<a> with \g<w>, \g<by>"),
    # "um sechs" is no number of rooms
    (r"\b(?:um|gegen|bis|ab) {hours}(?: uhr)?(?: (?:fruh|morgens|abends|nachts))?(?= (?:mit|in|im|auf|zu|am|an|und|"
     r"das|der|die|den)\b| ?[.,;])", ""),
    # "Bedrooms are two, second is for my son", "children is three"
    (r"\bchildren (?:is|are) ({number})\b", r"\1 children"),
), a=_ROOM, compass=_COMPASS, come=_COME_IN, out=_OUT, hours=_HOURS, work=_WORK, gone=_GONE, home=_HOME)  # fmt: skip


def commonly(text: str) -> str:
    """A folded text with such clauses reworded."""
    return reworded(text, _SAID)
