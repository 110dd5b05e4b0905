"""Food is heated in an oven that is closed and on."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def warm_the_bread_in_the_stove():
    # 0: walk to the kitchen
    walk('kitchen')
    # 1: grab the bread
    find('bread')
    assert('close' to 'bread')
        else: find('bread')
    grab('bread')
    # 2: open the stove
    find('stove')
    assert('stove' is 'switchoff')
        else: switchoff('stove')
    assert('stove' is 'opened')
        else: open('stove')
    # 3: put the bread in the stove
    assert('bread' in 'hands')
        else: find('bread')
        else: grab('bread')
    assert('close' to 'stove')
        else: find('stove')
    assert('stove' is 'opened')
        else: open('stove')
    putin('bread', 'stove')
    # 4: close the stove
    close('stove')
    # 5: switch on the stove
    assert('stove' is 'closed')
        else: close('stove')
    switchon('stove')
    # 6: wait until the bread is warm
    # 7: switch off the stove
    assert('stove' is 'switchon')
        else: switchon('stove')
    switchoff('stove')
    # 8: Done
