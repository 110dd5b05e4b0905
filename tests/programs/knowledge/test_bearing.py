import pytest

from app.programs.knowledge.bearing import holds_another, holds_the_same, stands_for


@pytest.mark.parametrize(
    ("wanted", "name"),
    [
        ("cream", "cream jug"),
        ("cocoa", "cocoa pot"),
        ("tea", "teapot"),
        ("mint", "mint plant"),
        ("x ray", "x-ray film"),
        ("aspirin", "aspirin tablet 2"),
        ("conditioner", "conditioner bottle"),
        ("juice", "apple juice carton"),
        ("porridge", "bowl of porridge"),
        ("pepper", "pepper mill"),
    ],
)
def test_a_vessel_a_dose_or_a_plant_stands_for_what_it_bears(wanted, name):
    assert stands_for(name, wanted)


@pytest.mark.parametrize(
    ("wanted", "name"),
    [
        ("apple", "apple corer"),
        ("apple", "apple juice carton"),
        ("dog", "dog lead"),
        ("dog", "dog food tin"),
        ("piano", "piano stool"),
        ("flower", "flower pot"),
        ("tea", "teacup"),
        ("tea", "tea towel"),
        ("tomato", "tomato plant"),
        ("paper", "paper bag"),
    ],
)
def test_a_tool_a_piece_of_furniture_or_an_accessory_does_not(wanted, name):
    assert not stands_for(name, wanted)


def test_a_box_of_something_is_a_tin_of_it_and_no_tin_of_another_thing():
    assert holds_the_same("biscuit tin", ("cookie", "box"))
    assert not holds_the_same("milk carton", ("cookie", "box"))
    assert holds_another("milk carton", "cookies")
    assert not holds_another("milk carton", "oat milk")
