"""What nobody wants any more goes into the garbage can."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def throw_away_the_broken_pen():
    # 0: walk to the bedroom
    walk('bedroom')
    # 1: grab the pen
    find('pen')
    assert('close' to 'pen')
        else: find('pen')
    grab('pen')
    # 2: walk to the garbagecan
    find('garbagecan')
    assert('close' to 'garbagecan')
        else: find('garbagecan')
    # 3: open the garbagecan
    assert('garbagecan' is 'opened')
        else: open('garbagecan')
    # 4: put the pen in the garbagecan
    assert('pen' in 'hands')
        else: find('pen')
        else: grab('pen')
    assert('close' to 'garbagecan')
        else: find('garbagecan')
    putin('pen', 'garbagecan')
    # 5: close the garbagecan
    close('garbagecan')
    # 6: Done
