"""Each thing to the place that shares a property with it."""
from actions import grab_and_putin


def match_every_sock_to_the_drawer_of_its_colour():
    objects = ['grey drawer', 'blue sock', 'grey sock', 'blue drawer', 'white drawer']
    # 1: put the blue sock in the blue drawer
    grab_and_putin('blue sock', 'blue drawer')
    assert 'blue sock' in 'blue drawer', grab_and_putin('blue sock', 'blue drawer')
    # 2: put the grey sock in the grey drawer
    grab_and_putin('grey sock', 'grey drawer')
    assert 'grey sock' in 'grey drawer', grab_and_putin('grey sock', 'grey drawer')
    # 3: Done
