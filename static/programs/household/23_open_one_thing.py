"""One thing is opened, and that is all."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def open_the_nightstand():
    # 0: walk to the bedroom
    walk('bedroom')
    # 1: open the nightstand
    find('nightstand')
    assert('close' to 'nightstand')
        else: find('nightstand')
    assert('nightstand' is 'closed')
        else: close('nightstand')
    open('nightstand')
    # 2: Done
