"""What is asked for is not there: nothing is done, and the comment says why."""
from actions import grab_and_putin


def set_the_teapot_on_the_saucer():
    objects = {
        'saucer': {'category': 'crockery', 'colour': 'white', 'container': True},
        'sugar bowl': {'category': 'crockery', 'colour': 'white', 'container': True},
        'spoon': {'category': 'cutlery', 'colour': 'silver'},
    }
    # 1: there is no teapot
    pass
