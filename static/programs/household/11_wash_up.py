"""Dishes are washed in the sink, with soap and a sponge."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def clean_the_cookingpot():
    # 0: walk to the kitchen
    walk('kitchen')
    # 1: grab the cookingpot
    find('cookingpot')
    assert('close' to 'cookingpot')
        else: find('cookingpot')
    grab('cookingpot')
    # 2: put the cookingpot in the sink
    find('sink')
    assert('close' to 'sink')
        else: find('sink')
    assert('cookingpot' in 'hands')
        else: find('cookingpot')
        else: grab('cookingpot')
    assert('close' to 'sink')
        else: find('sink')
    putin('cookingpot', 'sink')
    # 3: grab the dishsoap
    find('dishsoap')
    assert('close' to 'dishsoap')
        else: find('dishsoap')
    grab('dishsoap')
    # 4: put the dishsoap in the sink
    find('sink')
    assert('close' to 'sink')
        else: find('sink')
    assert('dishsoap' in 'hands')
        else: find('dishsoap')
        else: grab('dishsoap')
    assert('close' to 'sink')
        else: find('sink')
    putin('dishsoap', 'sink')
    # 5: grab the washingsponge
    find('washingsponge')
    assert('close' to 'washingsponge')
        else: find('washingsponge')
    grab('washingsponge')
    # 6: put the washingsponge in the sink
    find('sink')
    assert('close' to 'sink')
        else: find('sink')
    assert('washingsponge' in 'hands')
        else: find('washingsponge')
        else: grab('washingsponge')
    assert('close' to 'sink')
        else: find('sink')
    putin('washingsponge', 'sink')
    # 7: switch on the faucet
    find('faucet')
    assert('close' to 'faucet')
        else: find('faucet')
    assert('faucet' is 'switchoff')
        else: switchoff('faucet')
    switchon('faucet')
    # 8: wash the cookingpot
    # 9: switch off the faucet
    switchoff('faucet')
    # 10: Done
