"""Warm food up in this appliance; it is held in the end.

Said with: heat, warm, hot, heated, warmed, reheat, microwave, oven, stove.
"""


def heat_in(food, appliance):
    # grab the {food}
    grab(food)
    # warm the {food} in the {appliance}
    switchoff(appliance)
    open(appliance)
    put(food, appliance)
    close(appliance)
    switchon(appliance)
    # take the {food} out
    switchoff(appliance)
    open(appliance)
    grab(food)
    close(appliance)
