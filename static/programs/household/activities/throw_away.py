"""Throw a thing into the garbage.

Said with: throw, away, out, trash, garbage, dispose, rid, bin, discard, toss, chuck, dump, rotten, bad.
"""


def throw_away(obj):
    # grab the {obj}
    grab(obj)
    # throw the {obj} away
    open('garbagecan | trashcan | bin')
    put(obj, 'garbagecan | trashcan | bin')
    close('garbagecan | trashcan | bin')
