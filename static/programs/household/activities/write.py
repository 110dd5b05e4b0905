"""Write a letter, a note."""


def write(text):
    # grab something to write on and with
    grab(text)
    grab('pen | pencil ?')
    # sit down to write
    sit('chair | sofa')
