"""Stand up.

Said with: stand, get up, rise, feet.
"""


def stand_up():
    # stand up
    standup()
