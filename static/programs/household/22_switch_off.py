"""One thing that runs is switched off."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def switch_off_the_lamp_on_the_ceiling():
    # 0: walk to the kitchen
    walk('kitchen')
    # 1: switch off the ceilinglamp
    find('ceilinglamp')
    assert('close' to 'ceilinglamp')
        else: find('ceilinglamp')
    switchoff('ceilinglamp')
    # 2: Done
