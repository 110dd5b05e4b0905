"""Eat on this seat.

Said with: eat, have, snack, enjoy, munch, nibble, bite.
"""


def eat_on(food, seat):
    # grab the {food}
    grab(food)
    # sit down to eat the {food}
    sit(seat)
    eat(food)
