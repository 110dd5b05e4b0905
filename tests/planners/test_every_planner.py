import pytest

from app.domain.errors import CompletionFailed
from app.domain.trace import PlanningStarted
from app.planners import planners
from app.programs.parser import parse_program

GOOD = "    grab_and_putin('banana', 'bowl')\n"


@pytest.mark.parametrize("name", planners)
def test_every_planner_writes_a_program_that_parses(name, task, canned):
    events = []
    draft = planners[name].write_program(
        task(name=name), canned(GOOD), lambda event: bool(events.append(event))
    )
    assert parse_program(draft.program).body
    assert draft.prompt
    assert events[0] == PlanningStarted(planner=name, model="canned")


@pytest.mark.parametrize("name", planners)
def test_every_planner_fails_on_a_model_that_writes_nothing(name, task, canned):
    with pytest.raises(CompletionFailed):
        planners[name].write_program(task(name=name), canned(""), lambda _: False)
