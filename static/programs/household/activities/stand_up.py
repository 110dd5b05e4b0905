"""Stand up."""


def stand_up():
    # stand up
    standup()
