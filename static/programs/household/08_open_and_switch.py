"""Several small things, one room after the other."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def air_the_bedroom_and_switch_on_the_floorlamp():
    # 0: walk to the bedroom
    walk('bedroom')
    # 1: open the window
    find('window')
    assert('close' to 'window')
        else: find('window')
    assert('window' is 'closed')
        else: close('window')
    open('window')
    # 2: walk to the living room
    walk('livingroom')
    # 3: switch on the floorlamp
    find('floorlamp')
    assert('close' to 'floorlamp')
        else: find('floorlamp')
    assert('floorlamp' is 'switchoff')
        else: switchoff('floorlamp')
    switchon('floorlamp')
    # 4: Done
