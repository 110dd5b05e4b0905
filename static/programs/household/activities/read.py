"""Read a book, a newspaper or the like.

Said with: read, look, browse, study, leaf, reading.
"""


def read(text):
    # grab the {text}
    grab(text)
    # read the {text}
    open(text)
