"""Bring a thing to the person who asks: it is held in the hand.

Not said with: to the, to my, on the, in the, onto the, into the.
"""


def bring_me(obj):
    # grab the {obj}
    grab(obj)
