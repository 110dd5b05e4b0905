"""Each thing to the place that shares a property with it."""
from actions import grab_and_putin


def match_every_sock_to_the_drawer_of_its_colour():
    objects = {
        'grey drawer': {'colour': 'grey', 'container': True},
        'blue sock': {'category': 'clothing', 'colour': 'blue'},
        'grey sock': {'category': 'clothing', 'colour': 'grey'},
        'blue drawer': {'colour': 'blue', 'container': True},
        'white drawer': {'colour': 'white', 'container': True},
    }
    # 1: put the blue sock in the blue drawer
    grab_and_putin('blue sock', 'blue drawer')
    assert 'blue sock' in 'blue drawer', grab_and_putin('blue sock', 'blue drawer')
    # 2: put the grey sock in the grey drawer
    grab_and_putin('grey sock', 'grey drawer')
    assert 'grey sock' in 'grey drawer', grab_and_putin('grey sock', 'grey drawer')
    # 3: Done
