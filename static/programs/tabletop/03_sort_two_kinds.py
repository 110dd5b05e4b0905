"""Two kinds of things to two places; a can and a jar are no mugs, and stay."""
from actions import grab_and_putin


def put_the_vegetables_in_the_pot_and_the_mugs_on_the_tray():
    objects = {
        'can': {'category': 'packaging', 'colour': 'red'},
        'carrot': {'category': 'vegetable', 'colour': 'orange'},
        'tape': {'colour': 'grey'},
        'red mug': {'category': 'mug', 'colour': 'red'},
        'pot': {'category': 'vessel', 'colour': 'black', 'container': True},
        'onion': {'category': 'vegetable', 'colour': 'brown'},
        'jar': {'category': 'vessel', 'container': True},
        'tray': {'colour': 'white', 'container': True},
        'blue mug': {'category': 'mug', 'colour': 'blue'},
        'soap': {'colour': 'pink'},
    }
    # 1: put the vegetables in the pot
    grab_and_putin('carrot', 'pot')
    assert 'carrot' in 'pot', grab_and_putin('carrot', 'pot')
    grab_and_putin('onion', 'pot')
    assert 'onion' in 'pot', grab_and_putin('onion', 'pot')
    # 2: put the mugs on the tray
    grab_and_putin('red mug', 'tray')
    assert on('red mug', 'tray'), grab_and_putin('red mug', 'tray')
    grab_and_putin('blue mug', 'tray')
    assert on('blue mug', 'tray'), grab_and_putin('blue mug', 'tray')
    # 3: Done
