"""Light a candle.

Said with: light, lit, alight, burn, match, candle.
"""


def light_candle(candle):
    # light the {candle}
    switchon(candle)
