"""What is said anew in five languages: counts, sizes, things, behind `no`, `hmm`, `I said … but`, `after all`."""

import pytest
from sentences.facts import as_meant

from apartgen.stages.plan.reader import read

SENTENCES = [
    ("A flat with two bathrooms... hmm, no, just one bathroom, but with a separate guest WC off the hall. One bedroom.",
     "B H K L W2", "H1W1, H1W2"),
    ("Two bedroom flat, I said two balcony before, but I want only one balcony.", "B2 H K L W Y", ""),
    ("First I wanted two bathrooms, but now only one is enough. Three bedrooms.", "B3 H K L W", ""),
    ("Three bedrooms - no, two will do - and one bathroom.", "B2 H K L W", ""),
    ("Three bedrooms - sorry, two - and one bathroom.", "B2 H K L W", ""),
    ("One-bedroom flat. I need a study; my husband too, so make it two studies.", "B H K L S2 W", ""),
    ("One-bedroom flat. I need a study; my husband does too, so make it two studies.", "B H K L S2 W", ""),
    ("Three bedrooms, two bathrooms. Hmm, actually just one bathroom.", "B3 H K L W", "!unread hmm"),
    ("Three bedrooms, two bathrooms. No, one bathroom is fine.", "B3 H K L W", ""),
    ("Before I said two bathrooms. Now I want only one bathroom. Two bedrooms.", "B2 H K L W", ""),
    ("Originally two bathrooms, now three. Four bedrooms.", "B4 H K L W3", ""),
    ("We wanted four bedrooms at first, but three bedrooms is what we can afford.", "B3 H K L W2", ""),
    ("Now we have two bedrooms, but we need three bedrooms.", "B3 H K L W2", ""),
    ("Two bedrooms, one bathroom. Wait, there should be two bathrooms. Both off the hall.", "B2 H K L W2",
     "H1W1, H1W2"),
    ("Two bathrooms, no, one bathroom and one guest WC, three bedrooms.", "B3 H K L W2", "H1W1, H1W2"),
    ("Two bedrooms, each with a balcony - no, three bedrooms.", "B3 H K L W2 Y3", "B3Y3"),
    # what was wanted is not
    ("Two bedrooms, a study, no, no study, and a balcony.", "B2 H K L W Y", ""),
    ("Two bedrooms and a balcony. Hmm, no balcony after all.", "B2 H K L W", ""),
    ("Two bedrooms, a balcony, and a study. Oh wait, no balcony.", "B2 H K L S W", ""),
    ("On second thoughts, leave out the balcony. Two bedrooms.", "B2 H K L W", ""),
    # sizes and things
    ("The kitchen is 10 m², sorry, 12. Two bedrooms.", "B2 H K L W", "K1=12, !unread 12"),
    ("A flat of 80 m², no, 90 m², two bedrooms.", "B2 H K L W", "all=90"),
    ("Two bedrooms of 12 m², better 14 m², and a kitchen.", "B2 H K L W", "B1=14, B2=14"),
    ("One desk in the study, no, two desks. Two bedrooms.", "B2 H K L S W", "S1 has 2 desk"),
    # nothing was said before
    ("Are pets allowed? No, two bedrooms and one bathroom.", "B2 H K L W", ""),
    ("Bedrooms: two. Balcony: no. Study: yes.", "B2 H K L S W", ""),
    ("Three bedrooms, sorry for my english, one guest bedroom with a balcony.", "B4 H K L W2 Y", ""),
    ("I thought of two bedrooms, each 12 m², and one bathroom.", "B2 H K L W", "B1=12, B2=12"),
    ("Two bedrooms, now with a balcony each.", "B2 H K L W Y2", "B1Y1, B2Y2"),
    # other languages
    ("Drei Schlafzimmer und zwei Bäder, nein, doch nur eins.", "B3 H K L W", ""),
    ("Zwei Schlafzimmer, Quatsch, drei Schlafzimmer, ein Bad.", "B3 H K L W", ""),
    ("Drei Zimmer für die Kinder, nein, zwei Kinderzimmer reichen.", "B2 H K L W", ""),
    ("Erst wollten wir zwei Bäder, jetzt reicht eins. Drei Schlafzimmer.", "B3 H K L W", ""),
    ("Zwei Schlafzimmer und ein Arbeitszimmer. Nein, doch kein Arbeitszimmer.", "B2 H K L W", ""),
    ("Trois chambres, non, plutôt deux, et une salle de bain.", "B2 H K L W", ""),
    ("Deux chambres et deux salles de bain, en fait une seule salle de bain.", "B2 H K L W", ""),
    ("Deux chambres et un bureau. Finalement pas de bureau.", "B2 H K L W", ""),
    ("Tres dormitorios, mejor dos, y un baño.", "B2 H K L W", ""),
    ("Quería dos baños, pero ahora con uno basta. Tres dormitorios.", "B3 H K L W", ""),
    ("Dos dormitorios y un balcón. Al final sin balcón.", "B2 H K L W", ""),
    ("三间卧室，不对，两间卧室加一间书房，一个卫生间，书房里放两张书桌", "B2 H K L S W", "S1 has 2 desk"),
    ("两个卫生间，算了，一个卫生间就够了，三间卧室", "B3 H K L W", ""),
    ("两室一厅，不，三室一厅", "B3 H K L W2", ""),
]  # fmt: skip

test_the_programme_is_as_meant = as_meant(SENTENCES)

ANNOUNCED = {
    "three bedrooms, {}two bedrooms": ["no, ", "sorry, ", "hmm, no, ", "oops, ", "or no, ", "hold on, ", "uh, "],
    "drei Schlafzimmer, {}zwei Schlafzimmer": ["nein, ", "ach nein, ", "Moment, ", "ich meine ", "besser ", "äh, "],
    "trois chambres, {}deux chambres": ["non, ", "pardon, ", "enfin non, ", "je veux dire ", "plutôt ", "en fait "],
    "tres dormitorios, {}dos dormitorios": ["no, ", "perdón, ", "digo, ", "mejor ", "quiero decir ", "mejor dicho "],
    "三间卧室，{}两间卧室": ["不对，", "哦不，", "说错了，", "应该是", "改成", "还是"],
}


@pytest.mark.parametrize(("prompt", "words"), [(p, w) for p, several in ANNOUNCED.items() for w in several])
def test_the_second_count_holds(prompt: str, words: str) -> None:
    program = read(prompt.format(words) + ", one bathroom")
    assert sum(room.type == "bedroom" for room in program.rooms) == 2
    assert not program.unread
