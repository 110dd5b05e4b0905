from typing import Any

import pytest

from app.domain.condition import Relation
from app.domain.errors import ModelUnavailable
from app.domain.llm import Completion
from app.domain.plan import GroundedAssertion, GroundedBranch, GroundedCall, Jump, Plan
from app.domain.trace import ActionStarted, AssertionChecked, BranchDecided, Checkpoint
from app.execution.assertion import MAX_TOKENS, STOP, state_check
from app.execution.interpreter import execute

IN = Relation("in", ("pear", "bowl"))


class Answering:
    """Answers one after the other, and remembers what it was asked."""

    name = "answering"
    follows_grammar = False

    def __init__(self, *answers):
        self.answers = list(answers)
        self.requests = []

    def complete(self, request, on_text=None):
        self.requests.append(request)
        if not self.answers:
            raise ModelUnavailable("it is asleep")
        return Completion(
            text=self.answers.pop(0), model=self.name, finish="stop",
            prompt_tokens=1, completion_tokens=1, seconds=0.0,
        )  # fmt: skip

    def score(self, prompt, candidates):
        raise NotImplementedError


def put(line, thing):
    return GroundedCall(line=line, action="put", arguments=(thing, "bowl"))


def assertion(*recovery):
    return Plan(steps=(GroundedAssertion(line=2, condition=IN, recovery=recovery),))


def told(plan, world, decider, *kinds) -> list[Any]:
    return [each for each in execute(plan, world, decider=decider) if isinstance(each, kinds)]


@pytest.mark.parametrize(
    ("answer", "holds"), [("True", True), (" True\n", True), ("False", False), ("", False)]
)
def test_the_model_decides_by_the_paper_s_prompt(slippery, answer, holds):
    model = Answering(answer)
    (checked,) = told(assertion(), slippery(), state_check("model", model), AssertionChecked)
    assert (checked.holds, checked.by_model, checked.by_world) == (holds, holds, None)
    assert (checked.decider, checked.agree) == ("model", None)
    (request,) = model.requests
    assert (request.max_tokens, request.stop, request.temperature) == (MAX_TOKENS, STOP, 0.0)
    assert request.prompt.endswith("assert('pear' in 'bowl')\n")


@pytest.mark.parametrize(("answer", "agree"), [("True", False), ("False", True)])
def test_side_by_side_the_world_decides_and_the_model_s_word_is_kept(slippery, answer, agree):
    decider = state_check("both", Answering(answer))
    (checked,) = told(assertion(), slippery(), decider, AssertionChecked)
    assert (checked.holds, checked.by_world) == (False, False)
    assert (checked.by_model, checked.agree) == (answer == "True", agree)


def test_the_model_is_asked_anew_after_each_recovery(slippery):
    model = Answering("False", "False", "True")
    plan = assertion(put(3, "fig"), put(4, "plum"), put(5, "pear"))
    started = told(plan, slippery(), state_check("model", model), ActionStarted)
    assert [each.line for each in started] == [3, 4]
    assert len(model.requests) == 3
    seen = ["'fig' in 'bowl'" in request.prompt for request in model.requests]
    assert seen == [False, True, True]


def test_a_model_that_cannot_be_asked_ends_the_execution(slippery):
    with pytest.raises(ModelUnavailable):
        list(execute(assertion(), slippery(), decider=state_check("model", Answering())))


def test_a_check_by_a_model_needs_one():
    with pytest.raises(ValueError, match="needs a language model"):
        state_check("both")


BRANCH = Plan(
    steps=(
        put(2, "fig"),
        GroundedBranch(line=3, condition=Relation("in", ("fig", "bowl")), skip=2),
        put(4, "pear"),
        Jump(skip=1),
        put(6, "plum"),
        put(7, "lime"),
    )
)


@pytest.mark.parametrize(("slips", "lines"), [(0, [2, 4, 7]), (1, [2, 6, 7])])
def test_a_branch_takes_the_side_that_the_world_tells(slippery, slips, lines):
    found = told(BRANCH, slippery(fig=slips), None, ActionStarted, BranchDecided)
    assert [each.line for each in found if isinstance(each, ActionStarted)] == lines
    (decided,) = [each for each in found if isinstance(each, BranchDecided)]
    assert (decided.line, decided.holds, decided.by_world) == (3, not slips, not slips)


def test_the_model_may_decide_a_branch(slippery):
    decider = state_check("model", Answering("False"))
    started = told(BRANCH, slippery(), decider, ActionStarted)
    assert [each.line for each in started] == [2, 6, 7]


@pytest.mark.parametrize("slips", [0, 1])
def test_a_branch_taken_up_at_any_checkpoint_goes_on_as_it_would_have(slippery, slips):
    world = slippery(fig=slips)
    whole, saved = [], []
    for happening in execute(BRANCH, world):
        whole.append(happening)
        if isinstance(happening, Checkpoint):
            saved.append((happening.next_step, world.save(), len(whole)))
    for next_step, state, seen in saved:
        later = slippery()
        later.restore(state)
        assert list(execute(BRANCH, later, start=next_step)) == whole[seen:]
