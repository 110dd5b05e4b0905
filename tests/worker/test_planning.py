import pytest

from app.domain.errors import ModelUnavailable
from app.domain.trace import CompletionGrew
from app.llm.backends.scripted import Answer, ScriptedModel
from app.storage import events, executions, plans
from app.worker import planning_recorder
from app.worker.planning import Planning
from app.worker.planning_recorder import PlanningRecorder
from tests.engines import workflows_table


def told(database, plan_id):
    with database.reading() as session:
        return events.all_of(session, plan_id)


def text_of(happened):
    return "".join(event.text for event in happened if isinstance(event, CompletionGrew))


def test_a_plan_keeps_prompt_completion_program_steps_usage_and_scores(
    make_plan, make_planning, read_plan
):
    plan_id = make_plan()
    make_planning()(plan_id)
    plan = read_plan(plan_id)
    assert plan.status == "executing"
    assert "put_the_fruits_in_the_bowl" in plan.prompt
    assert plan.completion in plan.program
    assert [step["arguments"] for step in plan.steps] == [["banana", "bowl"], ["apple", "bowl"]]
    assert plan.steps[0]["comment"] == "1: put the banana in the bowl"
    assert plan.rejected == []
    assert plan.usage["model"] == "scripted"
    assert plan.plan_scores["sr"] == 1


def test_the_events_tell_the_completion_word_for_word(
    database, make_plan, make_planning, read_plan
):
    plan_id = make_plan()
    make_planning()(plan_id)
    happened = told(database, plan_id)
    assert text_of(happened) == read_plan(plan_id).completion
    assert [event.kind for event in happened[:2]] == ["planning_started", "prompt_written"]
    assert happened[-1].kind == "program_grounded"


def test_a_plan_that_is_to_be_executed_gets_an_execution_on_the_simulation_queue(
    database, make_plan, make_planning
):
    plan_id = make_plan()
    make_planning()(plan_id)
    with database.reading() as session:
        [(execution_id, status)] = executions.of_plan(session, plan_id)
        queue = session.connection().exec_driver_sql(
            f"SELECT queue_name FROM {workflows_table(database)} "
            f"WHERE workflow_uuid = '{execution_id}'"
        )
        assert (status, queue.scalar()) == ("queued", "simulation")


@pytest.mark.parametrize(
    ("asked", "status"),
    [({"execute": False}, "planned"), ({"approval": "manual"}, "awaiting_approval")],
)
def test_a_plan_that_is_not_to_be_executed_yet_rests(
    database, make_plan, make_planning, read_plan, asked, status
):
    plan_id = make_plan(**asked)
    make_planning()(plan_id)
    assert read_plan(plan_id).status == status
    with database.reading() as session:
        assert executions.of_plan(session, plan_id) == []


def test_a_call_of_what_is_not_there_is_rejected_and_told(make_plan, make_planning, read_plan):
    plan_id = make_plan()
    make_planning(Answer(text="    grab_and_putin('unicorn', 'bowl')\n"))(plan_id)
    [rejected] = read_plan(plan_id).rejected
    assert "unicorn" in rejected["reason"]


@pytest.mark.parametrize(
    ("answer", "reason"),
    [
        (Answer(text=""), "wrote nothing"),
        (Answer(text="lorem ipsum"), "wrote no plan"),
        (Answer(text="    # on and on\n", endless=True), "no end"),
        (Answer(error="the endpoint is on fire"), "the endpoint is on fire"),
        (Answer(text="    import os\n"), "no plan"),
    ],
)
def test_a_useless_completion_ends_as_a_failed_plan_with_the_reason(
    make_plan, make_planning, read_plan, answer, reason
):
    plan_id = make_plan()
    make_planning(answer)(plan_id)
    plan = read_plan(plan_id)
    assert plan.status == "failed"
    assert reason in plan.error


def test_a_useless_completion_is_kept_all_the_same(make_plan, make_planning, read_plan):
    plan_id = make_plan()
    make_planning(Answer(text="lorem ipsum"))(plan_id)
    plan = read_plan(plan_id)
    assert plan.completion == "lorem ipsum"
    assert plan.prompt is not None


def test_a_model_that_cannot_be_had_ends_as_a_failed_plan(database, handover, make_plan, read_plan):
    def unavailable(*names):
        raise ModelUnavailable("fetch the weights with 'progprompt models fetch'")

    plan_id = make_plan()
    Planning(database, handover, unavailable)(plan_id)
    assert read_plan(plan_id).status == "failed"
    assert "progprompt models fetch" in read_plan(plan_id).error


def test_a_plan_cancelled_while_the_model_writes_stops_there(
    database, handover, make_plan, read_plan
):
    plan_id = make_plan()

    def write(prompt):
        with database.transaction() as session:
            plans.get(session, plan_id).status = "cancelled"
        return Answer(text="    # on and on\n", endless=True, delay=0.002)

    Planning(database, handover, lambda *names: ScriptedModel(write))(plan_id)
    assert read_plan(plan_id).status == "cancelled"
    assert read_plan(plan_id).program is None
    kinds = [event.kind for event in told(database, plan_id)]
    assert kinds == ["planning_started", "prompt_written"]


def test_a_mere_question_whether_to_stop_is_answered_and_not_told(database, make_plan, monkeypatch):
    plan_id = make_plan(status="planning")
    recorder = PlanningRecorder(database, plan_id)
    monkeypatch.setattr(planning_recorder, "FLUSH_INTERVAL", 60.0)
    recorder.flush()
    assert not recorder.report(CompletionGrew(text="pick"))
    assert told(database, plan_id) == [], "waits for its turn to be written down"
    monkeypatch.setattr(planning_recorder, "FLUSH_INTERVAL", 0.0)
    assert not recorder.report(CompletionGrew(text=""))
    with database.transaction() as session:
        plans.get(session, plan_id).status = "cancelled"
    assert recorder.report(CompletionGrew(text=""))
    assert told(database, plan_id) == [CompletionGrew(text="pick")]


def test_a_cancelled_plan_is_not_taken_up(database, make_plan, make_planning, read_plan):
    plan_id = make_plan(status="cancelled")
    make_planning()(plan_id)
    assert read_plan(plan_id).status == "cancelled"
    assert told(database, plan_id) == []


class Killed(BaseException):
    """The process dies; nobody may catch this."""


class DyingModel(ScriptedModel):
    """Dies after some pieces."""

    def complete(self, request, on_text=None):
        count = 0

        def dying(piece):
            nonlocal count
            count += 1
            if count > 6:
                raise Killed
            return on_text is not None and on_text(piece)

        return super().complete(request, dying)


def test_planning_taken_up_after_a_death_tells_nothing_twice_and_loses_nothing(
    database, handover, make_plan, make_planning, read_plan
):
    plan_id = make_plan()
    body = "    # 1: put the banana in the bowl\n    grab_and_putin('banana', 'bowl')\n"
    with pytest.raises(Killed):
        Planning(database, handover, lambda *names: DyingModel([Answer(text=body, delay=0.05)]))(
            plan_id
        )
    before = told(database, plan_id)
    assert 0 < len(text_of(before)) < len(body)
    make_planning(Answer(text=body))(plan_id)
    after = told(database, plan_id)
    assert after[: len(before)] == before
    assert text_of(after) == body
    assert [event.kind for event in after].count("planning_started") == 1
    assert read_plan(plan_id).status == "executing"


def test_a_model_that_writes_otherwise_the_second_time_begins_a_new_story(
    database, handover, make_plan, make_planning
):
    plan_id = make_plan()
    first = [Answer(text="    # something else altogether, and more of it\n", delay=0.05)]
    with pytest.raises(Killed):
        Planning(database, handover, lambda *names: DyingModel([*first, *first]))(plan_id)
    before = told(database, plan_id)
    make_planning()(plan_id)
    after = told(database, plan_id)[len(before) :]
    assert after[0].kind == "planning_started"
    assert "grab_and_putin('apple', 'bowl')" in text_of(after)


def test_a_plan_that_kills_its_worker_three_times_is_given_up(
    database, handover, make_plan, read_plan
):
    plan_id = make_plan()

    def die(*names):
        raise Killed

    for _ in range(3):
        with pytest.raises(Killed):
            Planning(database, handover, die)(plan_id)
    Planning(database, handover, die)(plan_id)
    assert read_plan(plan_id).status == "failed"
    assert "died 3 times" in read_plan(plan_id).error


def test_a_worker_that_stops_in_good_order_does_not_count_as_a_death(
    database, handover, make_plan, make_planning, read_plan
):
    plan_id = make_plan()

    def die(*names):
        raise Killed

    planning = Planning(database, handover, die)
    for _ in range(5):
        with pytest.raises(Killed):
            planning(plan_id)
        planning.stopping(plan_id)
    make_planning()(plan_id)
    assert read_plan(plan_id).status == "executing"
