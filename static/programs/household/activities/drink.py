"""Drink something, from the hand.

Needs: drink.
Said with: drink, sip, have, glass, thirsty.
"""


def drink(drink):
    # grab the {drink}
    grab(drink)
    # drink the {drink}
    drink(drink)
