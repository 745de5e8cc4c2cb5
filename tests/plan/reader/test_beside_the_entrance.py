"""Sides of the entrance in German, French and Spanish, areas from one number to another, and lists after a place."""

from sentences.facts import as_meant

SIDES = [
    ("Dos dormitorios, el despacho a la izquierda de la entrada y el baño a la derecha.", "B2 H K L S W",
     "position S1 entrance left, position W1 entrance right"),
    ("Dos dormitorios; al entrar, a la izquierda la cocina y a la derecha el salón.", "B2 H K L W",
     "position K1 entrance left, position L1 entrance right"),
    ("Dos dormitorios, el salón a la derecha de la cocina.", "B2 H K L W", "position L1 K1 right"),
    ("Zwei Schlafzimmer. Links vom Eingang liegt das Bad und rechts die Küche.", "B2 H K L W",
     "position W1 entrance left, position K1 entrance right"),
    ("Wohnung mit Bad rechts vom Eingang und Küche links davon; zwei Schlafzimmer.", "B2 H K L W",
     "position W1 entrance right, position K1 entrance left"),
    ("Deux chambres, le bureau à droite de l'entrée et la cuisine à gauche.", "B2 H K L S W",
     "position S1 entrance right, position K1 entrance left"),
    ("Deux chambres; à gauche en entrant la cuisine, à droite le salon.", "B2 H K L W",
     "position K1 entrance left, position L1 entrance right"),
]  # fmt: skip
BETWEEN = [
    ("Deux chambres, 70 à 80 mètres carrés.", "B2 H K L W", "at_least home 70, at_most home 80"),
    ("Deux chambres de 10 à 12 m² chacune.", "B2 H K L W", "at_least B1 10, at_most B2 12"),
    ("Piso de 50 a 58 m² con un dormitorio.", "B H K L W", "at_least home 50, at_most home 58"),
    ("Drei Zimmer, 70 bis 75 Quadratmeter.", "B2 H K L W", "at_least home 70, at_most home 75"),
]  # fmt: skip
LISTED = [
    ("Tres dormitorios, dos baños que dan al pasillo y un salón con terraza.", "B3 H K L W2 Y", "H1W1, H1W2, !L1W1"),
    ("Zwei Schlafzimmer, Balkon am Wohnzimmer und eine Küche mit Esstisch.", "B2 H K L W Y", "L1Y1, !K1Y1"),
    ("Deux chambres, un séjour donnant sur le balcon et une cuisine fermée.", "B2 H K L W Y", "L1Y1, !K1Y1"),
    ("Ich bin Arzt und brauche ein Schlafzimmer und ein Bad.", "B H K L W", "!K1 has 1 bin"),
]  # fmt: skip

test_sides_of_the_entrance = as_meant(SIDES)
test_areas_between_two_numbers = as_meant(BETWEEN)
test_lists_go_on_behind_a_place = as_meant(LISTED)
