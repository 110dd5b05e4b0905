"""Throw a thing into the garbage."""


def throw_away(obj):
    # grab the {obj}
    grab(obj)
    # throw the {obj} away
    open('garbagecan | trashcan | bin')
    put(obj, 'garbagecan | trashcan | bin')
    close('garbagecan | trashcan | bin')
