"""Make toast of bread.

Said with: toast, toasted, toaster.
"""


def toast(food):
    # grab the {food}
    grab(food)
    # toast the {food}
    put(food, 'toaster')
    switchon('toaster')
