"""Furniture whose room is told beside it: in a clause behind that of the room, in one of its own, or in a task."""

import re

from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import reworded, rules

_ROOM = (r"(?:[主次客大小]卧室?|第[一二三]间卧室|另一间卧室?|(?:老人|儿童|孩子|父母|客|书|保姆|[男女]孩)(?:的)?房间?|"
         r"厨房|客厅|餐厅|书房|阳台|玄关)")  # fmt: skip
_HAVE = (r"(?:里面?|房间里面?|那里|屋里|其中)?(?:还|也|都)?(?:需要|要|得|想|希望|应该|最好)?(?:还|再|能)?(?:有|放|摆|"
         r"配|带|配有|配备|"
         r"摆放|放置|放下)")  # fmt: skip
_THING = (r"(?:书桌|书架|书柜|衣柜|单人床|双人床|上下床|床头柜|[大小]?床|沙发|茶几|餐桌|椅子|电视|梳妆台|斗柜|柜子|"
          r"学习桌|玩具柜|婴儿床|"
          r"地毯|台灯|落地灯|办公桌|电脑桌|桌子|写字台)")  # fmt: skip
_OWN = r"(?:[带有是做当](?:一?个|独立|成|作)?(?:阳台|卫生间|卫浴|衣帽间|浴室|儿童房|客房|老人房|书房))"
_EAT = (r"(?:an?|one|the|two|some) (?:(?:big|large|small|round|long|wooden|nice) )*(?:dining|eating|kitchen)? ?"
        r"tables?\b")  # fmt: skip
_TASK = (r"(?:fetch|pick(?: up)?|bring|take|carry|move|grab|get|deliver|put|place|find|collect|navigate|drop|return|"
         r"lay|retrieve)")  # fmt: skip
_HOLDS = (
    r"(?:desk|table|bed|sofa|couch|book ?shelf|shelf|(?:coffee|dining|kitchen|side|bedside) table|nightstand|"
    r"fridge|"
    r"counter|worktop|sink|dishwasher|wardrobe|dresser|cabinet|cupboard|chair|armchair|oven|washing machine)"
)
_BARE = r"(?:kitchen|study|office|bed ?room|living room|bath ?room|hall(?:way)?|dining room|pantry|lounge|balcony)"
_TASK_SAID = late(
    rf"(?:^|(?<=[.!;] )|(?<=\n))(?:(?:the )?(?:task|goal|mission|instruction|episode|"
    rf"query)s?(?: is(?: to)?)? ?:? "
    rf"?|(?:the|a|our) (?:robot|agent) (?:should|must|has to|will|can|"
    rf"needs to) )(?:to )?{_TASK}\b[^.!;\n]*"
    rf"|^(?:fetch|pick up|bring|carry|grab|deliver|retrieve) (?:the|an?|some) [^.!;\n]*"
)
_STUDIO = r"\bstudio\b[^.;]*?"
_WITH_IT = r"(?:un |une )?(?:petit |grand )?(?:lit|canape|armoire|placard|table|chaise|etagere|commode|clic-clac|tv)"

_SAID = rules((
    # "次卧给孩子住,要有书桌和书架"
    (r"(?P<room>(?:^|(?<=[,.;:] )|(?<=[,.;:\n]))(?:一间|把)?{room})"
     r"(?P<said>(?![和与跟、及])(?:{own}|(?!{room}|[和与跟、及]|"
     r"{thing})[^,.;])*), ?{have}(?=[^,.;]{0,6}{thing})(?![^,.;]*在)",
     lambda found: f"{found['room']}{found['said']},{re.sub('^(?:一间|把)', '', found['room'])}有"),
    # "the bathroom has a washing machine, and I need a dining table with two chairs"
    (r",? and (?:i|we)(?: also)?(?: (?:need|want|would like)|'d like) (?={eat}[^.;]*)(?![^.;]*\b(?:there|in it|in the|"
     r"in that)\b)", ". we need "),
    # "in the kitchen a table with six chairs, and I don't want carpets"
    (r",? and (?:i|we) (?:do not|don't|dont) (?:want|need|like)(?: any)? (?=(?:carpets?|rugs?|tvs?|televisions?|plants?"
     r"|curtains?|bath ?tubs?)\b(?![^.;]*\b(?:there|in)\b))", ". no "),
    # "a guest room, a shower instead of a bath": of the bathroom, where none is told of before
    (r"(?P<before>[^.;]*), (?:and )?an? (?P<shower>(?:walk-in )?shower) (?:instead of|rather than|and no) an? "
     r"(?:bath|bath ?tub|tub)\b",
     lambda found: found[0] if re.search(r"bath ?room|suite|wet room", found["before"])
     else f"{found['before']}. the bathroom has a {found['shower']} and no bathtub. "),
    # "the second one is for our son, with a desk and a bookshelf"
    (r"\b(the (?:first|second|third|other|small(?:er|est)?|big(?:ger|gest)?|large(?:r|st)?|main) )(?:one|room|"
     r"bed ?room)"
     r" (is for [^,.;]{3,30}), with (?=(?:an?|one|two) )", r"\1bedroom \2, and has "),
    # "a dining table for four with chairs"
    (r"\b(tables? for (?:two|three|four|five|six|eight|\d+)(?: people| persons)?) with (?:matching |its )?chairs\b",
     r"\1"),
    # "bureau et lit" of one room
    (r"(?P<with>{studio}(?:,|avec|et) )(?:un )?(?:petit |grand )?bureau(?=(?: et|,) {with_it}\b)",
     r"\g<with>une table de travail"),
    (r"(?P<with>{studio}{with_it}(?: (?:une|deux|double|simple|de|place|places|d'angle|convertible)\b)*(?: et|"
     r",) )(?:un )?"
     r"(?:petit |grand )?bureau\b(?! (?:separe|ferme|a part|independant|distinct))", r"\g<with>une table de travail"),
), room=_ROOM, have=_HAVE, thing=_THING, own=_OWN, eat=_EAT, studio=_STUDIO, with_it=_WITH_IT)  # fmt: skip


def things_told(text: str) -> str:
    """A folded text with such rooms told at the furniture."""
    return reworded(_told_last(text), _SAID)


def _told_last(text: str) -> str:
    """A text with its tasks behind what it says of the home: rooms in them are those of the home, as is furniture."""
    tasks = [found.group() for found in _TASK_SAID.finditer(text)]
    if not tasks:
        return text
    rest = re.sub(r"^[ .!;]+", "", _TASK_SAID.sub("", text)).rstrip(" .;!")
    if not rest:
        return text
    return f"{rest}. {'. '.join(_of_the_home(task, rest) for task in tasks)}."


def _of_the_home(task: str, rest: str) -> str:
    """A task with `the` before its rooms, and without furniture that the rest of the text has told of."""
    task = re.sub(rf"\b(from|in|into|to|of|on) (?={_BARE}\b(?! (?:counter|table|sink|shelf)))", r"\1 the ", task)
    return re.sub(
        rf"\b(?:on|onto|to|from|in|into|at)(?: top of)? (?:the |an? )?({_HOLDS}) (?:in|of) (?=the )",
        lambda found: "in " if re.search(rf"\b{found[1]}s?\b", rest) else found.group(),
        task,
    )
