"""Whoever wants something gets it in the hand."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def fetch_me_a_towel():
    # 0: grab the towel
    find('towel')
    assert('close' to 'towel')
        else: find('towel')
    grab('towel')
    # 1: bring the towel to the living room
    assert('towel' in 'hands')
        else: find('towel')
        else: grab('towel')
    walk('livingroom')
    # 2: Done
