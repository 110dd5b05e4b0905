"""What is in the sink while the faucet runs gets washed."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def rinse_the_candle_at_the_sink():
    # 0: grab the candle
    find('candle')
    assert('close' to 'candle')
        else: find('candle')
    grab('candle')
    # 1: walk to the kitchen
    walk('kitchen')
    # 2: put the candle in the sink
    find('sink')
    assert('candle' in 'hands')
        else: find('candle')
        else: grab('candle')
    assert('close' to 'sink')
        else: find('sink')
    putin('candle', 'sink')
    # 3: switch on the faucet
    find('faucet')
    assert('close' to 'faucet')
        else: find('faucet')
    assert('faucet' is 'switchoff')
        else: switchoff('faucet')
    switchon('faucet')
    # 4: rinse the candle
    # 5: switch off the faucet
    assert('faucet' is 'switchon')
        else: switchon('faucet')
    switchoff('faucet')
    # 6: Done
