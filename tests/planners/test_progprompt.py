import time
from dataclasses import replace

import pytest

from app.domain.errors import Cancelled, CompletionFailed
from app.domain.llm import Completion
from app.domain.planner import Preambled, Turn
from app.domain.program import ActionCall
from app.domain.trace import CompletionContinued, CompletionGrew, PlanningStarted, PromptWritten
from app.llm.backends.scripted import Answer, ScriptedModel
from app.planners import planners
from app.planners.progprompt import MAX_CONTINUATIONS, function_body, whole_lines
from app.programs.parser import parse_program
from app.programs.prompt import write_prompt
from app.programs.transcript import LOOK_EVERY

GOOD = "    # 1: put the banana in the bowl\n    grab_and_putin('banana', 'bowl')\n    # 2: Done\n"


@pytest.fixture
def write():
    def run(task, model, report=lambda _: False):
        return planners["progprompt"].write_program(task, model, report)

    return run


def test_the_completion_becomes_the_body_of_the_cued_function(task, canned, write):
    draft = write(task(), canned(f"{GOOD}\ndef next_one():\n    pass\n"))
    assert draft.prompt == write_prompt(task())
    assert draft.program == (
        f"def put_the_banana_in_the_bowl():\n    objects = ['banana', 'bowl']\n{GOOD}"
    )
    program = parse_program(draft.program)
    assert [each for each in program.body if isinstance(each, ActionCall)] == [
        ActionCall(action="grab_and_putin", arguments=("banana", "bowl"))
    ]


def test_events_tell_how_the_completion_grew(task, canned, write):
    events = []
    draft = write(task(), canned(GOOD), lambda event: bool(events.append(event)))
    started, written, *pieces = events
    assert started == PlanningStarted(planner="progprompt", model="canned")
    assert written == PromptWritten(characters=len(draft.prompt))
    assert len(pieces) > 4
    assert "".join(piece.text for piece in pieces) == draft.completion.text


def test_a_model_that_does_not_stream_is_told_of_at_the_end(task, canned, write):
    events = []
    write(task(), canned(GOOD, streams=False), lambda event: bool(events.append(event)))
    assert events[2:] == [CompletionGrew(text=GOOD)]


@pytest.mark.parametrize(
    ("options", "follows", "bound"),
    [({}, True, True), ({"constrained": False}, True, False), ({}, False, False)],
)
def test_a_grammar_binds_where_it_is_wanted_and_can(task, canned, write, options, follows, bound):
    model = canned(GOOD, follows_grammar=follows)
    write(task(**options), model)
    assert (model.requests[0].grammar is not None) == bound


def test_options_reach_the_model(task, canned, write):
    model = canned(GOOD)
    write(task(temperature=0.7, seed=5, max_tokens=99), model)
    (request,) = model.requests
    assert (request.temperature, request.seed, request.max_tokens) == (0.7, 5, 99)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "wrote nothing"),
        (" \n\n", "wrote nothing"),
        ("I am sorry, I cannot do that.", "wrote no plan but 'I am sorry"),
        ("    banana bowl banana\n", "is no plan: program.line 3"),
        ("    import os\n    os.system('ls')\n", "program.line 3"),
        ("    # 1: think\n", "no statement"),
        ("    # " + "so " * 5000, "no end within 600 tokens"),
    ],
)
def test_an_unusable_completion_fails_with_the_reason_and_is_kept(
    task, canned, write, text, reason
):
    with pytest.raises(CompletionFailed) as failed:
        write(task(), canned(text, follows_grammar=False))
    assert reason in str(failed.value)
    assert failed.value.prompt == write_prompt(task())
    assert failed.value.completion is not None
    assert text.startswith(failed.value.completion.text)


@pytest.mark.parametrize("wish_at", [0, 1, 2, 4])
def test_a_wish_to_stop_is_heard_at_every_event(task, canned, write, wish_at):
    events = []

    def report(event):
        events.append(event)
        return len(events) > wish_at

    with pytest.raises(Cancelled):
        write(task(), canned(GOOD), report)
    assert len(events) == wish_at + 1


def test_a_wish_to_stop_is_heard_while_the_prompt_is_read(task, canned, write):
    class SlowReader(canned):
        def complete(self, request, on_text=None):
            for _ in range(20):
                time.sleep(LOOK_EVERY / 4)
                if on_text and on_text(""):
                    self.stopped = True
                    return replace(super().complete(request), text="", finish="cancelled")
            return super().complete(request, on_text)

    model = SlowReader(GOOD)
    with pytest.raises(Cancelled):
        write(task(), model, lambda event: isinstance(event, CompletionGrew))
    assert model.stopped


@pytest.mark.parametrize(
    ("text", "body"),
    [
        (GOOD, GOOD),
        ("\n" + GOOD + "\n\nprint('done')\n", GOOD),
        (f"```python\ndef f():\n    objects = ['x']\n{GOOD}```\nThis does it.", GOOD),
        (f"def put_the_banana_in_the_bowl():\n{GOOD}", GOOD),
        ("    pass", "    pass\n"),
        ("    pass\r\n    # so", "    pass\n    # so\n"),
        ("Sure!\n    pass", ""),
    ],
)
def test_the_body_ends_where_the_indentation_does(text, body):
    assert function_body(text) == body


class CutOff:
    """Goes on with a text from where its prompt ends, and comes so far in one go."""

    name = "cut off"

    def __init__(self, text, reach, *, follows_grammar=False):
        self.text = text
        self.reach = reach
        self.follows_grammar = follows_grammar
        self.requests = []

    def complete(self, request, on_text=None):
        self.requests.append(request)
        written = request.prompt.removeprefix(self.requests[0].prompt)
        rest = self.text[len(written) :] if self.text.startswith(written) else self.text
        text = rest[: self.reach]
        if on_text:
            on_text(text)
        return Completion(
            text=text,
            model=self.name,
            finish="stop" if len(text) == len(rest) else "length",
            prompt_tokens=10,
            completion_tokens=5,
            seconds=0.5,
        )

    def score(self, prompt, candidates):
        raise NotImplementedError


def steps(number):
    """So many different ones of the same length."""
    return "".join(f"    grab_and_putin('b{one:05}', 'bowl')\n" for one in range(number))


LONG = f"    # 1: one after the other\n{steps(5)}    # 2: Done\n"


def test_a_completion_that_was_cut_off_is_gone_on_with_from_its_last_whole_line(task, write):
    events, model = [], CutOff(LONG, 100)
    draft = write(task(), model, lambda event: bool(events.append(event)))
    assert draft.completion.text == LONG
    assert draft.program.endswith(LONG)
    first, *later = model.requests
    assert len(later) == 2
    for request in later:
        kept = request.prompt.removeprefix(first.prompt)
        assert kept
        assert kept.endswith("\n")
        assert LONG.startswith(kept)
    assert draft.completion.completion_tokens == 15
    assert draft.completion.seconds == 1.5
    assert rebuilt(events) == LONG


def rebuilt(events):
    """The completion as somebody who listens to the events has it."""
    text = ""
    for event in events:
        if isinstance(event, CompletionGrew):
            text += event.text
        elif isinstance(event, CompletionContinued):
            text = text[: event.kept]
    return text


def test_what_goes_on_is_bound_by_the_grammar_of_a_begun_body(task, write):
    model = CutOff(LONG, 150, follows_grammar=True)
    write(task(), model)
    begun = [request.grammar.startswith("root ::= (step{0,") for request in model.requests]
    assert begun == [False, True]


def test_a_model_that_never_comes_to_an_end_is_asked_so_often_and_no_more(task, write):
    model = CutOff(steps(500), 200)
    with pytest.raises(CompletionFailed, match="no end within 15 tokens"):
        write(task(), model)
    assert len(model.requests) == 1 + MAX_CONTINUATIONS


@pytest.mark.parametrize(
    ("text", "kept"),
    [
        ("", ""),
        ("    grab('a", ""),
        ("    grab('a')\n    gra", "    grab('a')\n"),
        ("    grab('a')\n    assert('a' in 'b')\n        el", "    grab('a')\n"),
        ("    assert('a' in 'b')\n        else: c()\n   ", "    assert('a' in 'b')\n        else: c()\n"),
        ("    # a\u2028assert\n    x", "    # a\u2028assert\n"),
    ],
)  # fmt: skip
def test_whole_lines_are_kept_and_assertions_with_their_recoveries(text, kept):
    assert whole_lines(text) == kept


def test_the_prompt_begins_with_the_preamble(task):
    planner = planners["progprompt"]
    assert isinstance(planner, Preambled)
    assert write_prompt(task()).startswith(planner.preamble("tabletop", task().actions))


def test_the_dialogue_and_the_failed_try_reach_the_model(task, canned, write):
    failed = Turn(
        instruction="put the banana in the bowl",
        program="def put_the_banana_in_the_bowl():\n    grab_and_putin('banana', 'bowl')\n",
        outcome="the banana slipped",
    )
    model = canned(GOOD)
    draft = write(replace(task(), failed=failed), model)
    assert "# what happened: the banana slipped\n" in model.requests[0].prompt
    assert model.requests[0].grammar
    assert parse_program(draft.program).name == "finish_put_the_banana_in_the_bowl"


def test_a_model_that_runs_in_circles_is_stopped_and_one_round_is_kept(task, write):
    events, body = [], steps(2)
    model = ScriptedModel([Answer(text=body, endless=True)])
    draft = write(task(), model, lambda event: bool(events.append(event)))
    assert draft.program.endswith(body)
    assert draft.program.count("b00001") == 1
    assert draft.completion.completion_tokens < 40
    assert rebuilt(events) == body
