"""Water the plants."""


def water_plants():
    # get water
    switchon('faucet')
    grab('wateringcan | waterglass | mug')
    # go to the plants
    find('plant | orchid | flower')
