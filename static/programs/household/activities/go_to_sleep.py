"""Go to bed.

Said with: sleep, bed, bedtime, nap.
"""


def go_to_sleep():
    # make it dark
    switchoff('lightswitch ?')
    # go to bed
    sit('bed | sofa')
