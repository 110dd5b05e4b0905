"""Drink something: it is in the hand, with a glass."""


def drink(drink):
    # grab the {drink}
    grab(drink)
