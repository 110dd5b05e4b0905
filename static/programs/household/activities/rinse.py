"""Rinse a thing under running water."""


def rinse(obj):
    # let the water run
    switchon('faucet')
    # put the {obj} in the sink
    grab(obj)
    put(obj, 'sink | bathroomsink | bathtub')
