"""Vacuum or sweep the floor.

Said with: vacuum, vacuuming, hoover, sweep, carpet, floor.
"""


def vacuum():
    # grab the vacuum cleaner
    grab('vacuumcleaner | broom | mop')
    # take it to the room
    walk('room ?')
    # switch it on
    switchon('vacuumcleaner ?')
