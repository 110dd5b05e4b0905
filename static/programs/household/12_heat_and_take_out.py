"""Food is heated in a machine that is closed and on, and taken out."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def steam_the_carrot_in_the_microwave():
    # 0: walk to the kitchen
    walk('kitchen')
    # 1: grab the carrot
    find('carrot')
    assert('close' to 'carrot')
        else: find('carrot')
    grab('carrot')
    # 2: open the microwave
    find('microwave')
    assert('close' to 'microwave')
        else: find('microwave')
    assert('microwave' is 'switchoff')
        else: switchoff('microwave')
    assert('microwave' is 'opened')
        else: open('microwave')
    # 3: put the carrot in the microwave
    assert('carrot' in 'hands')
        else: find('carrot')
        else: grab('carrot')
    assert('close' to 'microwave')
        else: find('microwave')
    putin('carrot', 'microwave')
    # 4: close the microwave
    close('microwave')
    # 5: switch on the microwave
    assert('microwave' is 'closed')
        else: close('microwave')
    switchon('microwave')
    # 6: wait until the carrot are warm
    # 7: switch off the microwave
    switchoff('microwave')
    # 8: take the carrot out of the microwave
    open('microwave')
    grab('carrot')
    # 9: close the microwave
    close('microwave')
    # 10: Done
