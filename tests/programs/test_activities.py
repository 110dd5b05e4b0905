"""Every activity file in every shipped home, and what one comes down to there."""

from dataclasses import replace
from functools import cache

import pytest

from app.domain.errors import TaskDeclined
from app.domain.program import ActionCall, Assertion, Comment, Program, Statement, Variable
from app.domain.scene import Scene, SceneObject
from app.domain.trace import ActionFailed, CallSkipped
from app.execution.interpreter import execute
from app.execution.repair import repair
from app.programs import activities
from app.programs.activities import load_activities
from app.programs.grounding import ground
from app.programs.home import Home
from app.programs.parser import parse_program
from app.programs.printer import print_program
from app.worlds import worlds

HOMES = ("env0", "env1", "env2")
ACTIVITIES = {each.signature.name: each for each in load_activities("household")}
HOUSEHOLD = worlds["household"]
OFFERED = tuple(each for each in HOUSEHOLD.actions if each.name in HOUSEHOLD.default_actions)


@cache
def scene_of(home):
    return HOUSEHOLD.complete(Scene(world="household", environment=home), 0)


@cache
def world_of(home):
    world = HOUSEHOLD.open_perfect(scene_of(home), 0)
    return world, world.save()


def affordances(item):
    return set(dict(item.properties).get("affordances", "").split())


def fits(item, parameter, body):
    """Whether the thing affords what is asked of it, and a seat that one can sit on it."""
    wanted = [parameter.affordance] if parameter.affordance else []
    if ActionCall(action="sit", arguments=(Variable(parameter.name),)) in plain(body):
        wanted.append("sittable")
    return all(affordances(item) & set(each.split("|")) for each in wanted)


def plain(body):
    return [replace(each, line=0) for each in body if isinstance(each, ActionCall)]


def fitting(activity, home):
    """Three choices of arguments that the home affords: early, middling and late ones."""
    names = [
        [item.name for item in scene_of(home).objects if fits(item, each, activity.body)]
        for each in activity.signature.parameters
    ]
    if not names:
        return [()]
    chosen = {
        tuple(
            found[(len(found) * share // 4 + 3 * place) % len(found)]
            for place, found in enumerate(names)
        )
        for share in range(3)
    }
    return [each for each in sorted(chosen) if len(set(each)) == len(each)]


def failures(body, home):
    """What of it fails once it has been repaired."""
    scene, (world, start) = scene_of(home), world_of(home)

    def grounded(program):
        return ground(program, scene, OFFERED, HOUSEHOLD.relations)

    world.restore(start)
    program = parse_program(print_program(Program(name="task", body=body)))
    plan = grounded(repair(program, scene, world, grounded).program)
    world.restore(start)
    events = execute(plan, world)
    return [*plan.rejected, *(e for e in events if isinstance(e, ActionFailed | CallSkipped))]


@pytest.mark.parametrize("home", HOMES)
@pytest.mark.parametrize("name", ACTIVITIES)
def test_every_activity_declines_or_runs_repaired_without_a_failure_in_every_home(name, home):
    activity = ACTIVITIES[name]
    choices = fitting(activity, home)
    assert choices
    for arguments in choices:
        for feedback in (False, True):
            carrying = Home(scene_of(home).objects, feedback=feedback)
            try:
                body = tuple(carrying.carry_out(activity, arguments))
            except TaskDeclined:
                continue
            assert not failures(body, home), arguments


@pytest.mark.parametrize("name", ACTIVITIES)
def test_every_activity_can_be_done_in_one_of_the_homes(name):
    activity = ACTIVITIES[name]

    def possible(home):
        try:
            return list(
                Home(scene_of(home).objects, feedback=False).carry_out(
                    activity, fitting(activity, home)[0]
                )
            )
        except TaskDeclined as declined:
            return declined.kind == "hazardous"  # the thing drawn does not bear it

    assert any(map(possible, HOMES))


def test_every_activity_says_what_it_means_and_is_named_as_its_file():
    files = sorted((activities.FOLDER / "household" / "activities").glob("*.py"))
    assert [each.stem for each in files] == list(ACTIVITIES)
    assert all(each.signature.meaning for each in ACTIVITIES.values())


def test_a_world_without_a_folder_has_no_activities():
    assert load_activities("tabletop") == ()


SMALL = {
    "bread": "grabbable",
    "oven": "containers can_open has_switch",
    "table": "surfaces",
    "cabinet": "surfaces containers can_open",
    "box": "containers",
    "sofa": "sittable surfaces",
    "washingmachine": "containers can_open has_switch",
    "clothesshirt": "grabbable",
}


def written(text: str, *arguments: str, feedback=False, **more: str) -> list[Statement]:
    """What one activity comes down to in a small home."""
    objects = [
        SceneObject(name=name, properties=(("affordances", told),))
        for name, told in {**SMALL, **more}.items()
    ]
    activity = activities._activity(text)
    return list(Home(objects, feedback=feedback).carry_out(activity, arguments))


def lines(body):
    return [str(each) for each in body if isinstance(each, ActionCall)]


def test_of_several_names_the_first_that_the_home_has_is_taken():
    text = "def f():\n    switchon('microwave | oven | washingmachine')\n"
    assert lines(written(text)) == ["find('oven')", "switchon('oven')"]
    assert lines(written(text, microwave="has_switch"))[0] == "find('microwave')"


def test_what_may_be_missing_is_left_out_with_its_call():
    text = "def f(food):\n    grab('tray | plate ?')\n    grab(food)\n"
    assert lines(written(text, "bread")) == ["find('bread')", "grab('bread')"]
    assert "grab('plate')" in lines(written(text, "bread", plate="grabbable"))


def test_what_is_missing_is_told_in_words_people_use():
    with pytest.raises(TaskDeclined, match="there is no coffee maker or kettle here") as declined:
        written("def f():\n    switchon('coffeemaker | kettle')\n")
    assert declined.value.kind == "absent"


def test_comments_are_numbered_and_name_the_things_in_words():
    body = written(
        "def f(obj, place):\n    # grab the {obj}\n    grab(obj)\n    # to the {place}\n    put(obj, place)\n",
        "clothesshirt",
        "washingmachine",
    )
    said = [each.text for each in body if isinstance(each, Comment)]
    assert said == ["0: grab the clothes shirt", "1: to the washing machine"]


def test_the_last_comment_goes_on_counting():
    home = Home(
        [SceneObject(name="bread", properties=(("affordances", "grabbable"),))], feedback=False
    )
    list(home.carry_out(ACTIVITIES["pick_up"], ["bread"]))
    assert home.done() == Comment(text="1: Done")


@pytest.mark.parametrize(
    ("place", "verb"),
    [
        ("oven", "putin"),
        ("table", "putback"),
        ("cabinet", "putin"),
        ("box", "putin"),
        ("sofa", "putback"),
    ],
)
def test_put_is_in_or_on_as_the_place_affords(place, verb):
    body = written("def f(x, y):\n    put(x, y)\n", "bread", place)
    assert lines(body) == [f"find('{place}')", f"{verb}('bread', '{place}')"]


def test_what_a_thing_does_not_afford_is_left_out():
    text = "def f(x):\n    open(x)\n    switchon(x)\n    sit(x)\n"
    assert lines(written(text, "sofa")) == ["find('sofa')", "sit('sofa')"]
    assert lines(written(text, "oven")) == ["find('oven')", "open('oven')", "switchon('oven')"]


def test_an_activity_of_which_nothing_can_be_done_is_declined():
    with pytest.raises(TaskDeclined, match="open clothes shirt") as declined:
        written("def open(x):\n    # open the {x}\n    open(x)\n", "clothesshirt")
    assert declined.value.kind == "impossible"


def test_a_thing_is_walked_up_to_once():
    text = "def f(x):\n    open(x)\n    close(x)\n    grab('bread')\n    open(x)\n"
    assert [each for each in lines(written(text, "oven")) if "find" in each] == [
        "find('oven')",
        "find('bread')",
        "find('oven')",
    ]


def test_feedback_adds_assertions_whose_recovery_is_the_call():
    text = "def f(x):\n    open('oven')\n    put(x, 'oven')\n"
    body = written(text, "bread", feedback=True)
    asserted = [
        (str(each.condition), [str(call) for call in each.recovery])
        for each in body
        if isinstance(each, Assertion)
    ]
    assert asserted == [
        ("near(oven)", ["find('oven')"]),
        ("open(oven)", ["open('oven')"]),
        ("held(bread)", ["find('bread')", "grab('bread')"]),
    ]
    assert lines(body) == ["find('oven')", "putin('bread', 'oven')"]
    assert not [each for each in written(text, "bread") if isinstance(each, Assertion)]


def test_a_parameter_affords_what_its_first_call_takes_that_is_not_left_out():
    taken = {
        name: [each.affordance for each in ACTIVITIES[name].signature.parameters]
        for name in ("pick_up", "switch_on", "sit_on", "go_to", "put", "take_out")
    }
    assert taken == {
        "pick_up": ["grabbable"],
        "switch_on": ["has_switch"],
        "sit_on": ["sittable|lieable"],
        "go_to": [None],
        "put": ["grabbable", "containers|surfaces"],
        "take_out": ["grabbable", "can_open"],
    }
