"""Play with a toy, a game, an instrument."""


def play(game):
    # grab the {game}
    grab(game)
    # sit down to play
    sit('sofa | chair | armchair')
