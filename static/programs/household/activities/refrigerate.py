"""Cool food in the fridge.

Said with: fridge, refrigerator, refrigerate, cool, chill, cold, spoil.
"""


def refrigerate(food):
    # grab the {food}
    grab(food)
    # put the {food} in the fridge
    open('fridge | freezer')
    put(food, 'fridge | freezer')
    close('fridge | freezer')
