"""Brush or comb the hair.

Said with: hair.
"""


def do_hair():
    # grab the brush
    grab('hairbrush | comb | hairproduct')
