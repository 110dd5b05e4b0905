"""Get breakfast ready: lay it on the table.

Said with: make breakfast, breakfast ready, prepare breakfast, some breakfast, for breakfast, fix breakfast.
"""


def make_breakfast():
    # lay a plate
    grab('plate | bowl | dishbowl ?')
    put('plate | bowl | dishbowl ?', 'kitchentable | diningtable | table | coffeetable')
    # lay the food beside it
    grab('bread | breadslice | cereal')
    put('bread | breadslice | cereal', 'kitchentable | diningtable | table | coffeetable')
    # something to drink
    grab('milk | juice ?')
    put('milk | juice ?', 'kitchentable | diningtable | table | coffeetable')
