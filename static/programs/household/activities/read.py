"""Read a book, a newspaper or the like."""


def read(text):
    # grab the {text}
    grab(text)
    # read the {text}
    open(text)
