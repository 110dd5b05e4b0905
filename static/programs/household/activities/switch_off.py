"""Switch a device or a lamp off.

Said with: off, stop, shut, kill, power, deactivate, out.
"""


def switch_off(device):
    # switch off the {device}
    switchoff(device)
