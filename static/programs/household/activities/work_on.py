"""Work at the computer.

Said with: work, use, type, email, emails, study, browse, internet, web, surf, write, computer, play, check.
"""


def work_on(computer):
    # switch on the {computer}
    switchon(computer)
    # sit down to work
    sit('chair | officechair | armchair | bench')
