"""Brush the teeth.

Said with: teeth, tooth.
"""


def brush_teeth():
    # let the water run
    switchon('faucet')
    # grab the toothpaste and the toothbrush
    grab('toothpaste')
    grab('toothbrush')
