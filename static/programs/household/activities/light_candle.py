"""Light a candle.

Said with: candle, candles, alight, burn, match.
"""


def light_candle(candle):
    # light the {candle}
    switchon(candle)
