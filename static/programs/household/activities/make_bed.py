"""Make the bed.

Said with: bed.
"""


def make_bed():
    # put the pillow on the bed
    grab('pillow')
    put('pillow', 'bed')
