"""Fry, cook or boil food on the stove; it is held in the end.

Said with: fry, fried, cook, boil, saute, pan, stove, pot.
"""


def fry(food):
    # put the pan on the stove
    grab('fryingpan | cookingpot | pan | pot')
    put('fryingpan | cookingpot | pan | pot', 'stove')
    # put the {food} in the pan
    grab(food)
    put(food, 'fryingpan | cookingpot | pan | pot')
    # cook the {food}
    switchon('stove')
    # take the {food} out
    switchoff('stove')
    grab(food)
