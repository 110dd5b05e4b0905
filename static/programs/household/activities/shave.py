"""Shave."""


def shave():
    # let the water run
    switchon('faucet')
    # grab the razor
    grab('razor')
