"""Open a door, a window, curtains, a book or a piece of furniture.

Said with: open, unlock, draw, pull.
"""


def open(obj):
    # open the {obj}
    open(obj)
