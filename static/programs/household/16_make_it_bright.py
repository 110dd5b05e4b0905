"""The light of a room hangs on its lightswitch."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def make_the_livingroom_bright():
    # 0: walk to the livingroom
    walk('livingroom')
    # 1: switch on the light
    find('lightswitch')
    assert('close' to 'lightswitch')
        else: find('lightswitch')
    switchon('lightswitch')
    # 2: open the curtains
    find('curtains')
    assert('close' to 'curtains')
        else: find('curtains')
    open('curtains')
    # 3: Done
