"""Make a telephone call."""


def call():
    # call on the telephone
    switchon('wallphone | phone | telephone | cellphone')
