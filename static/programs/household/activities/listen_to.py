"""Listen to a radio, to music."""


def listen_to(device):
    # grab the {device} and switch it on
    grab(device)
    switchon(device)
