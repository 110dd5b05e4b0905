"""Water the plants.

Said with: plant, plants, flower, flowers, orchid.
"""


def water_plants():
    # get water
    switchon('faucet')
    grab('wateringcan | waterglass | mug')
    # go to the plants
    find('plant | orchid | flower')
