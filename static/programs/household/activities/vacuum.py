"""Vacuum or sweep the floor."""


def vacuum():
    # grab the vacuum cleaner
    grab('vacuumcleaner | broom | mop')
    # switch it on
    switchon('vacuumcleaner ?')
