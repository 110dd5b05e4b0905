"""Close a door, a window, curtains, a book or a piece of furniture."""


def close(obj):
    # close the {obj}
    close(obj)
