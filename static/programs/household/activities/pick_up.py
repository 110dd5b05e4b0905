"""Take a thing into the hand."""


def pick_up(obj):
    # grab the {obj}
    grab(obj)
