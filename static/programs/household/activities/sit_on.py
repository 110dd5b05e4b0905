"""Sit down.

Said with: sit, seat, seated, sat.
"""


def sit_on(seat):
    # sit on the {seat}
    sit(seat)
