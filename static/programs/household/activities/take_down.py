"""Take down what hangs or stands up there, and hold it.

Said with: down, off, remove, unhang, wall.
"""


def take_down(obj):
    # take the {obj} down
    grab(obj)
