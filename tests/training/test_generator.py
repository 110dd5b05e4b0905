import itertools
from collections import Counter

import pytest

from app.programs.parser import parse_program
from app.programs.situated import HEAD
from app.training.executor import outcome
from app.training.generator import Example, generate
from app.training.scenes import PROPERTIES
from app.training.tasks import MAKERS, WEIGHTS
from app.training.things import HELD_CLASSES, Split, Vocabulary

COUNT = 150


@pytest.fixture(scope="module", params=["train", "held"])
def examples(request: pytest.FixtureRequest) -> list[Example]:
    split: Split = request.param
    return list(itertools.islice(generate(3, split), COUNT))


def test_the_same_seed_gives_the_same_examples() -> None:
    first, second = (list(itertools.islice(generate(5, "train"), 20)) for _ in range(2))
    other = list(itertools.islice(generate(6, "train"), 20))
    assert first == second
    assert first != other


def test_every_program_parses_and_ends_with_an_empty_line(examples: list[Example]) -> None:
    for part in (part for example in examples for part in example.parts):
        assert parse_program(HEAD + part.target).body
        assert part.target.endswith("\n\n")


def test_every_program_does_what_its_goal_says_and_nothing_more(examples: list[Example]) -> None:
    for example in examples:
        for part in example.parts:
            done = outcome(part.target, example.names, {example.verbs.put: example.verbs.swapped})
            assert done.places == part.goal
            assert not done.faults


def test_a_program_that_moves_nothing_says_why(examples: list[Example]) -> None:
    for part in (part for example in examples for part in example.parts):
        if "pass" in part.target.split():
            assert part.target.startswith("    # ")
            assert part.goal == {}


def test_every_kind_of_task_comes_up(examples: list[Example]) -> None:
    seen = Counter(part.kind for example in examples for part in example.parts)
    assert {"sort class", "except", "counting", "stacking", "absent", "typo", "verb"} <= seen.keys()
    assert WEIGHTS.keys() == MAKERS.keys()


def test_names_in_a_scene_are_unique_and_properties_known(examples: list[Example]) -> None:
    for example in examples:
        assert all(set(told) <= set(PROPERTIES) for told in example.objects.values())
        assert len(set(example.names)) == len(example.objects)


def test_no_noun_or_class_is_in_both_splits() -> None:
    train, held = Vocabulary("train"), Vocabulary("held")
    assert not HELD_CLASSES & train.classes.keys()
    for name in train.classes.keys() & held.classes.keys():
        assert not set(train.classes[name].things) & set(held.classes[name].things)


def test_the_default_action_is_the_one_most_programs_use(examples: list[Example]) -> None:
    usual = sum(example.verbs.put == "grab_and_putin" for example in examples)
    assert usual > 0.8 * len(examples)
