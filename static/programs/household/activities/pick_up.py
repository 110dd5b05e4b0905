"""Take a thing into the hand.

Not said with: to the, to my, on the, in the, onto the, into the.
"""


def pick_up(obj):
    # grab the {obj}
    grab(obj)
