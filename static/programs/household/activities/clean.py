"""Wipe or clean a surface, a room, a piece of furniture.

Said with: clean, wipe, dust, polish, scrub, mop, dusty, cleaning, shine, tidy.
"""


def clean(obj):
    # grab something to clean with
    grab('washingsponge | sponge | rag | towel')
    # clean the {obj}
    find(obj)
