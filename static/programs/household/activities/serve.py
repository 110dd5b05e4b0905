"""Serve food on the table."""


def serve(food):
    # grab the {food}
    grab(food)
    # serve the {food}
    put(food, 'kitchentable | diningtable | coffeetable | table')
