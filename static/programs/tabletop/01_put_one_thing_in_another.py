"""One thing into another; what the task does not speak of stays where it is."""
from actions import grab_and_putin


def put_the_spoon_in_the_mug():
    objects = {
        'hammer': {'category': 'tool', 'colour': 'grey'},
        'spoon': {'category': 'cutlery', 'colour': 'silver'},
        'mug': {'category': 'cup', 'colour': 'white', 'container': True},
        'sponge': {'category': 'cleaning tool', 'colour': 'yellow'},
        'jar': {'category': 'vessel', 'container': True},
    }
    # 1: put the spoon in the mug
    grab_and_putin('spoon', 'mug')
    assert 'spoon' in 'mug', grab_and_putin('spoon', 'mug')
    # 2: Done
