"""Read on this seat, or at this light.

Said with: read, reading, study.
"""


def read_on(text, seat):
    # grab the {text}
    grab(text)
    # go to the {seat}
    find(seat)
    # read the {text}
    open(text)
    sit(seat)
