"""Bring a thing to the person who asks: it is held in the hand."""


def bring_me(obj):
    # grab the {obj}
    grab(obj)
