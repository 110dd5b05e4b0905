"""Bake food in the oven or stove; it stays inside.

Said with: bake, baked, roast, oven.
"""


def bake(food):
    # grab the {food}
    grab(food)
    # bake the {food}
    open('oven | stove')
    put(food, 'oven | stove')
    close('oven | stove')
    switchon('oven | stove')
