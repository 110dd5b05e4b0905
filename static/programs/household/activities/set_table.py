"""Set the table for a meal.

Said with: table.
"""


def set_table():
    # a plate
    grab('plate | dishbowl | bowl')
    put('plate | dishbowl | bowl', 'kitchentable | diningtable | table')
    # a fork
    grab('cutleryfork | fork')
    put('cutleryfork | fork', 'kitchentable | diningtable | table')
    # a knife
    grab('cutleryknife | knife ?')
    put('cutleryknife | knife ?', 'kitchentable | diningtable | table')
    # a glass
    grab('waterglass | wineglass | mug ?')
    put('waterglass | wineglass | mug ?', 'kitchentable | diningtable | table')
