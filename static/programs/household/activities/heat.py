"""Warm food up; it is held in the end.

Said with: heat, warm, microwave, reheat, hot, nuke, zap, heated, warmed.
"""


def heat(food):
    # grab the {food}
    grab(food)
    # warm the {food}
    switchoff('microwave | oven')
    open('microwave | oven')
    put(food, 'microwave | oven')
    close('microwave | oven')
    switchon('microwave | oven')
    # take the {food} out
    switchoff('microwave | oven')
    open('microwave | oven')
    grab(food)
    close('microwave | oven')
