"""Open a door, a window, curtains, a book or a piece of furniture."""


def open(obj):
    # open the {obj}
    open(obj)
