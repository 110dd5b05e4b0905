"""Play with a toy, a game, an instrument.

Said with: play, game, fun, practice.
"""


def play(game):
    # grab the {game}
    grab(game)
    # sit down to play
    sit('sofa | chair | armchair')
