"""Wipe or clean a surface, a room, a piece of furniture."""


def clean(obj):
    # grab something to clean with
    grab('washingsponge | sponge | rag | towel')
    # clean the {obj}
    find(obj)
