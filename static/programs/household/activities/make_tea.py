"""Make tea.

Said with: tea, kettle.
"""


def make_tea():
    # fill the kettle and boil the water
    grab('kettle | teapot | coffeepot')
    put('kettle | teapot | coffeepot', 'stove | kitchencounter')
    switchon('kettle | stove ?')
    # have a cup at hand
    grab('mug | cup ?')
