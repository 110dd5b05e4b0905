"""All but one."""
from actions import grab_and_putin


def clear_everything_but_the_glue_into_the_basket():
    objects = {
        'brush': {'category': 'tool', 'colour': 'brown'},
        'glue': {'colour': 'white'},
        'basket': {'colour': 'brown', 'container': True},
        'ruler': {'category': 'tool', 'colour': 'yellow'},
        'marker': {'category': 'pen', 'colour': 'green'},
    }
    # 1: put everything but the glue in the basket
    grab_and_putin('brush', 'basket')
    assert 'brush' in 'basket', grab_and_putin('brush', 'basket')
    grab_and_putin('ruler', 'basket')
    assert 'ruler' in 'basket', grab_and_putin('ruler', 'basket')
    grab_and_putin('marker', 'basket')
    assert 'marker' in 'basket', grab_and_putin('marker', 'basket')
    # 2: Done
