"""Make toast of bread."""


def toast(food):
    # grab the {food}
    grab(food)
    # toast the {food}
    put(food, 'toaster')
    switchon('toaster')
