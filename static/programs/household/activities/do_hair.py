"""Brush or comb the hair."""


def do_hair():
    # grab the brush
    grab('hairbrush | comb | hairproduct')
