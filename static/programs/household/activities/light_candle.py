"""Light a candle."""


def light_candle(candle):
    # light the {candle}
    switchon(candle)
