import pytest

from app.domain.scene import Scene
from app.domain.trace import ActionFailed, CallSkipped, ExecutionFinished
from app.execution.interpreter import execute
from app.programs.examples import load_examples
from app.programs.grounding import ground

EXAMPLES = load_examples("household")
ENDS = {
    "lay_the_newspaper_on_the_nightstand": {"on(newspaper, nightstand)"},
    "store_the_cheese_in_the_kitchencabinet": {"in(cheese, kitchencabinet)", "closed(fridge)"},
    "launder_the_socks": {"washed(socks)", "held(socks)", "switched_off(washingmachine)"},
    "carry_the_vase_and_the_magazine_to_the_desk": {"on(vase, desk)", "on(magazine, desk)"},
    "rinse_the_candle_at_the_sink": {"washed(candle)", "in(candle, sink)"},
    "warm_the_bread_in_the_stove": {"heated(bread)", "in(bread, stove)"},
    "sit_on_the_bed_with_the_notebook": {"sitting(character)", "held(notebook)"},
    "air_the_bedroom_and_switch_on_the_floorlamp": {"open(window)", "switched_on(floorlamp)"},
    "throw_away_the_broken_pen": {"in(pen, garbagecan)", "closed(garbagecan)"},
    "stand_the_alarmclock_on_the_bookshelf": {"on(alarmclock, bookshelf)"},
    "clean_the_cookingpot": {"washed(cookingpot)", "in(washingsponge, sink)"},
    "steam_the_carrot_in_the_microwave": {"heated(carrot)", "held(carrot)", "closed(microwave)"},
    "play_a_game_on_the_computer_in_the_chair": {
        "switched_on(computer)",
        "sitting(character)",
    },
    "use_the_cellphone_as_a_light": {"held(cellphone)", "switched_on(cellphone)"},
    "look_something_up_in_the_folder_by_the_window": {"held(folder)", "open(folder)"},
    "make_the_livingroom_bright": {"switched_on(lightswitch)", "open(curtains)"},
    "store_the_shampoo_and_the_barsoap_in_the_bathroomcabinet": {
        "in(shampoo, bathroomcabinet)",
        "in(barsoap, bathroomcabinet)",
    },
    "fetch_me_a_towel": {"held(towel)"},
    "rest_a_while_on_the_chair": {"sitting(character)"},
    "ask_the_neighbour_on_the_telephone": {"used(wallphone)"},
    "serve_the_yogurt_from_the_fridge_on_the_kitchencounter": {
        "on(yogurt, kitchencounter)",
        "closed(fridge)",
    },
    "switch_off_the_lamp_on_the_ceiling": {"switched_off(ceilinglamp)"},
    "open_the_nightstand": {"open(nightstand)"},
    "nibble_the_apple_in_the_bed": {"held(apple)", "sitting(character)"},
}


def test_there_are_at_least_seven():
    assert sorted(ENDS) == sorted(example.name for example in EXAMPLES)
    assert len(EXAMPLES) >= 7


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.name)
def test_an_example_runs_in_the_first_home_without_a_failure_and_does_what_it_says(
    example, household
):
    scene = household.complete(Scene(world="household", environment="env0"), 0)
    actions = [each for each in household.actions if each.name in household.default_actions]
    plan = ground(example, scene, actions, household.relations)
    assert plan.rejected == ()
    events = list(execute(plan, household.open(scene, 0)))
    assert not [each for each in events if isinstance(each, ActionFailed | CallSkipped)]
    final = next(each for each in events if isinstance(each, ExecutionFinished))
    assert ENDS[example.name] <= {str(fact) for fact in final.facts}
