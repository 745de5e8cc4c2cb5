"""Who works at home, as people may say it, drawn at random from what stands for each: each has a desk in its place."""

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np
import pytest
from sentences.drawn import as_drawn, one, upper

from apartgen.schemas.errors import BadInput
from apartgen.stages.plan.reader import read

Rng = np.random.Generator


@dataclass(frozen=True)
class Home:
    """Where one who works in a home has a desk, and where two have; "-" is no place."""

    one: tuple[str, ...]
    two: tuple[str, ...]


_TWO_BEDS = Home(("bedroom_2",), ("bedroom_2", "bedroom_1"))
_ONE_BED = Home(("bedroom_1",), ("bedroom_1", "living_room_1"))
_THREE_BEDS = Home(("bedroom_2",), ("bedroom_2", "bedroom_3"))
_STUDY = Home(("study_1",), ("study_1", "study_1"))
_LARGE = Home(("study_1",), ("study_1", "study_2"))
_ROOM = Home(("living_room_1",), ("living_room_1", "-"))
HOMES: dict[str, dict[str, Home]] = {
    "en": {
        "two-bedroom flat": _TWO_BEDS, "flat with two bedrooms": _TWO_BEDS, "2-bed apartment": _TWO_BEDS,
        "two-bedroom flat of 70 m2": _TWO_BEDS, "one-bedroom flat": _ONE_BED, "apartment with one bedroom": _ONE_BED,
        "one-bedroom apartment of 50 m2": _ONE_BED, "three-bedroom flat": _THREE_BEDS, "flat": _STUDY,
        "flat of 95 m2": _LARGE, "apartment of 80 square metres": _STUDY, "apartment with a balcony": _STUDY,
        "two-bedroom flat with a study": _STUDY, "flat with one bedroom and a home office": _STUDY, "studio": _ROOM,
        "studio of 30 m2": _ROOM, "studio of 42 m2": Home(("living_room_1",), ("living_room_1",) * 2),
    },
    "de": {"Zweizimmerwohnung": _ONE_BED, "Dreizimmerwohnung": _TWO_BEDS, "Wohnung mit 90 m²": _LARGE,
           "Wohnung mit zwei Schlafzimmern": _TWO_BEDS, "Wohnung mit zwei Schlafzimmern und Arbeitszimmer": _STUDY},
    "fr": {"deux-pièces": _ONE_BED, "appartement de 90 m²": _LARGE, "appartement avec deux chambres": _TWO_BEDS,
           "trois-pièces": _TWO_BEDS, "appartement avec une chambre et un bureau": _STUDY},
    "es": {"piso de un dormitorio": _ONE_BED, "piso de dos dormitorios": _TWO_BEDS, "piso de 90 m²": _LARGE,
           "piso de tres dormitorios": _THREE_BEDS, "piso con un dormitorio y un despacho": _STUDY},
    "zh": {"一室一厅": _ONE_BED, "两室一厅": _TWO_BEDS, "三室一厅": _THREE_BEDS, "两室一厅带书房": _STUDY},
}  # fmt: skip


@dataclass(frozen=True)
class Meant:
    """A home, how many work there, and the text without a word on it, where it is a prompt itself."""

    home: Home
    many: int
    plain: str


Draw = tuple[str, Meant]
VERBS = ("work from home", "work at home", "work remotely", "work from our home", "telecommute", "telework", "WFH",
         "work mostly from home", "work full-time from home", "mostly work from home", "often work at home",
         "will be working from home", "are working from home", "have remote jobs", "have to work from home",
         "need to work from home", "want to work from home", "usually work remotely", "do home office",
         "can work from home", "now work from home", "work three days a week from home", "work a lot from home",
         "currently work from home", "like to work at home")  # fmt: skip
VERB = ("works from home", "works at home", "works remotely", "telecommutes", "mostly works from home", "teleworks",
        "works from home as a translator", "is working from home", "has a remote job", "has a home office job",
        "has to work from home", "often works at home", "will be working from home", "works two days a week from home",
        "usually works remotely", "works full time from home", "wants to work from home",
        "runs a small business from home")  # fmt: skip
MINE = ("work from home", "work at home", "work remotely", "telecommute", "mostly work from home",
 "am working from home",
        "have a remote job", "have a home office job", "work from home as a programmer", "often work at home", "WFH",
        "will be working from home", "need to work from home", "freelance from home", "work remotely for a bank",
        "want to be able to work from home", "usually work from home")  # fmt: skip
OFTEN = ("", "", "", " three days a week", " most days", " every day", " two days a week", " full time",
         " on Fridays", " now", " most of the time", " a few days a week", " several days per week",
         " since the pandemic")  # fmt: skip
BOTH = ("we both", "both of us", "we", "my husband and I", "my wife and I", "my partner and I", "the two of us",
        "both parents", "the parents", "they both", "me and my girlfriend", "both residents", "we two")  # fmt: skip
ALONE = ("my wife", "my husband", "one of us", "she", "he", "my partner", "only one of us", "the owner",
 "my girlfriend")
COUPLES = ("two people", "a couple", "a young couple", "a married couple", "two programmers")
SINGLES = ("a programmer", "a translator", "a single person", "somebody", "a freelancer", "a young writer",
 "one person")
JOINTS = ("{H}, {c}.", "{H}. {C}.", "{H}; {c}.", "{C}. {H}.", "{H} - {c}.", "{H} ({c}).", "{H} because {c}.",
          "{C}, so we need a {h}.", "Since {c}, a {h}.", "{H} as {c}.", "We need a {h}, {c}.", "{C}; {h}.",
          "{H}, and {c}.",
          "We are looking for a {h}. {C}.", "I want a flat where {c}. {H}.")  # fmt: skip


def _joined(rng: Rng, clause: str, many: int, language: str = "en", joints: tuple[str, ...] = JOINTS) -> Draw:
    home = one(rng, HOMES[language])
    joint = one(rng, joints)
    text = joint.format(h=home, H=upper(home), c=clause, C=clause and upper(clause))
    return text, Meant(HOMES[language][home], many, home)


def both_work(rng: Rng) -> Draw:
    """`Two-bedroom flat, we both work from home.`"""
    who, verb = one(rng, BOTH), one(rng, VERBS)
    return _joined(rng, f"{who} {verb}{one(rng, OFTEN) if 'week' not in verb and 'full' not in verb else ''}", 2)


def one_works(rng: Rng) -> Draw:
    """`My wife works from home. One-bedroom flat.`"""
    alone = rng.random() < 0.5
    who, verb = ("I", one(rng, MINE)) if alone else (one(rng, ALONE), one(rng, VERB))
    return _joined(rng, f"{who} {verb}{one(rng, OFTEN) if ' week' not in verb and 'full' not in verb else ''}", 1)


WHO_WORK = ("who work from home", "who both work from home", "working from home", "who work remotely",
            "who both telecommute", "that both work at home", "both working from home", "who are working from home",
            "who both have remote jobs", "who work at home most days")  # fmt: skip
WHO_WORKS = ("who works from home", "working from home", "who works remotely", "who telecommutes", "that works at home",
             "who mostly works from home", "who works at home three days a week", "working remotely",
             "with a remote job", "who has a home office job", "who often works from home")  # fmt: skip


def people_who_work(rng: Rng) -> Draw:
    """`Flat of 95 m2 for two people who work at home.`"""
    couple = rng.random() < 0.5
    who = one(rng, COUPLES if couple else SINGLES)
    rel = one(rng, WHO_WORK if couple else WHO_WORKS)
    home = one(rng, HOMES["en"])
    end = one(rng, (".", "", ", please.", ". The kitchen is open."))
    begin = one(rng, ("", "", "I want a ", "Please design a ", "We need a "))
    text = f"{begin}{home if begin else upper(home)} for {who} {rel}{end}"
    return text, Meant(HOMES["en"][home], 2 if couple else 1, f"{home} for {who}{end}")


OTHERS = ("{h} for two remote workers.", "{h} for a couple, both work from home.", "{h} for a couple. Both work "
                                                                                   "at home.",
          "{h} for a work-from-home couple.", "{h} for two people. They both work from home.", "{h} for two, both work "
          "from home.", "A couple that works from home needs a {h}.", "My wife works from home and so do I. {h}.",
          "I work from home and my wife works from home too. {h}.", "{h}. My husband works from home, me too.",
          "{h}. I work from home, my partner too.", "{h} for a couple who work from home and like to cook.",
          "We both work from home and want a {h}.", "We are a couple and work from home. {h}.",
          "{h} for my wife and me, we both work from home.",
          "A {h}, please, with both of us working from home.")  # fmt: skip
OTHER = ("{h} suitable for working from home.", "{h} for remote work.", "{h}, ideal for working from home.",
         "{h} for a remote worker.", "{h} for a remote software developer.", "{h} for working from home.",
         "{h} with a place to work from home.", "I live alone and work from home. {h}.",
         "I work from home and want a {h}.",
         "{h} with space to work from home.", "{h}. One of us works from home, the other goes to the office.",
         "{h}. I work from home, my wife doesn't.", "{h} so that I can work from home.", "{h} set up for remote work.",
         "My husband works from home and I work at the hospital. {h}.", "{h} good for home working.")  # fmt: skip


def in_other_words(rng: Rng) -> Draw:
    """`Two-bedroom flat for two remote workers.`"""
    two = rng.random() < 0.5
    home = one(rng, HOMES["en"])
    frame = one(rng, OTHERS if two else OTHER)
    return upper(frame.format(h=home if frame[0] != "{" else upper(home))), Meant(HOMES["en"][home], 1 + two, "")


NOBODY = ("nobody works at home", "we don't work from home", "I don't work from home", "none of us works from home",
          "neither of us works from home", "I never work from home", "we do not work at home", "no one works from home",
          "I no longer work from home", "we don't need to work from home", "my wife does not work from home",
          "we are not working from home", "I won't work from home")  # fmt: skip
ELSEWHERE = ("{H}. I walk to work from home.", "{H} close to work.", "{H}. We work out at home.",
             "{H}. The kids do their homework at home.", "{H}. Scene for a robot that works at home.",
             "{H}. After work, at home, we cook.",
             "{H}, ten minutes from work.", "{H}. We go to work by bus.", "{H}. Our cleaner works at home.",
             "{H} with a workshop.", "{H}. The heating works.")  # fmt: skip


def nobody_works(rng: Rng) -> Draw:
    """`Nobody works at home. Two-bedroom flat.`"""
    return _joined(rng, one(rng, NOBODY), 0, joints=JOINTS[:5])


def other_things(rng: Rng) -> Draw:
    """`Two-bedroom flat. We work out at home.`"""
    home = one(rng, [h for h in HOMES["en"] if "study" not in h and "office" not in h])
    text = one(rng, ELSEWHERE).format(H=upper(home))
    return text, Meant(HOMES["en"][home], -1, "")


ABROAD: dict[str, dict[int, tuple[str, ...]]] = {
    "de": {
        2: ("wir arbeiten beide im Homeoffice", "wir arbeiten beide von zu Hause", "beide arbeiten von zu Hause aus",
            "wir sind beide im Homeoffice", "meine Frau und ich arbeiten zu Hause", "wir arbeiten zu Hause",
            "wir arbeiten beide drei Tage die Woche im Homeoffice", "die Eltern arbeiten zu Hause",
            "wir beide arbeiten meistens von zu Hause", "wir machen beide Homeoffice"),
        1: ("ich arbeite im Homeoffice", "ich arbeite von zu Hause", "ich arbeite drei Tage die Woche von zu Hause",
            "meine Frau arbeitet im Homeoffice", "einer von uns arbeitet zu Hause", "ich bin oft im Homeoffice",
            "mein Mann arbeitet von zu Hause aus", "ich mache Homeoffice", "ich arbeite meistens zu Hause"),
        0: ("niemand arbeitet zu Hause", "ich arbeite nicht im Homeoffice", "wir arbeiten nicht von zu Hause",
            "keiner von uns arbeitet zu Hause"),
    },
    "fr": {
        2: ("nous travaillons tous les deux à la maison", "nous télétravaillons tous les deux",
            "nous sommes tous les deux en télétravail", "ma femme et moi travaillons à la maison",
            "nous travaillons à domicile", "on travaille tous les deux de chez nous", "nous faisons du télétravail",
            "les deux parents travaillent à la maison"),
        1: ("je travaille à la maison", "je télétravaille", "je suis en télétravail", "ma femme travaille à la maison",
            "je télétravaille trois jours par semaine", "l'un de nous travaille à domicile",
            "je travaille souvent de chez moi", "je fais du télétravail", "mon mari est en télétravail"),
        0: ("personne ne travaille à la maison", "je ne travaille pas à la maison", "nous ne télétravaillons pas",
            "aucun de nous ne travaille à domicile"),
    },
    "es": {
        2: ("los dos trabajamos desde casa", "trabajamos los dos en casa", "ambos trabajamos desde casa",
            "mi mujer y yo trabajamos desde casa", "los dos teletrabajamos", "nosotros trabajamos en casa",
            "trabajamos desde casa", "los padres trabajan desde casa", "los dos hacemos teletrabajo"),
        1: ("trabajo desde casa", "yo trabajo en casa", "mi mujer trabaja desde casa",
            "uno de nosotros trabaja en casa",
            "hago teletrabajo tres días a la semana", "trabajo desde casa tres días a la semana",
            "mi marido teletrabaja", "trabajo en remoto", "trabajo normalmente desde casa"),
        0: ("nadie trabaja en casa", "no trabajo desde casa", "no trabajamos en casa", "no teletrabajamos"),
    },
    "zh": {
        2: ("我们俩都在家办公", "我们两个人都在家工作", "夫妻双方都在家办公", "我和老婆都在家办公", "我们都在家上班",
            "父母都在家办公", "两个人都居家办公", "我们每周三天在家办公"),
        1: ("我在家办公", "我老婆在家办公", "我经常在家工作", "其中一个人在家办公", "我居家办公", "我每周三天在家办公",
            "先生在家上班"),
        0: ("没有人在家办公", "我不在家办公", "我们不需要在家办公", "我们都不在家工作"),
    },
}  # fmt: skip
ABROAD_JOINTS = {"zh": ("{h}，{c}。", "{c}，{h}。", "{h}。{c}。"),
                 "": ("{H}, {c}.", "{H}. {C}.", "{C}. {H}.", "{H}; {c}.")}  # fmt: skip
ABROAD_WHO = {
    "de": (("{H} für zwei Personen, die von zu Hause arbeiten.", "{H} für ein Paar, beide arbeiten im Homeoffice.",
            "{H} für ein Paar im Homeoffice.", "{H} für ein Paar, das zu Hause arbeitet."),
           ("{H} für eine Person, die im Homeoffice arbeitet.",)),
    "fr": (("{H} pour un couple en télétravail.", "{H} pour deux personnes qui travaillent à domicile.",
            "{H} pour un couple qui travaille à la maison."),
           ("{H} pour une personne qui travaille à domicile.", "{H} pour une personne en télétravail.")),
    "es": (("{H} para una pareja que trabaja desde casa.", "{H} para dos personas que trabajan en casa.",
            "{H} para una pareja, los dos trabajan desde casa."),
           ("{H} para una persona que trabaja desde casa.", "{H} para una persona que teletrabaja.")),
}  # fmt: skip


def abroad(rng: Rng) -> Draw:
    """`Wir arbeiten beide im Homeoffice. Zweizimmerwohnung.`"""
    language = one(rng, ABROAD)
    many = int(rng.integers(3))
    if many and language in ABROAD_WHO and rng.random() < 0.25:
        return _joined(rng, "", many, language, ABROAD_WHO[language][0 if many == 2 else 1])
    joints = ABROAD_JOINTS["zh" if language == "zh" else ""]
    return _joined(rng, one(rng, ABROAD[language][many]), many, language, joints)


WORDS = ("work", "home", "remote", "job", "tele", "days", "week", "arbeit", "travail", "trabaj", "homeoffice", "office",
         "two", "both", "办", "工作", "wfh", "time", "pandemic", "wife", "pandem", "bank")  # fmt: skip


@cache
def _rooms(text: str) -> tuple[str, ...]:
    return tuple(room.id for room in read(text).rooms)


def wrong(text: str, meant: Meant) -> str:
    """What is wrong with the reading of a text, "" where nothing is."""
    try:
        program = read(text)
    except BadInput as error:
        return str(error)
    desks = sorted(o.room for o in program.objects if o.category == "desk" for _ in range(o.count))
    if meant.many < 0:
        return f"desks in {desks}" if desks else ""
    places = ((), meant.home.one, meant.home.two)[meant.many]
    wanted = sorted(room for room in places if room != "-")
    if desks != wanted:
        return f"desks in {desks}, not in {wanted}"
    unread = [w for w in program.unread if any(part in w.partition(" (")[0].lower() for part in WORDS)]
    if unread and "-" not in places:
        return f"unread {unread}"
    if "-" in places and not any("no place for" in w for w in program.unread):
        return "a second desk lost in silence"
    rooms = tuple(room.id for room in program.rooms)
    if meant.plain and meant.home not in (_STUDY, _LARGE) and rooms != _rooms(meant.plain):
        return f"rooms {rooms}"
    return ""


@pytest.mark.parametrize("area, studies", [(60, 0), (80, 1), (84, 1), (85, 2), (120, 2)])
def test_two_who_work_at_home_have_a_study_each_where_there_is_floor(area: int, studies: int) -> None:
    program = read(f"flat of {area} m2 for two people who work at home")
    held = Counter({o.room: o.count for o in program.objects if o.category == "desk"})
    assert sum(room.type == "study" for room in program.rooms) == studies
    assert held.total() == 2 and any(room.type == "bedroom" for room in program.rooms)
    assert studies != 2 or held == {"study_1": 1, "study_2": 1}
    alone = read(f"flat of {area} m2 for one person who works at home")
    assert sum(room.type == "study" for room in alone.rooms) == 1


DRAWN: tuple[Callable[[Rng], Draw], ...] = (
    both_work, one_works, people_who_work, in_other_words, nobody_works, other_things, abroad)  # fmt: skip
test_drawn_at_random = as_drawn(DRAWN, wrong, seed=76, draws=10)
