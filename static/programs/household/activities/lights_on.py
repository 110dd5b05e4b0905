"""Make it bright: every kind of light.

Said with: light, lights, dark, bright, see.
"""


def lights_on():
    # switch on the lights
    switchon('lightswitch ?')
    switchon('ceilinglamp ?')
    switchon('tablelamp ?')
    switchon('floorlamp ?')
