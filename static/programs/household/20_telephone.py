"""A telephone is used by switching it on."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def ask_the_neighbour_on_the_telephone():
    # 0: walk to the wallphone
    find('wallphone')
    assert('close' to 'wallphone')
        else: find('wallphone')
    # 1: switch on the wallphone
    assert('wallphone' is 'switchoff')
        else: switchoff('wallphone')
    switchon('wallphone')
    # 2: Done
