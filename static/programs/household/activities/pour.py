"""Pour a drink into a glass or a cup."""


def pour(drink, vessel):
    # grab the {vessel} and the {drink}
    grab(vessel)
    grab(drink)
