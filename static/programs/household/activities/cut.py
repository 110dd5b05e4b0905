"""Cut food on the counter with a knife.

Said with: cut, slice, chop, dice, carve, halve, knife, sliced, chopped.
"""


def cut(food):
    # grab a knife and the {food}
    grab('cutleryknife | knife')
    grab(food)
    # cut the {food}
    cut(food)
    put(food, 'cuttingboard | kitchencounter | kitchentable')
    put('cutleryknife | knife', 'cuttingboard | kitchencounter | kitchentable')
