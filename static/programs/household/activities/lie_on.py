"""Lie down; here that is to rest on it.

Said with: lie, rest, nap, stretch, lay, sleep.
"""


def lie_on(bed):
    # rest on the {bed}
    sit(bed)
