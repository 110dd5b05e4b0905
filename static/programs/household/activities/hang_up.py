"""Hang clothes up in the closet.

Said with: hang, closet, wardrobe, hanger.
"""


def hang_up(clothes):
    # grab the {clothes}
    grab(clothes)
    # hang the {clothes} up
    open('closet | wardrobe | dresser')
    put(clothes, 'closet | wardrobe | dresser')
    close('closet | wardrobe | dresser')
