"""A machine is filled, closed, run, and emptied when it is off."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def launder_the_socks():
    # 0: walk to the bathroom
    walk('bathroom')
    # 1: open the washingmachine
    find('washingmachine')
    assert('close' to 'washingmachine')
        else: find('washingmachine')
    assert('washingmachine' is 'opened')
        else: open('washingmachine')
    # 2: grab the socks
    find('socks')
    assert('close' to 'socks')
        else: find('socks')
    grab('socks')
    # 3: put the socks in the washingmachine
    find('washingmachine')
    assert('socks' in 'hands')
        else: find('socks')
        else: grab('socks')
    assert('washingmachine' is 'opened')
        else: open('washingmachine')
    putin('socks', 'washingmachine')
    # 4: close the washingmachine
    assert('close' to 'washingmachine')
        else: find('washingmachine')
    close('washingmachine')
    # 5: switch on the washingmachine
    assert('washingmachine' is 'closed')
        else: close('washingmachine')
    switchon('washingmachine')
    # 6: wait for the washingmachine to finish
    # 7: switch off the washingmachine
    assert('washingmachine' is 'switchon')
        else: switchon('washingmachine')
    switchoff('washingmachine')
    # 8: grab the socks
    open('washingmachine')
    assert('washingmachine' is 'opened')
        else: open('washingmachine')
    grab('socks')
    # 9: close the washingmachine
    close('washingmachine')
    # 10: Done
