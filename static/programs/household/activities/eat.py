"""Eat, seated.

Not said with: make breakfast, breakfast ready, prepare breakfast, fix breakfast.
Said with: eat, have, snack, bite, enjoy, munch, taste, nibble, lunch, breakfast, dinner.
"""


def eat(food):
    # grab the {food}
    grab(food)
    # sit down to eat the {food}
    sit('chair | kitchenchair | sofa | bench | armchair')
    eat(food)
