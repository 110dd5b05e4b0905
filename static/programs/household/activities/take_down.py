"""Take down what hangs or stands up there, and hold it."""


def take_down(obj):
    # take the {obj} down
    grab(obj)
