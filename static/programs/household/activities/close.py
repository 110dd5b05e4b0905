"""Close a door, a window, curtains, a book or a piece of furniture.

Said with: close, shut, closed, draw, push.
"""


def close(obj):
    # close the {obj}
    close(obj)
