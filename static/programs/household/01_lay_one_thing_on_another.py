"""One thing from where it lies to a surface."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def lay_the_newspaper_on_the_nightstand():
    # 0: walk to the living room
    walk('livingroom')
    # 1: find the newspaper
    find('newspaper')
    # 2: grab the newspaper
    assert('close' to 'newspaper')
        else: find('newspaper')
    grab('newspaper')
    # 3: find the nightstand
    find('nightstand')
    # 4: lay the newspaper on the nightstand
    assert('newspaper' in 'hands')
        else: find('newspaper')
        else: grab('newspaper')
    assert('close' to 'nightstand')
        else: find('nightstand')
    putback('newspaper', 'nightstand')
    # 5: Done
