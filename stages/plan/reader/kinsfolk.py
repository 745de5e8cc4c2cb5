"""Words of people about themselves in those that the rules of people know: `we parents`, `mum and dad`."""

import re

from apartgen.stages.plan.reader.kin import kind_of, number_of, pattern, rooms_for, several
from apartgen.stages.plan.reader.mine import beside_mine
from apartgen.stages.plan.reader.patterns import late
from apartgen.stages.plan.reader.pieces import CHILD, ELDER, reworded, rules
from apartgen.stages.plan.reader.sharing import sharing
from apartgen.stages.plan.reader.some_share import some_share

_PARENT = r"(?:mum|mummy|mom|mommy|mama|mami|maman|mutter|mother|dad|daddy|papa|papi|father|vater)"
_SIBLING = r"(?:(?:little|big|older|younger|elder|twin) )?(?:brother|sister|bruder|schwester|frere|soeur|herman[oa])"
_CHILDREN = r"(?:kinder|jungen|jungs|madchen|tochter|sohne|teenager|enkel)"
_COUNT = (r"(?:two|three|four|five|six|zwei|drei|vier|funf|sechs|deux|trois|quatre|cinq|dos|tres|cuatro|cinco|seis|"
          r"[2-6])")  # fmt: skip
_THAT_MAKES = (r"(?:(?:and |so |und |et |y )?(?:that(?:'s| is| makes| means| gives| comes to| adds up to)|this makes|"
               r"which (?:makes|is|gives)|das (?:macht|sind|ergibt|waren)|was (?:macht|ergibt)|(?:cela|ca|ce qui) "
               r"fait|soit|(?:eso |esto |lo que )?(?:hace|hacen|da|dan|suma|suman)|making|macht))")  # fmt: skip
_OTHER = (r"(?:another|(?:the |an )?other|(?:a |the )?(?:second|third|fourth)|"
         r"(?:(?:einem|dem) )?(?:anderen|zweiten|dritten)|(?:une |l')?autre|"
          r"(?:la )?(?:deuxieme|troisieme)|otr[oa]|(?:el |la )?(?:segund[oa]|tercer[oa]?))")
"""One of several rooms, beside the one told of."""
_WHOLE = (r"(?: (?:in total|in all|altogether|all told|insgesamt|zusammen|en tout|au total|en total|total))?")
_THEIR = {"eltern": "die eltern haben ein schlafzimmer", "parents": "les parents ont une chambre",
          "padres": "los padres tienen un dormitorio"}  # fmt: skip
_ME = {"我": "my room", "我们": "a parents' bedroom"}


def _room_of(found: re.Match[str]) -> str:
    """`our bedroom and the baby's are next to each other`: the baby's room, where one was named before."""
    named = re.search(r"\b(?:bed ?rooms?|rooms?|ours|mine)\b", found.string[: found.start()])
    return f"{found['who']}'s room" if named else found.group()


_AWAKE = "".join(rf"(?<!{verb} )" for verb in "sleep sleeps schlafen dorment dormons duermen dormimos".split())
_SAID = rules((
    # "three children who each want a room, and us. That makes four bedrooms."
    (r" ?[,;:.-] ?{makes}(?: then| also| dann| donc)?,? (?P<n>{count}) (?P<rooms>{bedrooms}){whole}(?= ?(?:[.,;:!)]|$)|"
     r" and | und | et | y )", r". \g<n> \g<rooms> in total"),
    # "Mum and Dad have the second bedroom", "wir Eltern haben unser eigenes Schlafzimmer"
    (r"\b(?:(?:my|our|meine|unsere|mes|mis|the) )?{parent}(?: and| und| et| y| &|,) (?:(?:my|our|meine?) )?{parent}\b",
     "my parents"),
    (r"\b(?:wir|nous(?: les)?|nosotros(?: los)?) (?P<who>eltern|parents|padres) (?:haben|bekommen|brauchen|avons|"
     r"aurons|voulons|tenemos|queremos) (?:unser|ein|notre|une|nuestro|nuestra|un) (?:eigenes |propre |propi[oa] )?"
     r"{bedroom}(?: propi[oa])?\b", lambda found: _THEIR[found["who"]]),
    # "meine Mutter, die ein eigenes Schlafzimmer braucht"
    (r"(?P<who>\b(?:meine[rmn]?|unsere[rmn]?) [a-z]+)(?: zusammen)?,? (?P<die>die|der|das) (?P<room>(?:ein(?:en?)?|ihr|"
     r"sein) eigene[sn]? {bedroom}) (?P<verb>braucht|hat|bekommt|will|mochte|haben|brauchen|bekommen)\b",
     r"\g<who>, \g<die> \g<verb> \g<room>"),
    (r"(?P<me>我们?)(?:和|跟|与)(?:我的?)?(?P<who>[^,.;和跟与]{1,4}?)(?:一起|同)?住[,.;] ?(?:她|他)(?:要|需要|"
     r"想要)(?:有)?(?:一间)?"
     r"自己的(?:卧室|房间)", lambda found: f"{_ME[found['me']]} and a relative's room"),
    # "meine Eltern bekommen ein Schlafzimmer, ich brauche ein Zimmer"
    (r"(?P<said>\b(?:meine eltern|mes parents|mis padres)\b[^.]*?[,;] ?(?:und |et |y )?)(?:ich (?:brauche|will|"
     r"mochte|bekomme|"
     r"habe|nehme)|(?:je veux|je voudrais|j'ai|il me faut|moi)|(?:necesito|quiero|yo|tengo))(?: auch| aussi| tambien)?"
     r" (?:ein(?:en)?|une?|una?)(?: eigenes| kleines| petite)? {bedroom}\b", r"\g<said>a bedroom"),
    (r"\bwe parents (?=have|get|need|want|sleep|take|in )", "the parents "),
    (r"\b(parents (?:have|get|need|want)) our own (?=(?:bed ?)?room)", r"\1 their own "),
    (r"\b(die|unsere[nr]?|meine[nr]?|den) beiden (?={kinder}\b)", r"\1 zwei "),
    # "our bedroom and the baby's are next to each other", "ours 14 m², the baby's 9 m²"
    (r"\b(?P<who>(?:the|our|my) (?:{child}|{elder}|guest))'s(?! and (?:the|my|our) [a-z]+'s? (?:bed ?)?rooms)"
     r"(?= ?(?:[.,;:!?)]|$)| (?:and|is|are|should|must|next|near|has|with|on|at|\d))", _room_of),
    # "my brother and I share the third, where we have a bunk bed"
    (r"^(?P<before>(?=.*\bmy parents\b).*?)\bmy {sibling} and (?:i|me) (?=share|sleep)",
     r"\g<before>the two children "),
    (r"\b(room|one|third|second|kitchen),? where (?:we|they|you) (?:have|want|need|keep) (?=(?:an?|one|two|three|\d) )",
     r"\1, with "),
    # "for my parents: one bedroom for them and one guest room, each with a double bed"
    (r"(\bbed ?room) for them(?= ?(?:[.,;]|$)| and | with )(?!.*\bfor them\b)", r"\1"),
    # "two boys are sleeping together in one bedroom", "two girls in other bedroom"
    (r"\b(?:are|is) sleeping (?=(?:together )?in )", "sleep "),
    (r"\bin (?=(?:other|second|third) (?:bed ?)?room)", "in the "),
    (r"\b(?:sleeps?|schlaf(?:t|en)|dort|dorment|duermen?) (?:together |zusammen |ensemble |juntos )?(?=(?:in|dans|en) "
     r"(?:an?|one|the same|einem|une|un|una) {bedroom}\b"
     r"[^.;]*{awake}\b(?:in|im|dans|en) (?:{other}))", ""),
), parent=_PARENT, sibling=_SIBLING, kinder=_CHILDREN, count=_COUNT, makes=_THAT_MAKES,
   whole=_WHOLE, other=_OTHER, awake=_AWAKE, child=CHILD, elder=ELDER)  # fmt: skip
_OF_ALL = re.compile(r"\b(?:the|both|all|our|my|die|unsere|beide|les|nos|los|nuestr[oa]s|mis) "
                     r"(?:two |three |zwei |drei )?(?:children|kids|kinder|enfants|hijos|ninos)\b")  # fmt: skip


_KIN = late(rf"\b(?:my|our) (?:[a-z]+ )?({CHILD}|{ELDER}|sister|brother|niece|nephew)\b")
_HIS = re.compile(r"\b(?:his|her) (?:bed ?)?room (?=(?:must|should|may|is|has|does|can)(?:n't| not)?\b[^.,;]*"
                  r"\b(?:with|to|from|beside|near|by|touch|adjoin|border) "
                  r"(?:ours|mine|(?:our|my) (?:bed ?)?room)\b)")  # fmt: skip


def as_kin(text: str) -> str:
    """A folded text with such words; `his bedroom`, told of beside ours, is that of the one relative named."""
    text = sharing(some_share(beside_mine(text)))
    kin = {found[1] for found in _KIN.finditer(text)}
    if len(kin) == 1 and _HIS.search(text):
        text = re.sub(r"\b(?:his|her) (?=(?:bed ?)?room\b)", f"my {next(iter(kin))}'s ", text)
    return reworded(text, _SAID)


def in_turn(text: str) -> tuple[str, bool]:
    """`two boys in one room, the girl in another, us in a third` as rooms that these have; whether some are so told."""
    first = "{who} (?:in|dans|en) {article}*{room}"
    if pattern(first).search(text) is None:
        return text, False
    ends = "(?=[,.;]|$| (?:and|und|et|y|with|mit|avec|con|in) )"
    other = f"(?:in|im|dans|en) (?:{_OTHER}|{{article}}+)(?: one| {{room}})?{ends}"
    said = pattern(f"(?:{{self}}|\\bwir) {other}").sub("a parents' bedroom", text)
    said = pattern(f"{{who}} {other}").sub(_one_room, said)
    return pattern(first).sub(_one_room, said), said != text


def _one_room(match: re.Match[str]) -> str:
    return rooms_for(match, 1)


def told_of_all(text: str) -> bool:
    """Whether a folded text speaks of the children as known, `the kids each have a room`."""
    return _OF_ALL.search(text) is not None


def told_before(match: re.Match[str]) -> bool:
    """Whether this is `a daughter`, named before the rooms of all children."""
    rooms = match.string.find("kids room")
    return kind_of(match) == "child" and not several(match) and number_of(match) < 2 and match.start() < rooms
