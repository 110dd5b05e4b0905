"""Carry a thing to a place and leave it there."""


def bring(obj, place):
    # grab the {obj}
    grab(obj)
    # bring the {obj} to the {place}
    open(place)
    put(obj, place)
    close(place)
