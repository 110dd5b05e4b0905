"""Go somewhere.

Said with: go, walk, enter, move, head, come, visit, stand.
"""


def go_to(place):
    # go to the {place}
    walk(place)
