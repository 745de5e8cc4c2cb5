"""Rooms wished for and then given up: `wanted a balcony, then decided against it`, in the words of what is left out."""

import re

from apartgen.stages.plan.reader.lexicon import read_lexicon
from apartgen.stages.plan.reader.patterns import late

_WHO = (r"(?:(?:he|she|they|we|i|it|(?:the|my|our|his|her|their) [a-z]+(?: and i)?) )?(?:have |has |had |'ve |'s )?"
        r"(?:(?:then|since|later|now|finally|eventually|ultimately|afterwards|soon|just|also|both|all) )*")  # fmt: skip
_ON = (r"[,;]? ?(?:(?:but|and|then|so|yet|later|now|finally|afterwards|in the end|eventually|on reflection|"
       r"on second thoughts?|after some thought|after all|having thought about it)[, ]+)*")  # fmt: skip
_GAVE_UP = (r"(?:(?:decided|chose|opted|voted|deciding|came down) against(?: having| adding)?|"
            r"(?:decided|chose|opted) not to (?:have|include|add|build|plan|keep|take)|"
            r"talked (?:me|us|him|her|them) out of|"
            r"gave up(?: on)?|given up(?: on)?|dropped|abandoned|scrapped|ditched|cancell?ed|renounced|"
            r"dismissed|discarded|let go of|did away with|thought better of|said no to|dispensed with|"
            r"changed (?:my|his|her|our|their|its) minds? about)")  # fmt: skip
_NOUN = (r"(?:(?:second|third) )?(?!(?:idea|bed|the|an?)\b)[a-z]+"
         r"(?:[ -](?:room|bath|closet|toilet|kitchen|area|bathroom))?")  # fmt: skip
_END = r"(?= ?(?:[.,;:!?)]|$)| (?:again|after all|altogether|though|instead|now|and|but|so|because|as|in the end)\b)"
_THE = r"(?:the idea of )?(?:having )?(?:the|an?|any|our|my|that|this|having an?) "
_IT = r"(?:the idea|it|that|this|one|them|her|him|that idea|this idea)"
_FIRST = re.compile(r"(?<!the )(?<!a )\b(?:(?:at|in the) (?:first|beginning|start)|first|initially|originally|"
                    r"to begin with),? "
                    r"(?=(?:[a-z]+ ){0,3}(?:wanted|asked|wished|thought|hoped|planned|had|was)\b)"
                    r"|(?<=wanted) first\b|(?<=asked) first\b"
                    r"|,? (?:at first|initially|originally)(?= ?[,.;])")  # fmt: skip
_OF_NOUN = [late(pattern) for pattern in (
    rf"{_ON}\b{_WHO}{_GAVE_UP} {_THE}({_NOUN}){_END}",
    rf"{_ON}\bthe ({_NOUN}) (?:has been|have been|was|were|is|got) (?:then |later |since |now |finally |again )*"
    rf"(?:dropped|scrapped|ditched|cancell?ed|given up|taken out|struck|discarded)(?: again)?{_END}",
    rf"[,;.] ?(?:(?:but|and|then|so) )?(?:in the end|after all|on reflection|finally|then again),? (?:no|not? an?|"
    rf"without an?) ({_NOUN}){_END}",
    r"[,;]? ?(?:und |aber |dann )*(?:wir |ich |sie )?(?:haben|habe|hat) (?:uns|mich|sich) "
    r"(?:dann |aber |doch |jetzt |spater )*gegen (?:den|die|das|einen|eine|ein) ([a-z]+) entschieden",
    r"[,;]? ?(?:(?:et|mais|puis|ensuite|finalement) )*(?:nous avons|j'ai|ils ont|elle a|il a|on a) (?:finalement )?"
    r"(?:renonce (?:a la |au |a l')|abandonne (?:le |la |l'))([a-z]+)(?= ?(?:[.,;]|$))",
    r"[,;]? ?(?:(?:y|pero|luego|despues|finalmente|al final) )+(?:(?:hemos )?descart\w+ (?:el|la)|renunci\w+ "
    r"(?:al|a la)) ([a-z]+)(?= ?(?:[.,;]|$))",
)]  # fmt: skip
_OF_IT = [late(pattern) for pattern in (
    rf"{_ON}\b{_WHO}(?:gave|given|let) (?:it|that|them) (?:up|go|drop){_END}",
    rf"{_ON}\b{_WHO}{_GAVE_UP} {_IT}{_END}",
    rf"{_ON}\b(?:it|that|this) (?:has been|was|is|got) (?:then |later |since |now |finally |again )*"
    rf"(?:dropped|abandoned|scrapped|ditched|cancell?ed|given up|cut|taken out|discarded)(?: again)?{_END}",
    r", (?:but|and) (?:now )?(?:no longer|not any ?more)(?= ?(?:[.;]|$))",
    r"[,;]? ?(?:und |aber |dann |wir |ich |sie )*(?:haben|habe|hat) (?:uns|mich|sich) "
    r"(?:dann |aber |doch |jetzt |spater |schliesslich )*dagegen entschieden",
    r"[,;]? ?(?:(?:et|mais|puis|ensuite|finalement) )*(?:nous y avons|j'y ai|ils y ont|elle y a|il y a|on y a) "
    r"(?:ensuite |finalement )?renonce",
    r"[,;]? ?(?:(?:y|pero|luego|despues|finalmente|al final) )+(?:l[oa]s? (?:hemos )?(?:descart\w+|desestim\w+|quit\w+|"
    r"rechaz\w+)|renunci\w+ a (?:ello|el|ella))",
    r"[,;]? ?(?:但是?|不过|可是)?后来(?:又|我们)*(?:决定)?(?:不要了|放弃了|取消了|算了)",
)]  # fmt: skip

_WISHED = re.compile(r"\b(?:want|wish|ask|plan|though|think|consider|hope|request|dream|propos|toyed|talked about|"
                     r"on (?:the|my|our|his|her) (?:wish ?)?list|wollt|dacht|voul|quer|quis|pens|\w+ going to have|"
                     r"was to be|would like|would have)|[想要]")  # fmt: skip


def renounced(text: str) -> str:
    """A folded text in which such a room is to be forgotten."""
    said = text
    for pattern in _OF_NOUN:
        said = pattern.sub(_left_out, said)
    for pattern in _OF_IT:
        said = pattern.sub(_it, said)
    return _FIRST.sub("", said) if said != text else text


def _left_out(found: re.Match[str]) -> str:
    """`… decided against the balcony`; of a second bathroom there is none."""
    name = found[1].removeprefix("second ").removeprefix("third ")
    if not _room(name):
        return found.group()
    return f". forget the {name}" if name == found[1] else f". no {found[1]}"


def _it(found: re.Match[str]) -> str:
    """`… a balcony, then decided against it`: the room that was named last, where somebody wished for it."""
    if not _WISHED.search(found.string, 0, found.start()):
        return found.group()  # "the robot takes the cup to the study and dropped it"
    rooms = [one for one in _names(found.string[: found.start()]) if _room(one)]
    return f". forget the {rooms[-1]}" if rooms else found.group()


def _names(text: str) -> list[str]:
    """Every word of a text, or two of them, that may name one room, in their order."""
    words = re.findall(r"[a-z]+|[\u4e00-\u9fff]+", text)
    return [" ".join(words[k - n : k]) for k in range(1, len(words) + 1) for n in (1, 2) if k >= n]


def _room(name: str) -> bool:
    """Whether a name is that of one room."""
    return any(entry.kind == "room" for entry in read_lexicon().entries.get(tuple(name.split())) or ())
