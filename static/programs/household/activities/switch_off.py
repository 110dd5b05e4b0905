"""Switch a device or a lamp off."""


def switch_off(device):
    # switch off the {device}
    switchoff(device)
