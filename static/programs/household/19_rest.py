"""One sits on what is made for it."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def rest_a_while_on_the_chair():
    # 0: walk to the living room
    walk('livingroom')
    # 1: sit on the chair
    find('chair')
    assert('close' to 'chair')
        else: find('chair')
    sit('chair')
    # 2: Done
