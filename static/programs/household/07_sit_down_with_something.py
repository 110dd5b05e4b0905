"""Who wants to sit takes along what is needed, since nobody walks sitting."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def sit_on_the_bed_with_the_notebook():
    # 0: walk to the living room
    walk('livingroom')
    # 1: grab the notebook
    find('notebook')
    assert('close' to 'notebook')
        else: find('notebook')
    grab('notebook')
    # 2: walk to the bedroom
    walk('bedroom')
    # 3: sit on the bed
    find('bed')
    assert('notebook' in 'hands')
        else: find('notebook')
        else: grab('notebook')
    assert('close' to 'bed')
        else: find('bed')
    sit('bed')
    # 4: Done
