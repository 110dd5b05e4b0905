"""Wash the laundry in the washing machine, and take it out again.

Said with: laundry, washing.
"""


def do_laundry():
    # grab the laundry
    open('closet ?')
    grab('clothespile | clothes | laundry | clothesshirt | shirt | socks | pants')
    # put it into the washing machine
    open('washingmachine')
    put('clothespile | clothes | laundry | clothesshirt | shirt | socks | pants', 'washingmachine')
    close('washingmachine')
    switchon('washingmachine')
    # take it out
    switchoff('washingmachine')
    open('washingmachine')
    grab('clothespile | clothes | laundry | clothesshirt | shirt | socks | pants')
    close('washingmachine')
