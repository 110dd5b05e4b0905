from random import Random

from app.programs.activities import load_activities
from app.programs.sketches.parser import parse_sketch
from app.training.actor import Actor
from app.training.chaining import chain
from app.training.chores import Chores
from app.training.describing import described
from app.training.nouns import Nouns
from app.training.robots import Robot
from app.training.words import Words, load_lists


def test_every_activity_can_be_asked_for_and_nothing_else():
    bank = load_lists()["activities"]["activities"]
    known = {each.signature.name: each.signature for each in load_activities("household")}
    assert bank.keys() == known.keys()
    for name, entry in bank.items():
        assert len(entry["slots"]) == len(known[name].parameters), name
        assert entry["sketch"].startswith(f"{name}(")


def test_what_is_asked_for_stands_on_the_import_line():
    for number in range(300):
        text, lines, actions = Chores(Words(Random(number), "train")).ask()
        assert text
        offered = {action.name for action in actions}
        sketch = parse_sketch("".join(f"    {line}\n" for line in lines))
        called = {line.partition("(")[0] for line in lines}
        assert called <= offered | {"decline"}
        assert len(sketch.body) == len(lines)


def test_verbs_in_a_chain_are_done_in_the_order_they_are_meant_in():
    seen = set()
    for number in range(2000):
        words = Words(Random(number), "train")
        text, steps, _ = chain(Actor(Nouns(words), Robot(words.rng)))
        if text.startswith("before you ") and len(steps) == 2:
            late, early = (step.concept.partition(" ")[2] for step in reversed(steps))
            said = text.replace(",", "")
            if late in said and early in said:
                seen.add(said.index(early) > said.index(late))
    assert seen == {True}


def test_a_use_is_told_without_the_name():
    rng = Random(0)
    kept = {described(rng, "opens wine bottles")[1] for _ in range(300)}
    assert {"thing that opens wine bottles", "thing for opening wine bottles"} <= kept
    assert described(Random(0), "sticky brown spread")[1] == "sticky brown spread"
