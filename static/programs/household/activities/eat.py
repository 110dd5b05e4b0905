"""Eat, seated."""


def eat(food):
    # grab the {food}
    grab(food)
    # sit down to eat the {food}
    sit('chair | kitchenchair | sofa | bench | armchair')
