import subprocess
import sys

import pytest

from app.domain.errors import Cancelled, CompletionFailed
from app.domain.planner import Preambled, Prepared
from app.domain.program import ActionCall
from app.domain.trace import PlanningStarted
from app.llm.models import LlmConfig, find_model
from app.planners import planners
from app.programs.parser import parse_program

GOOD = "    grab_and_putin('banana', 'bowl')\n"
SPOKEN = " grab the banana and put it in the bowl\n2. done\n"
WRITES = {"langprompt": SPOKEN, "zero_shot": SPOKEN, "saycan": SPOKEN}
"""What the model has to write for the planners that ask for something else than a function."""
WITHOUT_TEXT = {"saycan", "oracle"}
"""They never ask the model to write."""
EMBEDDING = {"langprompt", "zero_shot"}
"""They need the weights of the sentence embeddings."""

AT_HOME = {"activities"}
"""They plan in a home, and not at the table (see their own tests)."""

with_weights = [
    pytest.param(
        name,
        marks=[pytest.mark.model, pytest.mark.timeout(1800)] if name in EMBEDDING else [],
    )
    for name in planners
    if name not in AT_HOME
]


@pytest.mark.parametrize("name", with_weights)
def test_every_planner_writes_a_program_that_does_it(name, task, canned):
    events = []
    draft = planners[name].write_program(
        task(name=name), canned(WRITES.get(name, GOOD)), lambda event: bool(events.append(event))
    )
    body = parse_program(draft.program).body
    calls = [str(each) for each in body if isinstance(each, ActionCall)]
    assert calls == ["grab_and_putin('banana', 'bowl')"]
    assert draft.prompt
    asked = None if name == "oracle" else "canned"
    assert events[0] == PlanningStarted(planner=name, model=asked)


@pytest.mark.parametrize("name", with_weights)
def test_every_planner_stops_when_asked_to(name, task, canned):
    with pytest.raises(Cancelled):
        planners[name].write_program(
            task(name=name), canned(WRITES.get(name, GOOD)), lambda _: True
        )


BEGIN_ALIKE = [
    name
    for name, planner in planners.items()
    if isinstance(planner, Preambled) and name not in AT_HOME
]


@pytest.mark.parametrize("name", BEGIN_ALIKE)
def test_every_prompt_begins_with_its_planners_preamble(name, task, canned):
    planner = planners[name]
    assert isinstance(planner, Preambled)
    asked = task(name=name)
    preamble = planner.preamble("tabletop", asked.actions)
    assert len(preamble.splitlines()) >= 1
    draft = planners[name].write_program(asked, canned(GOOD), lambda _: False)
    assert draft.prompt
    assert draft.prompt.startswith(preamble)


PREPARED = """
import sys
from app.planners import planners
from app.programs.knowledge import classes, hazards, wordnet
planners[sys.argv[1]].prepare()
print(classes.classes.cache_info().currsize, hazards.hazards.cache_info().currsize, wordnet.nouns.cache_info().currsize)
"""


@pytest.mark.parametrize("name", [n for n, each in planners.items() if isinstance(each, Prepared)])
def test_every_planner_can_read_what_it_knows_beforehand(name):
    done = subprocess.run(
        [sys.executable, "-c", PREPARED, name], capture_output=True, text=True, check=True
    )
    assert done.stdout == "1 1 1\n"


@pytest.mark.parametrize("name", planners)
def test_every_planner_names_a_model_that_there_is(name):
    assert find_model(planners[name].model, LlmConfig())


@pytest.mark.parametrize("name", [name for name in planners if name not in WITHOUT_TEXT | AT_HOME])
def test_every_planner_fails_on_a_model_that_writes_nothing(name, task, canned):
    with pytest.raises(CompletionFailed):
        planners[name].write_program(task(name=name), canned(""), lambda _: False)
