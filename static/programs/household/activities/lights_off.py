"""Make it dark: every kind of light.

Said with: light, lights, dark, bright.
"""


def lights_off():
    # switch off the lights
    switchoff('lightswitch ?')
    switchoff('ceilinglamp ?')
    switchoff('tablelamp ?')
    switchoff('floorlamp ?')
