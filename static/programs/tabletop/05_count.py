"""Some of several like things, no more than was asked for."""
from actions import grab_and_putin


def drop_two_of_the_batteries_in_the_jar():
    objects = {
        'battery 1': {'category': 'battery', 'colour': 'black'},
        'jar': {'category': 'vessel', 'container': True},
        'battery 2': {'category': 'battery', 'colour': 'black'},
        'battery 3': {'category': 'battery', 'colour': 'grey'},
        'tape': {'colour': 'grey'},
        'battery 4': {'category': 'battery', 'colour': 'black'},
    }
    # 1: put the first battery in the jar
    grab_and_putin('battery 1', 'jar')
    assert 'battery 1' in 'jar', grab_and_putin('battery 1', 'jar')
    # 2: put the second battery in the jar
    grab_and_putin('battery 2', 'jar')
    assert 'battery 2' in 'jar', grab_and_putin('battery 2', 'jar')
    # 3: Done
