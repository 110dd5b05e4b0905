"""Sit down."""


def sit_on(seat):
    # sit on the {seat}
    sit(seat)
