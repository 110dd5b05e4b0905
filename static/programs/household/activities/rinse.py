"""Rinse a thing under running water.

Said with: rinse, running, water, wash.
"""


def rinse(obj):
    # let the water run
    switchon('faucet')
    # put the {obj} in the sink
    grab(obj)
    put(obj, 'sink | bathroomsink | bathtub')
