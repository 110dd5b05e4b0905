"""What is closed is opened first and closed again, and a hand is free for it."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def store_the_cheese_in_the_kitchencabinet():
    # 0: walk to the kitchen
    walk('kitchen')
    # 1: open the fridge
    find('fridge')
    assert('close' to 'fridge')
        else: find('fridge')
    assert('fridge' is 'opened')
        else: open('fridge')
    # 2: grab the cheese
    find('cheese')
    assert('close' to 'cheese')
        else: find('cheese')
    grab('cheese')
    # 3: close the fridge
    assert('close' to 'fridge')
        else: find('fridge')
    close('fridge')
    # 4: open the kitchencabinet
    find('kitchencabinet')
    assert('close' to 'kitchencabinet')
        else: find('kitchencabinet')
    assert('kitchencabinet' is 'opened')
        else: open('kitchencabinet')
    # 5: put the cheese in the kitchencabinet
    assert('cheese' in 'hands')
        else: find('cheese')
        else: grab('cheese')
    assert('kitchencabinet' is 'opened')
        else: open('kitchencabinet')
    putin('cheese', 'kitchencabinet')
    # 6: close the kitchencabinet
    assert('close' to 'kitchencabinet')
        else: find('kitchencabinet')
    close('kitchencabinet')
    # 7: Done
