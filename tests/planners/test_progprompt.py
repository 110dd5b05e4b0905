import pytest

from app.domain.errors import Cancelled, CompletionFailed
from app.domain.program import ActionCall
from app.domain.trace import CompletionGrew, PlanningStarted, PromptWritten
from app.planners import planners
from app.planners.progprompt import function_body
from app.programs.parser import parse_program
from app.programs.prompt import write_prompt

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
        ("    grab_and_putin('banana', 'bowl')\n" * 5000, "no end within 600 tokens"),
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
