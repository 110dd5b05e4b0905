"""Put a thing beside or near a piece of furniture.

Said with: near, next, beside, by, close.
"""


def put_near(obj, place):
    # grab the {obj}
    grab(obj)
    # leave the {obj} at the {place}
    put(obj, place)
