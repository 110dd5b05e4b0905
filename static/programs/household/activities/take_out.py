"""Take a thing out of what it is in, and hold it.

Said with: out, from, remove, unpack, inside.
"""


def take_out(obj, container):
    # open the {container}
    open(container)
    # take the {obj} out
    grab(obj)
    # close the {container}
    close(container)
