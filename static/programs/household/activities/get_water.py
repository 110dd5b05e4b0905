"""A glass of water."""


def get_water():
    # grab a glass
    grab('waterglass | glass | mug | cup')
    # fill it
    switchon('faucet')
