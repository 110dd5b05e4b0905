"""Make it bright: every kind of light."""


def lights_on():
    # switch on the lights
    switchon('lightswitch ?')
    switchon('ceilinglamp ?')
    switchon('tablelamp ?')
    switchon('floorlamp ?')
