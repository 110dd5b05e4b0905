"""Drink something: it is in the hand, with a glass.

Said with: drink, sip, have, glass, thirsty.
"""


def drink(drink):
    # grab the {drink}
    grab(drink)
