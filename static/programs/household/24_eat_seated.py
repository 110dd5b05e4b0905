"""Who eats sits, with the food in the hand."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def nibble_the_apple_in_the_bed():
    # 0: grab the apple
    find('apple')
    assert('close' to 'apple')
        else: find('apple')
    grab('apple')
    # 1: sit on the bed
    find('bed')
    assert('close' to 'bed')
        else: find('bed')
    assert('apple' in 'hands')
        else: find('apple')
        else: grab('apple')
    sit('bed')
    # 2: nibble the apple
    # 3: Done
