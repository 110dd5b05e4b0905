"""Sit down comfortably.

Said with: relax, sit, seat, rest, break, unwind, comfortable.
"""


def relax():
    # sit down
    sit('sofa | armchair | couch | bed')
