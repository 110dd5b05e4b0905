"""Wash a thing in a washing machine, a dishwasher or the like.

Not for: washingmachine.
Said with: wash, clean, run, start, machine, dishwasher, sink, load, use.
"""


def wash_in(obj, machine):
    # grab the {obj}
    grab(obj)
    # put the {obj} into the {machine}
    switchoff(machine)
    open(machine)
    put(obj, machine)
    # wash the {obj}
    close(machine)
    switchon(machine)
