"""Get the garbage out of the house.

Said with: trash, garbage, rubbish, bin.
"""


def take_out_trash():
    # see to the garbage
    open('garbagecan | trashcan | bin')
    grab('garbagebag | trashbag ?')
    # leave through the door and close it
    find('door ?')
    close('door ?')
