"""Serve food on the table.

Said with: serve, dinner, table, guests.
"""


def serve(food):
    # grab the {food}
    grab(food)
    # serve the {food}
    put(food, 'kitchentable | diningtable | coffeetable | table')
