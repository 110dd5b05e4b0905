"""Put a thing in or on a place, whichever it is made for."""


def put(obj, place):
    # grab the {obj}
    grab(obj)
    # put the {obj} where it belongs: {place}
    open(place)
    put(obj, place)
    close(place)
