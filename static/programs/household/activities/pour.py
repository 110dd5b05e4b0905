"""Pour a drink into a glass or a cup.

Said with: pour, fill, serve, glass, cup, into.
"""


def pour(drink, vessel):
    # grab the {vessel} and the {drink}
    grab(vessel)
    grab(drink)
