"""What is read is held, and opened."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def look_something_up_in_the_folder_by_the_window():
    # 0: grab the folder
    find('folder')
    assert('close' to 'folder')
        else: find('folder')
    grab('folder')
    # 1: walk to the window
    find('window')
    assert('close' to 'window')
        else: find('window')
    # 2: open the folder
    assert('folder' in 'hands')
        else: find('folder')
        else: grab('folder')
    assert('folder' is 'opened')
        else: open('folder')
    # 3: read the folder
    # 4: Done
