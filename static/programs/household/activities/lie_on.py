"""Lie down; here that is to rest on it."""


def lie_on(bed):
    # rest on the {bed}
    sit(bed)
