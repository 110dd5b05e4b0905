"""A glass of water.

Said with: water, thirsty.
"""


def get_water():
    # grab a glass
    grab('waterglass | glass | mug | cup')
    # fill it
    switchon('faucet')
