"""Wash the dishes in the dishwasher or in the sink.

Said with: dish, dishes, washing up, wash up.
"""


def wash_dishes():
    # gather the dishes
    grab('plate | dishbowl | bowl')
    open('dishwasher | sink')
    put('plate | dishbowl | bowl', 'dishwasher | sink')
    close('dishwasher ?')
    switchon('dishwasher | faucet')
