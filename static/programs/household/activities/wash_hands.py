"""Wash the hands or the face.

Said with: hand, hands, face, freshen.
"""


def wash_hands():
    # let the water run
    switchon('faucet')
    # take the soap
    grab('barsoap | soap')
    # a towel at hand to dry them
    grab('towel')
