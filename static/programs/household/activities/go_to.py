"""Go somewhere."""


def go_to(place):
    # go to the {place}
    walk(place)
