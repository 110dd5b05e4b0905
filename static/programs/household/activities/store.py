"""Put a thing away where such things are kept.

Said with: put, store, tidy, clear, stow, away, belongs, back.
"""


def store(obj):
    # grab the {obj}
    grab(obj)
    # put the {obj} away
    open('kitchencabinet | cabinet | closet')
    put(obj, 'kitchencabinet | cabinet | closet')
    close('kitchencabinet | cabinet | closet')
