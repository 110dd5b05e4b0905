"""Cool food in the fridge.

Not said with: am cold, i'm cold, feel cold, feeling cold, it is cold, it's cold, so cold, cold in.
Said with: fridge, refrigerator, refrigerate, cool, chill, cold, spoil.
"""


def refrigerate(food):
    # grab the {food}
    grab(food)
    # put the {food} in the fridge
    open('fridge | freezer')
    put(food, 'fridge | freezer')
    close('fridge | freezer')
