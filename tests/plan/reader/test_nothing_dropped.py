"""Nothing that bears meaning is dropped in silence: words are read, corrected, listed with their clause, or refused."""

import logging

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sentences import cases

from apartgen.schemas.errors import BadInput, Unmet
from apartgen.stages.plan.reader import read
from apartgen.stages.plan.reader.about import about
from apartgen.stages.plan.reader.home_working import working_at_home
from apartgen.stages.plan.reader.known_words import in_known_words
from apartgen.stages.plan.reader.lexemes import lexemes
from apartgen.stages.plan.reader.lexicon import read_lexicon
from apartgen.stages.plan.reader.people import housed
from apartgen.stages.plan.reader.tokens import tokenize

FUNCTION = frozenset(
    """
    exactly precisely
    a ab about above access accommodation account accounts actually add additionally after ah ahead al all also
    am an and another any approx approximately aproximadamente apt are around arrange arranged arrangement as at
    au auf aus aux average basic be beautiful beautifully bedroomed been being bitte both brauche brauchen
    briefly build but by ca called can cherche circa classic configuration connected connects consist consists
    could cover covering covers create d dans dazu de decent del depuis der des desde design directly do does
    door doors draw each eine either elle en enough enter entered entering entwerfe environ environment es est
    etwa exist exists fairly favor feature features fills find floor for from fur generate gern gerne get gets
    gibt give good grundriss guess had has hatte have having hay he hello her hi his how i i'd i'm i've ich if
    il im imagine in inside into is ist it it's its je just kind la layout lead leading leads let let's lie
    liegen liegt lies like little living lo located look looking love lovely main make makes man may me measure
    measures measuring medium metros mid mochte mochten must my necesito need nice none normal normale not nous
    number occupies occupy occupying of off on one ones only onto open opening openings opens or ordinary other
    others our out overall own para per picture place placed plait plan plane plano please pls plus plz por
    possible pour presented private proper proportioned put que qui quiero quisiera quite rather reach reached
    reaches really regular respectively roughly s s'il same say se set setup shall shape shaped shapes share she
    should show side simple sind single sit sits situated size sized so soll sollen some standard stands start
    starting starts storey straight straightforward style such suche suitable sur surface take takes taking than
    thank thanks that that's the their them then there there's these they this those through to too total turn
    type typical um und unos up us use used using usual very veux via von voudrais vous want wants was way we
    we'd we're well were what when where which while who whose will wir with within would x yes you your zu zum
    zur
    """.split()
)
"""Words without a meaning of their own, politeness and praise; written without a look at the lexicon's."""
WHOSE = frozenset(
    """
    single one level levels floor storey story blocking out user users user's player players player's robot robots
    robot's agent agents agent's request requests asked asks produce return returns constraint constraints requirement
    requirements specification brief target objectnav pointnav procthor navigation rearrangement manipulation pick
    embodied vision language mobile multi search exploration episode episodes benchmark benchmarks task tasks
    experiment experiments dataset research simulation simulator evaluate game games heist safehouse zombie horror
    farming puzzle mystery adventure stealth noir board video computer vr survival escape life sim sitcom wait able
    test demo example sample starter needed wanted required necessary itself themselves
    scene scenes map maps goal household simulated evaluation tutorial residential interactive horizon multi sims
    sim2real vln qa audio visual boss fight fights mission click detective shooter dungeon idea management strategy
    searching guests
    """.split()
)
"""Words for who asks, for whom and with what; a home of one storey is what every plan is."""
SAMPLE = [case.prompt for case in cases("tune")]


def test_a_word_of_meaning_is_read_or_listed() -> None:
    lexicon, seen = read_lexicon(), 0
    for prompt in SAMPLE[::2]:
        unread = " ".join(read(prompt).unread).lower()
        for word in lexemes(tokenize(about(housed(in_known_words(working_at_home(prompt)[1]))[1])[1]), lexicon):
            if word.kind not in ("stop", "adjective", "unknown") or not word.text.isascii():
                continue
            for part in word.text.replace(" - ", " ").split():
                seen += 1
                assert part in FUNCTION | WHOSE or len(part) < 2 or part in unread, (part, prompt)
    assert seen > len(SAMPLE) / 4, "too few words looked at to say anything"


INVENTED = ("helipad", "aquarium", "zeppelin", "vineyard", "turntable", "waterwheel", "observatory", "blacksmith")


@settings(max_examples=80, deadline=None)
@given(st.sampled_from(SAMPLE), st.sampled_from(INVENTED), st.booleans())
def test_a_word_that_no_plan_knows_is_listed_wherever_it_stands(prompt: str, word: str, first: bool) -> None:
    said = f"With a {word}. {prompt}" if first else f"{prompt.rstrip(' .')}, with a {word}"
    try:
        assert any(entry.startswith(f"{word} (in: ") for entry in read(said).unread), said
    except Unmet:
        return


@pytest.mark.parametrize(
    ("prompt", "word", "why"),
    [
        ("a two-storey house with three bedrooms", "two-storey", "one storey"),
        ("two-bedroom flat with stairs up to a mezzanine", "stairs", "one storey"),
        ("a duplex with three bedrooms", "duplex", "one storey"),
        ("zweigeschossige Wohnung mit zwei Schlafzimmern", "zweigeschossige", "one storey"),
        ("appartement avec deux chambres et un escalier", "escalier", "one storey"),
        ("piso de dos plantas con dos dormitorios", "dos plantas", "one storey"),
        ("三室两厅的复式", "复式", "one storey"),
        ("two bedrooms and a gallery overlooking the living room", "gallery overlooking", "one storey"),
        ("two-bedroom flat with bay windows in the lounge", "bay windows", "straight"),
        ("two-bedroom flat with level thresholds", "level thresholds", "flush"),
        ("two-bedroom flat reached by lift", "lift", "no lift"),
        ("two-bedroom flat with high ceilings", "high ceilings", "one height"),
    ],
)
def test_what_a_plan_cannot_have_is_named_with_the_reason(prompt: str, word: str, why: str) -> None:
    entry = next((entry for entry in read(prompt).unread if entry.startswith(word + " (")), "")
    assert why in entry, read(prompt).unread


@pytest.mark.parametrize(("prompt", "entry"), [
    ("two-bedroom flat without stairs", "stairs (as wished: a plan has one storey"),
    ("single-storey flat with two bedrooms, no lift", "lift (as wished: a plan has no lift"),
])  # fmt: skip
def test_what_nobody_wants_and_no_plan_has_is_told_as_wished(prompt: str, entry: str) -> None:
    assert [told.partition(";")[0] for told in read(prompt).unread] == [entry]


def test_one_storey_is_what_every_plan_has() -> None:
    assert read("single-storey flat with two bedrooms").unread == []


@pytest.mark.parametrize(
    "prompt",
    [
        "Appartamento con due camere da letto, cucina e bagno",
        "Vorrei un appartamento con soggiorno, cucina abitabile e balcone",
        "apartamento com dois quartos, cozinha, sala e um banheiro",
        "Quero uma casa com três quartos e uma varanda grande",
        "Appartement met twee slaapkamers, een keuken en een badkamer",
        "Ik wil een huis met drie slaapkamers en een grote woonkamer",
        "Mieszkanie z dwiema sypialniami, kuchnią i łazienką",
        "Trzypokojowe mieszkanie z balkonem i dużą kuchnią",
        "2LDKのマンション、キッチンとバスルーム",
        "寝室が二つある部屋",
        "квартира с двумя спальнями и кухней",
        "en lägenhet med två sovrum och ett kök",
        "침실 두 개와 부엌이 있는 아파트",
        "διαμέρισμα με δύο υπνοδωμάτια και κουζίνα",
        "iki yatak odalı bir daire ve büyük bir mutfak",
        "xqzv wkrtp",
    ],
)
def test_a_language_it_does_not_know_is_refused(prompt: str) -> None:
    with pytest.raises(BadInput, match="language not understood"):
        read(prompt)


@pytest.mark.parametrize(
    "prompt",
    [
        "Zweizimmerwohnung mit Balkon",
        "appartement de deux chambres avec une cuisine ouverte",
        "piso de tres dormitorios con terraza",
        "三室两厅一厨两卫",
        "2bhk",
        "Our twins love astronomy, grandmother paints watercolours; two bedrooms, please",
        "An oak-panelled Edwardian apartment near Hampstead with three bedrooms",
        "thre bedrom falt with a kichen and a livng room",
        "pied-à-terre with a studio kitchen",
    ],
)
def test_languages_it_knows_are_read(prompt: str) -> None:
    assert len(read(prompt).rooms) > 1


@pytest.mark.parametrize(
    ("wrong", "right"),
    [("kitcen", "kitchen"), ("bathrom", "bathroom"), ("balconny", "balcony"), ("sutdy", "study")],
)
def test_a_slip_is_corrected_with_a_message(wrong: str, right: str, caplog: pytest.LogCaptureFixture) -> None:
    text = "two-bedroom flat with a {} and a living room"
    with caplog.at_level(logging.WARNING, logger="apartgen"):
        said = read(text.format(wrong))
    assert f'"{wrong}" as "{right}"' in caplog.text
    assert said.model_dump() == read(text.format(right)).model_dump()


FOOT = 0.3048


@pytest.mark.parametrize(
    ("prompt", "room", "sides"),
    [
        ("two bedrooms, living room 5 x 6 m", "living_room_1", (5, 6)),
        ("two bedrooms, the kitchen is 14 by 12 feet", "kitchen_1", (14 * FOOT, 12 * FOOT)),
        ("two bedrooms, kitchen 12'6\" x 10'", "kitchen_1", (12.5 * FOOT, 10 * FOOT)),
        ("two bedrooms, kitchen 12’6” x 10’3”", "kitchen_1", (12.5 * FOOT, 10.25 * FOOT)),
        ("two bedrooms, study: 9 ft 6 in x 8 ft", "study_1", (9.5 * FOOT, 8 * FOOT)),
        ("one bedroom 420 x 350 cm and a kitchen", "bedroom_1", (4.2, 3.5)),
        ("There is a study. It is 3.5m x 4m. Two bedrooms.", "study_1", (3.5, 4)),
    ],
)
def test_dimensions_are_those_of_the_room_just_named(prompt: str, room: str, sides: tuple[float, float]) -> None:
    program = read(prompt)
    found = [r for r in program.requirements if r.kind == "dimension"]
    assert [r.of for r in found] == [room] and found[0].met is None and found[0].text
    assert [float(x) for x in str(found[0].value).split(" x ")] == pytest.approx(sides, abs=0.006)
    assert next(r.area for r in program.rooms if r.id == room) == pytest.approx(sides[0] * sides[1], rel=0.005)
    assert program.total_area is None


def test_it_is_the_room_of_the_sentence_before() -> None:
    program = read("There is a pantry by the kitchen. It measures 30 square feet. Two bedrooms.")
    assert next(r.area for r in program.rooms if r.type == "storage") == pytest.approx(30 * FOOT**2, rel=0.005)
    assert program.total_area is None
    assert read("A two-bedroom flat. It measures 60 m².").total_area == 60


@pytest.mark.parametrize(
    ("prompt", "wanted"),
    [
        ("two bedrooms, kitchen to the north", [("position", "kitchen_1", None, "north")]),
        ("one bedroom, living room facing south", [("orientation", "living_room_1", None, "south")]),
        ("one bedroom in the south-east corner", [("position", "bedroom_1", None, "south_east")]),
        ("The bathroom is on the left and the kitchen at the back. One bedroom.",
         [("position", "bathroom_1", None, "left"), ("position", "kitchen_1", None, "back")]),
        ("On the right there is a bathroom, at the back a kitchen. One bedroom.",
         [("position", "bathroom_1", None, "right"), ("position", "kitchen_1", None, "back")]),
        ("Two bedrooms and a kitchen. The kitchen is near the entrance.", [("near", "kitchen_1", "entrance", None)]),
        ("one-bedroom flat, the bedroom far from the front door", [("apart", "bedroom_1", "entrance", None)]),
        ("one-bedroom flat with a study next to the bedroom", [("adjacent", "study_1", "bedroom_1", None)]),
        ("one-bedroom flat; the bedroom is away from the kitchen", [("apart", "bedroom_1", "kitchen_1", None)]),
        ("one-bedroom flat; the bath is not next to the kitchen", [("apart", "bathroom_1", "kitchen_1", None)]),
        ("one-bedroom flat; the bathroom opposite the bedroom", [("opposite", "bathroom_1", "bedroom_1", None)]),
        ("Zwei Zimmer, Küche, Bad; das Schlafzimmer nach Norden", [("orientation", "bedroom_1", None, "north")]),
        ("appartement avec une chambre, cuisine au nord", [("position", "kitchen_1", None, "north")]),
        ("piso de un dormitorio con cocina al norte", [("position", "kitchen_1", None, "north")]),
        ("一室一厅，卧室朝南", [("orientation", "bedroom_1", None, "south")]),
    ],
)  # fmt: skip
def test_places_and_neighbours_are_requirements(
    prompt: str, wanted: list[tuple[str, str, str | None, str | None]]
) -> None:
    program = read(prompt)
    assert [(r.kind, r.of, r.to, r.value) for r in program.requirements] == wanted
    assert program.unread == [] and all(r.text and r.met is None for r in program.requirements)


@pytest.mark.parametrize(
    ("prompt", "listed"),
    [
        ("one bedroom, ceiling height 3 m", ["ceiling height", "3 m"]),
        ("a bed of 1.6 m in the bedroom, a kitchen", ["1.6 m"]),
        ("one bedroom, a corridor 1.2 m high", ["1.2 m", "high"]),
        ("a quiet one-bedroom flat", ["quiet"]),
        ("one-bedroom flat of 60 m², 75 m²", ["75 m²"]),
    ],
)
def test_numbers_and_words_of_other_uses_are_listed(prompt: str, listed: list[str]) -> None:
    assert [entry.split(" (")[0] for entry in read(prompt).unread] == listed


def test_a_side_said_of_a_room_is_no_party_wall() -> None:
    program = read("two-bedroom flat, party walls to the east, balcony to the west")
    assert program.envelope.party_walls == ["east"]
    assert [(r.kind, r.of, r.value) for r in program.requirements] == [("position", "balcony_1", "west")]


def test_dimensions_of_the_whole_are_those_of_the_home() -> None:
    program = read("A 10 x 8 m flat with one bedroom")
    assert program.total_area == 80
    assert [(r.kind, r.of, r.value) for r in program.requirements] == [("dimension", "home", "10 x 8")]


@pytest.mark.parametrize("prompt", ["couple", "15% Abstellraum", "0 % kitchen, a bedroom"])
def test_a_share_or_a_household_alone_makes_a_home(prompt: str) -> None:
    assert all((room.area or 0) > 0 for room in read(prompt).rooms)
