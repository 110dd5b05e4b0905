"""Sit down comfortably."""


def relax():
    # sit down
    sit('sofa | armchair | couch | bed')
