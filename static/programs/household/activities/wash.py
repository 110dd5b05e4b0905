"""Wash a thing in the sink with soap and a sponge.

Not said with: dishwasher, washing machine.
Not for: clothes, linen, washingmachine, rug, towel, curtains, blanket.
Said with: wash, clean, scrub, washing, dirty, washed.
"""


def wash(obj):
    # let the water run
    switchon('faucet')
    # put the {obj} in the sink
    grab(obj)
    put(obj, 'sink | bathroomsink | bathtub')
    # put soap in the sink
    grab('dishwashingliquid | dishsoap | barsoap ?')
    put('dishwashingliquid | dishsoap | barsoap ?', 'sink | bathroomsink | bathtub')
    # put a sponge in the sink
    grab('washingsponge | sponge ?')
    put('washingsponge | sponge ?', 'sink | bathroomsink | bathtub')
    # wash the {obj}, a towel at hand to dry it
    grab('towel | dishtowel ?')
