"""What a heading or an unusual `not` denies is not planned."""

import pytest
from sentences.facts import as_meant

from apartgen.stages.plan.reader.excluded import excluded

DENIED = [
    ("A two-bedroom flat. I not need a balcony.", "B2 H K L W", ""),
    ("A two-bedroom flat, we no want a balcony and not need storage.", "B2 H K L W", ""),
    ("Two bedrooms. My family not need a second bathroom.", "B2 H K L W", ""),
    ("Two bedrooms. The flat must not have a balcony, a dining room or a study.", "B2 H K L W", ""),
    ("Two bedrooms. The flat should not have a balcony.", "B2 H K L W", ""),
    ("Must have:\n  - one bedroom\n  - bathroom near the entrance\nMust not have:\n  - a balcony\n  - a dining room",
     "B H K L W", "near W1 entrance"),
    ("We want two bedrooms.\nWe don't want:\n- a balcony\n- a study", "B2 H K L W", ""),
    ("Excluded:\n* balcony\n* study\nIncluded:\n* two bedrooms\n* one bathroom", "B2 H K L W", ""),
    ("Two bedrooms. The flat must not have: a balcony, a study and a dining room.", "B2 H K L W", ""),
    ("Must not have: balcony, study. Must have: two bedrooms, one bathroom.", "B2 H K L W", ""),
    ("Two bedrooms. Must not have: a door between kitchen and living room.", "B2 H K L W",
     "no_door K1 L1"),
    ("Wohnung mit zwei Schlafzimmern.\nOhne:\n- Balkon\n- Esszimmer", "B2 H K L W", ""),
    ("Zwei Schlafzimmer. Nicht erwünscht: Balkon, Esszimmer und Arbeitszimmer.", "B2 H K L W", ""),
    ("Deux chambres. Sans : un balcon, un bureau.", "B2 H K L W", ""),
    ("Dos dormitorios. No queremos: balcón, comedor ni despacho.", "B2 H K L W", ""),
    ("The home must not have any of these: a balcony; a study.", "B2 H K L W", ""),
    ("Two bedrooms. I want none of these: balcony; terrace; dining room.", "B2 H K L W", ""),
    ("Two bedrooms. We need none of the following rooms: study, dining room.", "B2 H K L W", ""),
    ("I want none of the following; a balcony; a dining room. Two bedrooms.", "B2 H K L W", ""),
    ("Two bedrooms. No: balcony; study; dining room.", "B2 H K L W", ""),
    ("Without: a balcony; two bedrooms, one bathroom.", "B2 H K L W", ""),
    ("Zwei Schlafzimmer. Nichts davon: Balkon, Arbeitszimmer.", "B2 H K L W", ""),
    ("Deux chambres. Aucun des éléments suivants : balcon, bureau.", "B2 H K L W", ""),
    ("Dos dormitorios. Nada de esto: balcón; despacho.", "B2 H K L W", ""),
    ("两室一厅，不要以下任何一个：阳台；书房。", "B2 H K L W", ""),
]  # fmt: skip


test_what_is_denied_is_not_planned = as_meant(DENIED)


@pytest.mark.parametrize("text", ["two bedrooms, no balcony", "the hall must not have a door to the kitchen: a wall",
                                  "without 3: two"])  # fmt: skip
def test_text_without_such_a_heading_stays(text):
    assert excluded(text) == text
