"""Switch a device or a lamp on."""


def switch_on(device):
    # switch on the {device}
    switchon(device)
