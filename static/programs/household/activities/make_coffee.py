"""Make coffee.

Said with: coffee, caffeine.
"""


def make_coffee():
    # start the coffee maker
    switchon('coffeemaker | coffeepot | kettle')
    # have a cup and the coffee at hand
    grab('coffeepot ?')
    grab('mug | cup | coffeecup ?')
