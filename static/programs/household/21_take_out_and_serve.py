"""What is taken out of something closed leaves it closed again."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def serve_the_yogurt_from_the_fridge_on_the_kitchencounter():
    # 0: walk to the kitchen
    walk('kitchen')
    # 1: open the fridge
    find('fridge')
    assert('close' to 'fridge')
        else: find('fridge')
    assert('fridge' is 'opened')
        else: open('fridge')
    # 2: grab the yogurt
    find('yogurt')
    assert('close' to 'yogurt')
        else: find('yogurt')
    grab('yogurt')
    # 3: close the fridge
    close('fridge')
    # 4: walk to the kitchencounter
    find('kitchencounter')
    assert('close' to 'kitchencounter')
        else: find('kitchencounter')
    # 5: put the yogurt on the kitchencounter
    assert('yogurt' in 'hands')
        else: find('yogurt')
        else: grab('yogurt')
    assert('close' to 'kitchencounter')
        else: find('kitchencounter')
    putback('yogurt', 'kitchencounter')
    # 6: Done
