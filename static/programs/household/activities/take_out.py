"""Take a thing out of what it is in, and hold it."""


def take_out(obj, container):
    # open the {container}
    open(container)
    # take the {obj} out
    grab(obj)
    # close the {container}
    close(container)
