"""Listen to a radio, to music.

Said with: listen, music, hear, song, news.
"""


def listen_to(device):
    # grab the {device} and switch it on
    grab(device)
    switchon(device)
