"""Shave.

Said with: shave, beard, razor.
"""


def shave():
    # let the water run
    switchon('faucet')
    # grab the razor
    grab('razor')
