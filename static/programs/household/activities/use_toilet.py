"""Go to the toilet.

Said with: toilet, restroom, loo, pee, bathroom.
"""


def use_toilet():
    # sit on the toilet
    sit('toilet')
