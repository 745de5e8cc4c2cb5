"""Patterns of clauses that say who works at home, by language, made of the pieces of `home_working.toml`."""

import re
import tomllib
from functools import cache
from pathlib import Path

from apartgen.stages.plan.reader.about import numbers
from apartgen.stages.plan.reader.pieces import KIND

COUNTED = ("none", "many", "all", "two", "one")
"""Who works, by how many they are."""
_THINGS = (
    r"(?!(?:for|with|of|and|in|on|at|near|mit|fur|und|avec|pour|et|de|con|para|y)\b|\w*(?:room|bed|bath|floor|"
    r"balcon|zimmer|bad|chambre|piece|dormitor|habitacion|bano|desk|m2|sq|storey|flat|apartment)s?\b)"
)
"""No people are counted across these words."""
PLURAL = re.compile(r"\b(?:people|persons|adults|friends|[a-z]+mates|colleagues|partners|[a-z]+ers|personen|leute|"
                    r"personnes|personas)\W*$")  # fmt: skip
WHERE = re.compile(rf"\b(?:an?|the|my|our|with|^) ?(?:[a-z]+ )??(?P<kind>{KIND}),? (?:where|in which)$")
"""A room in which somebody works."""
THERE = re.compile(rf" (?P<in>in (?:the|my|our|an?|his|her) (?P<kind>{KIND}))(?! (?:of|with)\b)")
APART = re.compile(rf",? one (?:of us |of them )?in (?P<a>(?:the|my|our|his|her) {KIND}),?(?: and|,) "
                   rf"(?:one|the other(?: one)?) in (?P<b>(?:the|my|our|his|her) {KIND})")  # fmt: skip
"""`…, one in the bedroom and one in the living room`."""
STUDY_EACH = re.compile(
    r"\b(?:we (?:each|both)|(?:each|both)(?: of us| of them)?) (?:needs?|wants?|has|have|gets?|would like) "
    r"(?:an?|our own|their own|his own|one) (?:own )?(?:study|home office|office|workroom)\b")
STUDIES = re.compile(r"\b(?:stud|office)")
LISTED_ON = re.compile(r"^(?:with|in|of|near|on|by|for|mit|avec|con|de|und|and|et|y)\b")
"""What goes on with the clause before."""
WORKER = re.compile(r"^(?:fully )?(?:(?P<adjective>.* )$|[a-z-]+?[- ]?(?:worker|employee)(?P<s>s?)$)")
MANY = re.compile(r"\b(two|three|four|five|six) $")
FOR_TWO = re.compile(r"\bfor (?:two|2)(?= ?(?:[.,;:!)]|$|who\b))")
FOR_SOMEBODY = re.compile(r"\b(?:for|of|fur|pour|para)(?: just| only)? $|[给为]$")
POSSIBLE = re.compile(
    r"(?:\b(?:it|this|the flat|the apartment|the home) )?(?:\b(?:is|must be|should be|has to be)|'s) (?:very |also )?"
    r"(?:possible|easy|necessary|essential|important) (?:for (?:me|us|both of us) )?to $|\b(?:which |that |it |and )?"
    r"(?:must|should|has to|needs to)? ?(?:allows?|supports?|permits?)(?: for)?(?: (?:me|us|both of us) to)? $")
"""`it must be possible to`, before the verb."""
VALUED = re.compile(
    r" (?:is|must be|should be|has to be|needs to be) (?:very |really |quite |also )?(?:important|essential|a must|"
    r"possible|needed|necessary|a priority|key|common)(?: (?:for|to) (?P<who>both of us|us both|us|me|him|her|"
    r"my [a-z]+))?")
"""`working from home is important for us`, behind it."""
SO_MANY = re.compile(r"[ -]*(?:friendly |ready )?(?:[a-z-]+ ){0,2}?(?:flat|apartment|home|house|condo|place) "
                     r"for (?:two|"
                     r"2|an? (?:[a-z]+ )?couple)\b")  # fmt: skip
"""`a work-from-home flat for two`."""
APIECE = re.compile(
    r"\b(?:an?|one|my) (?:own )?desk (?:each|apiece|per person|a head|for (?:each|either|both|every ?one)"
    r"(?: of (?:us|them|the two))?)\b|(?<=with )(?:each|both) (?:an? |one |with an? )(?:own )?desk\b|"
    r"\bdesks for (?:both|each|the two)(?: of (?:us|them))?\b|\bje einen? (?:eigenen )?schreibtisch\b|"
    r"\beinen? schreibtisch fur (?:jeden|jede|beide)(?: von uns)?\b|"
    r"\bun escritorio (?:cada uno|para cada uno|por persona)(?: de nosotros)?\b|每人一张(?:书桌|办公桌|写字台)")
"""A desk for each of them."""
# verbs that need no `we` are of both
BOTH = re.compile(
    r"\b(?:both|beiden?|tous les deux|toutes les deux|les deux|los dos|las dos|ambos|ambas)\b|俩|双方|"
    r"\b(?:tele)?(?:trabajamos|travaillons)\b|\b(?:hacemos|tenemos|estamos|faisons|sommes)\b|"
    r"\bteletravailleu(?:r|se)s\b|\bteletrabajadores\b|\bour (?:[a-z]+ )?jobs\b")


class Language:
    """Patterns of a language; those of what stands before the verb end where it begins."""

    def __init__(self, name: str) -> None:
        self.raw = {k: v for k, v in data()[name].items() if isinstance(v, str)}
        self.raw["who"] = "|".join(f"(?:{self.raw[k]})" for k in COUNTED)
        self.latin = latin = name != "zh"
        edge, gap = (r"(?<![\w'-])", "[ ,]*") if latin else ("", "[,,]?")
        counted = "|".join(f"(?P<{k}>{self.raw[k]})" for k in COUNTED)
        number = "|".join(sorted(numbers(), key=len, reverse=True)) + r"|\d"
        numbered = rf"(?<![\w-])(?P<n>{number}) (?:{_THINGS}[a-z-]+ ){{0,3}}?{_THINGS}[a-z-]+"
        also = "and |und |et |y |also |并且?|而且"
        self.core = self._of("|".join(f"(?:{one})" for one in data()[name]["core"]).replace("?P<mid>", "?:"))
        self.place = self._of("(?:{place})")
        self.fill = self._of(rf"(?:(?:(?<![\w-])|(?<=\w)(?='))(?:{{fill}}|{{often}}){gap})+$" if latin
                             else rf"(?:{{fill}}{gap})+$")  # fmt: skip
        self.denied = self._of(rf"{edge}(?:{{not}}){gap}$")
        self.denied_inside = self._of(r"(?<!\w)(?:{not}|{none})(?!\w)" if latin else "(?!)")
        self.who = self._of(rf"{edge}(?:{counted}){gap}$")
        self.who_inside = self._of(rf"{edge}(?:{counted})(?!\w)" if latin else rf"(?:{counted})")
        self.rel, self.lead = self._of(r"(?:{rel})[ ,]*$"), self._of("{lead}$")
        self.often = self._of(r"(?:,? ?(?<!\w)(?:{often}|{role})(?!\w))*" if latin else "的?(?:{often})?")
        self.more, self.rest = self._of("(?:{more})"), self._of("(?:{rest})")
        self.so = self._of(rf"[,，;:]?{gap}(?:and |und |et |y )?(?:{{so}})[ ,，]*")
        self.keep = self._of(rf",?[ ,]*(?:{also})*(?={{keep}})")
        self.suited = self._of(rf"{edge}(?:{{suited}}){gap}$")
        self.couple = self._of(rf"{edge}(?:{{couple}})(?:,? [a-z]+)??[ ,]*$" if latin else "(?:{couple})$")
        self.spot, self.away = self._of("(?:{spot})[ ,]*$"), self._of("(?:{away})$")
        self.staff = self._of(r"(?<!\w)(?:{staff})[ ,]*(?:who|that|which|die|der|qui|que)?[ ,]*$")
        self.persons = self._of(rf"{numbered}[ ,]*$" if latin else rf"(?P<n>{number})[个位名口对](?:人|成年人)?$")

    def _of(self, pattern: str) -> re.Pattern[str]:
        for _ in range(3):
            for key, value in self.raw.items():
                pattern = pattern.replace("{" + key + "}", value)
        return re.compile(pattern)


@cache
def data() -> dict[str, dict[str, str | list[str]]]:
    """The pieces, by language."""
    return tomllib.loads((Path(__file__).parent / "home_working.toml").read_text(encoding="utf-8"))


language = cache(Language)
