import pytest

from app.planners.langprompt import LangPrompt

pytestmark = [pytest.mark.model, pytest.mark.timeout(1800)]


def program(text, task, canned):
    model = canned(text)
    draft = LangPrompt().write_program(task(name="langprompt", examples=1), model, lambda _: False)
    return draft.program.splitlines()[1:], draft


def test_prompt_says_the_examples_and_the_objects_in_plain_english(task, canned):
    _, draft = program(" done", task, canned)
    assert draft.prompt == (
        "Task: put the spoon in the mug\n"
        "Objects: hammer, spoon, mug, sponge, jar\n"
        "1. grab the spoon and put it in the mug\n"
        "2. done\n"
        "\n"
        "Task: put the banana in the bowl\n"
        "Objects: banana, bowl\n"
        "1."
    )


def test_each_step_becomes_the_nearest_action_below_it_as_a_comment(task, canned):
    lines, draft = program(" Drop the banana into the bowl.\n2. done\n3. more", task, canned)
    assert lines == ["    # Drop the banana into the bowl", "    grab_and_putin('banana', 'bowl')"]
    assert draft.completion.text == " Drop the banana into the bowl.\n2. done\n3. more"


def test_step_that_is_no_action_is_told_and_left_out(task, canned):
    lines, _ = program(" Whistle a merry tune\n2. done", task, canned)
    assert lines == ["    # Whistle a merry tune"]


def test_plan_of_no_step_does_nothing(task, canned):
    lines, _ = program(" done", task, canned)
    assert lines == ["    pass"]
