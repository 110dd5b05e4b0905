"""Work at the computer."""


def work_on(computer):
    # switch on the {computer}
    switchon(computer)
    # sit down to work
    sit('chair | officechair | armchair | bench')
