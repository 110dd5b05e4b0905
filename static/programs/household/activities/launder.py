"""Wash clothes or linen in the washing machine, and take them out again.

Not for: dish, food, cutlery, cookware.
Said with: wash, launder, clean, laundry, washing, dirty.
"""


def launder(clothes):
    # grab the {clothes}
    open('closet ?')
    grab(clothes)
    # put the {clothes} into the washing machine
    open('washingmachine')
    put(clothes, 'washingmachine')
    grab('detergent ?')
    put('detergent ?', 'washingmachine')
    close('washingmachine')
    # wash the {clothes}
    switchon('washingmachine')
    # take the {clothes} out
    switchoff('washingmachine')
    open('washingmachine')
    grab(clothes)
    close('washingmachine')
