"""Air the room."""


def let_air_in():
    # open the window
    open('window')
