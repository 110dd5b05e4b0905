"""Sentences that follow on an earlier task: ``now the other one``."""

from app.domain.planner import Turn
from app.domain.program import literal
from app.training.draft import Draft
from app.training.noise import typed
from app.training.nouns import Nouns
from app.training.robots import PUT, Robot
from app.training.said import Said, fill
from app.training.steps import read_steps, write_steps


def dialogue(nouns: Nouns, robot: Robot) -> Draft:
    """An earlier task of one put, and what is said next."""
    entry = nouns.words.choose(nouns.words.lists["dialogues"])
    x, h, y, k = nouns.names.bare(), nouns.holder(), nouns.names.bare(), nouns.holder()
    noun = x.forms["bare"].split()[-1]
    x = Said(x.text, x.arguments, x.words, forms={**x.forms, "other": literal(f"other {noun}")})
    if not h.arguments[0].startswith("'"):
        h = nouns.holders.placed(nouns.names.with_article("bowl"), "in")
    slots = {"x": x, "h": h, "y": y, "k": k}
    robot.verbs = {PUT: robot.verbs[PUT]}
    template = nouns.rng.choice(nouns.words.lists["put"]["do"][:20])
    earlier = fill(template, slots)
    program = f"def task():\n{write_steps(read_steps(entry['first'], slots), robot)}"
    said, line = nouns.words.choose(entry["then"])
    history = (Turn(instruction=typed(nouns.words, earlier), program=program),)
    return Draft(fill(said, slots), read_steps(line, slots), order=False, history=history)
