"""Pour a drink into a glass or a cup.

Said with: pour, fill, serve, glass, cup, into.
Needs: pour.
"""


def pour(drink, vessel):
    # grab the {vessel} and the {drink}
    grab(vessel)
    grab(drink)
    # pour the {drink} into the {vessel}
    pour(drink, vessel)
