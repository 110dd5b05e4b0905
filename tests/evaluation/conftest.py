"""Tasks, methods and models for evaluations that take no time."""

import pytest

from app.domain.planner import PlannerOptions
from app.domain.scene import Scene, SceneObject
from app.evaluation.attempt import Unit, attempt
from app.evaluation.results import Cell
from app.evaluation.suites import Suite
from app.evaluation.tasks import SuiteTask
from app.llm.backends.scripted import Answer, ScriptedModel

GRAB = "grab_and_putin"


@pytest.fixture
def make_task():
    """A banana, an apple, a cup and a bowl; the banana goes into the bowl."""

    def make(**values):
        names = values.pop("objects", ("banana", "apple", "cup", "bowl"))
        objects = tuple(SceneObject(name=name) for name in names)
        given = {
            "name": "banana in the bowl",
            "category": "simple",
            "scene": Scene(world="tabletop", objects=objects, actions=(GRAB,)),
            "instruction": "put the banana in the bowl",
            "goal": ("in(banana, bowl)",),
            "truth": ("grab_and_putin('banana', 'bowl')",),
            "variants": {"de": "Leg die Banane in die Schüssel"},
        }
        return SuiteTask(**{**given, **values})

    return make


@pytest.fixture
def make_cell():
    def make(name="paper", **options):
        return Cell(name=name, options=PlannerOptions(model="scripted", **options))

    return make


@pytest.fixture
def try_it(make_cell):
    """What comes of a task where the model writes these calls."""

    def run(task, *calls, physics=False, cell=None):
        body = "".join(f"    {call}\n" for call in calls)
        model = ScriptedModel([Answer(text=body)])
        unit = Unit(task=task, cell=cell or make_cell(), physics=physics)
        return attempt(unit, lambda _name, _preferred: model)

    return run


@pytest.fixture
def suite(make_task):
    first = make_task()
    second = make_task(
        name="apple in the bowl",
        category="other",
        instruction="put the apple in the bowl",
        goal=("in(apple, bowl)",),
        truth=("grab_and_putin('apple', 'bowl')",),
        variants={},
    )
    return Suite(name="two", tasks=(first, second))


class Script:
    """Opens a model that knows one of the two tasks; it survives pickling."""

    def __call__(self):
        return self.open

    def open(self, _name, _preferred):
        return ScriptedModel([Answer(text="    grab_and_putin('banana', 'bowl')\n")])


@pytest.fixture
def open_models():
    return Script()
