"""Make a telephone call.

Said with: call, phone, telephone, ring, friend.
"""


def call():
    # call on the telephone
    switchon('wallphone | phone | telephone | cellphone')
