"""Two hands carry two things at once."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def carry_the_vase_and_the_magazine_to_the_desk():
    # 0: walk to the living room
    walk('livingroom')
    # 1: grab the vase
    find('vase')
    assert('close' to 'vase')
        else: find('vase')
    grab('vase')
    # 2: grab the magazine
    find('magazine')
    assert('close' to 'magazine')
        else: find('magazine')
    grab('magazine')
    # 3: walk to the desk
    find('desk')
    assert('close' to 'desk')
        else: find('desk')
    # 4: put the vase on the desk
    assert('vase' in 'hands')
        else: find('vase')
        else: grab('vase')
    putback('vase', 'desk')
    # 5: put the magazine on the desk
    assert('magazine' in 'hands')
        else: find('magazine')
        else: grab('magazine')
    putback('magazine', 'desk')
    # 6: Done
