"""Watch television.

Said with: tv, television, movie, film, news, watch, game.
"""


def watch_tv():
    # switch on the television
    switchon('tv | television')
    # sit down to watch
    sit('sofa | armchair | couch | bed')
