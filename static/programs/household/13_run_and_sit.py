"""What runs is switched on before somebody sits down in front of it."""
from actions import find, walk, grab, putin, putback, open, close, switchon, switchoff, sit, standup


def play_a_game_on_the_computer_in_the_chair():
    # 0: switch on the computer
    find('computer')
    assert('close' to 'computer')
        else: find('computer')
    assert('computer' is 'switchoff')
        else: switchoff('computer')
    switchon('computer')
    # 1: sit on the chair
    find('chair')
    assert('close' to 'chair')
        else: find('chair')
    sit('chair')
    # 2: Done
