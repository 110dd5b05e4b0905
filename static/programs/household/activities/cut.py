"""Cut food on the counter with a knife."""


def cut(food):
    # grab a knife and the {food}
    grab('cutleryknife | knife')
    grab(food)
    # cut the {food}
    put(food, 'cuttingboard | kitchencounter | kitchentable')
    put('cutleryknife | knife', 'cuttingboard | kitchencounter | kitchentable')
