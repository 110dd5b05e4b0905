"""What has no door is not opened."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def stand_the_alarmclock_on_the_bookshelf():
    # 0: walk to the bedroom
    walk('bedroom')
    # 1: grab the alarmclock
    find('alarmclock')
    assert('close' to 'alarmclock')
        else: find('alarmclock')
    grab('alarmclock')
    # 2: find the bookshelf
    find('bookshelf')
    assert('close' to 'bookshelf')
        else: find('bookshelf')
    # 3: put the alarmclock on the bookshelf
    assert('alarmclock' in 'hands')
        else: find('alarmclock')
        else: grab('alarmclock')
    assert('close' to 'bookshelf')
        else: find('bookshelf')
    putback('alarmclock', 'bookshelf')
    # 4: Done
