"""Take a shower or a bath.

Said with: shower, bath, bathe, yourself.
"""


def take_shower():
    # let the water run
    switchon('shower | faucet')
    # take soap and a towel
    grab('barsoap | shampoo')
    grab('towel')
