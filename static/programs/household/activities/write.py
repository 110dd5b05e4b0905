"""Write a letter, a note.

Said with: write, note, notes, jot, sign.
"""


def write(text):
    # grab something to write on and with
    grab(text)
    grab('pen | pencil ?')
    # sit down to write
    sit('chair | sofa')
