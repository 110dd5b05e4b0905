"""What is small is taken along and switched on."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def use_the_cellphone_as_a_light():
    # 0: grab the cellphone
    find('cellphone')
    assert('close' to 'cellphone')
        else: find('cellphone')
    grab('cellphone')
    # 1: switch on the cellphone
    assert('cellphone' in 'hands')
        else: find('cellphone')
        else: grab('cellphone')
    assert('cellphone' is 'switchoff')
        else: switchoff('cellphone')
    switchon('cellphone')
    # 2: Done
