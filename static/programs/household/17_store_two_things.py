"""A door is opened before both hands are full."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def store_the_shampoo_and_the_barsoap_in_the_bathroomcabinet():
    # 0: walk to the bathroom
    walk('bathroom')
    # 1: open the bathroomcabinet
    find('bathroomcabinet')
    assert('close' to 'bathroomcabinet')
        else: find('bathroomcabinet')
    assert('bathroomcabinet' is 'opened')
        else: open('bathroomcabinet')
    # 2: grab the shampoo
    find('shampoo')
    assert('close' to 'shampoo')
        else: find('shampoo')
    grab('shampoo')
    # 3: grab the barsoap
    find('barsoap')
    assert('close' to 'barsoap')
        else: find('barsoap')
    grab('barsoap')
    # 4: walk to the bathroomcabinet
    find('bathroomcabinet')
    assert('close' to 'bathroomcabinet')
        else: find('bathroomcabinet')
    # 5: put the shampoo in the bathroomcabinet
    assert('shampoo' in 'hands')
        else: find('shampoo')
        else: grab('shampoo')
    assert('close' to 'bathroomcabinet')
        else: find('bathroomcabinet')
    putin('shampoo', 'bathroomcabinet')
    # 6: put the barsoap in the bathroomcabinet
    assert('barsoap' in 'hands')
        else: find('barsoap')
        else: grab('barsoap')
    assert('close' to 'bathroomcabinet')
        else: find('bathroomcabinet')
    putin('barsoap', 'bathroomcabinet')
    # 7: close the bathroomcabinet
    close('bathroomcabinet')
    # 8: Done
