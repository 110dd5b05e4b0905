"""Eat on this seat."""


def eat_on(food, seat):
    # grab the {food}
    grab(food)
    # sit down to eat the {food}
    sit(seat)
