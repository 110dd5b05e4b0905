"""Two things by name, each to its own place."""
from actions import grab_and_putin


def put_the_lemon_in_the_cup_and_the_key_on_the_book():
    objects = {
        'book': {'colour': 'blue'},
        'lemon': {'category': 'fruit', 'colour': 'yellow'},
        'drill': {'category': 'tool', 'colour': 'black'},
        'key': {'colour': 'silver'},
        'cup': {'category': 'vessel', 'colour': 'red', 'container': True},
        'jar': {'category': 'vessel', 'container': True},
    }
    # 1: put the lemon in the cup
    grab_and_putin('lemon', 'cup')
    assert 'lemon' in 'cup', grab_and_putin('lemon', 'cup')
    # 2: put the key on the book
    grab_and_putin('key', 'book')
    assert on('key', 'book'), grab_and_putin('key', 'book')
    # 3: Done
