"""Switch a device or a lamp on.

Said with: on, start, power, activate, running, run, boot, play.
"""


def switch_on(device):
    # switch on the {device}
    switchon(device)
