import pytest

from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.scene import Scene
from app.worlds.actions.household import actions


def failure(do, world, text):
    before = world.graph.save()
    with pytest.raises(ActionFailure) as raised:
        do(world, text)
    assert world.graph.save() == before
    return raised.value


def remedies(failure):
    return "; ".join(map(str, failure.remedy)).replace("'", "").replace(",", "")


def followed(do, world, failure):
    """The world after the remedy's calls."""
    for call in failure.remedy:
        do(world, " ".join((call.action, *map(str, call.arguments))))


@pytest.mark.parametrize("name", list(actions))
def test_an_action_is_registered_under_the_name_of_its_signature(name):
    signature = actions[name].signature
    assert signature.name == name
    assert signature.meaning.endswith(".")


def test_what_is_not_close_cannot_be_grabbed_before_it_is_found(home, do):
    failed = failure(do, home, "grab pear")
    assert remedies(failed) == "find(pear)"
    followed(do, home, failed)
    do(home, "grab pear")
    assert home.holds(Relation("held", ("pear",)))


def test_what_is_shut_in_is_taken_after_its_container_is_opened(home, do):
    do(home, "find apple")
    failed = failure(do, home, "grab apple")
    assert remedies(failed) == "open(fridge)"
    followed(do, home, failed)
    do(home, "grab apple")
    assert home.holds(Relation("held", ("apple",)))
    assert not home.holds(Relation("in", ("apple", "fridge")))


def test_a_closed_container_takes_nothing(home, do):
    do(home, "find pear; grab pear; find fridge")
    failed = failure(do, home, "putin pear fridge")
    assert remedies(failed) == "open(fridge)"
    followed(do, home, failed)
    do(home, "putin pear fridge; close fridge")
    assert home.holds(Relation("in", ("pear", "fridge")))
    assert home.holds(Relation("closed", ("fridge",)))


def test_two_hands_hold_two_things_and_no_door_opens_then(home, do):
    do(home, "find pear; grab pear; grab cup; find fridge")
    failed = failure(do, home, "open fridge")
    assert remedies(failed) == "find(table); putback(cup table)"
    followed(do, home, failed)
    do(home, "find fridge; open fridge")
    assert home.holds(Relation("on", ("cup", "table")))


def test_what_is_to_be_put_must_be_in_a_hand(home, do):
    do(home, "find table")
    failed = failure(do, home, "putback apple table")
    assert remedies(failed) == "find(fridge); open(fridge); find(apple); grab(apple)"
    followed(do, home, failed)
    do(home, "find table; putback apple table")
    assert home.holds(Relation("on", ("apple", "table")))


def test_nobody_walks_sitting(home, do):
    do(home, "find stool; sit stool")
    assert home.holds(Relation("sitting", ("character",)))
    failed = failure(do, home, "walk fridge")
    assert remedies(failed) == "standup()"
    followed(do, home, failed)
    do(home, "walk fridge")
    assert not home.holds(Relation("on", ("character", "stool")))


def test_what_runs_does_not_open(home, do):
    do(home, "find cupboard")
    failed = failure(do, home, "open cupboard")
    assert remedies(failed) == "switchoff(cupboard)"
    followed(do, home, failed)
    do(home, "open cupboard")


@pytest.mark.parametrize(
    "text", ["grab table", "open table", "switchon cup", "sit cup", "read cup", "walk nothing"]
)
def test_what_cannot_be_done_has_no_remedy(home, do, text):
    name = text.split()[1]
    if name != "nothing":
        do(home, f"find {name}")
    assert failure(do, home, text).remedy == ()


def test_switches_change_their_state_once(home, do):
    do(home, "find lamp; switchon lamp")
    assert home.holds(Relation("switched_on", ("lamp",)))
    assert failure(do, home, "switchon lamp").remedy == ()
    do(home, "switchoff lamp")
    assert home.holds(Relation("switched_off", ("lamp",)))


def test_walking_leaves_what_was_close(home, do):
    do(home, "find pear")
    assert home.holds(Relation("near", ("pear",)))
    assert home.holds(Relation("near", ("table",)))
    do(home, "walk stool")
    assert not home.holds(Relation("near", ("pear",)))


def test_looking_asks_for_turning_to_it(home, do):
    failed = failure(do, home, "lookat lamp")
    assert remedies(failed) == "turnto(lamp)"
    followed(do, home, failed)
    do(home, "lookat lamp")


@pytest.mark.parametrize(("index", "name"), list(enumerate(actions)))
def test_every_action_can_be_done_with_something_in_a_home(index, name, household, do):
    """And where it cannot, what it says would help does help, a few times over."""
    world = household.open(Scene(world="household", environment=f"env{index % 3}"), 0)
    if name in BEFORE:
        do(world, BEFORE[name])
    partners = PARTNERS.get(name)
    tries = [partners] if partners else [(name_,) for name_ in world.scene.names]
    if not actions[name].signature.parameters:
        tries = [()]
    assert any(_managed(do, world, name, names) for names in tries), name


BEFORE = {
    "wipe": "find towel; grab towel",
    **dict.fromkeys(("standup", "sleep", "wakeup"), "find bed; lie bed"),
    "plugin": "find tablelamp; plugout tablelamp",
    "putoff": "find closet; open closet; grab jacket; puton jacket",
}
PARTNERS = {
    "putin": ("apple", "fridge"),
    "putback": ("apple", "sofa"),
    "pour": ("milk", "mug"),
}


def _managed(do, world, name, names):
    for _ in range(6):
        try:
            do(world, " ".join((name, *names)))
        except ActionFailure as failed:
            if not failed.remedy:
                return False
            for call in failed.remedy:
                try:
                    do(world, " ".join((call.action, *map(str, call.arguments))))
                except ActionFailure:
                    break
        else:
            return True
    return False


def test_who_stands_need_not_stand_up(home, do):
    assert failure(do, home, "standup").needless


def test_a_seat_that_is_taken_by_a_thing_is_free_once_the_thing_is_grabbed(home, do):
    do(home, "find pear; grab pear; find stool; putback pear stool")
    failed = failure(do, home, "sit stool")
    assert remedies(failed) == "grab(pear)"
    followed(do, home, failed)
    do(home, "sit stool")
    assert home.holds(Relation("sitting", ("character",)))


def test_what_is_so_already_is_needless_even_where_there_is_another_of_its_name(household, do):
    world = household.open(Scene(world="household", environment="env0"), 0)
    do(world, "find tablelamp")
    assert failure(do, world, "switchoff tablelamp").needless
