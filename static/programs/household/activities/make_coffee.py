"""Make coffee.

Said with: coffee, caffeine.
"""


def make_coffee():
    # put a cup under the coffee maker
    grab('mug | cup | coffeecup ?')
    put('mug | cup | coffeecup ?', 'coffeemaker | kitchencounter | kitchentable')
    # start the coffee maker
    switchon('coffeemaker | coffeepot | kettle')
    # take the coffee
    grab('coffeepot ?')
    grab('mug | cup | coffeecup ?')
