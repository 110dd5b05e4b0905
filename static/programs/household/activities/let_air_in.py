"""Air the room.

Said with: air, stuffy, ventilate, smells.
"""


def let_air_in():
    # open the window
    open('window')
