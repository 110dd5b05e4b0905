"""Go to the toilet."""


def use_toilet():
    # sit on the toilet
    sit('toilet')
