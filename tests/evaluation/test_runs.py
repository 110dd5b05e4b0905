from app.evaluation.results import read_results
from app.evaluation.runs import RESULTS, Evaluation, evaluate, next_place


def test_every_task_is_attempted_by_every_method_in_every_run(
    suite, make_cell, open_models, tmp_path
):
    cells = (make_cell("one"), make_cell("two"))
    found = evaluate(Evaluation(suite=suite, cells=cells, runs=3), open_models, tmp_path)
    assert len({result.key for result in found}) == 12
    assert {result.seed for result in found} == {0, 1, 2}
    assert [r.plan.strict for r in found[:2]] == [True, False]


def test_a_rerun_goes_on_where_the_last_one_stopped(suite, make_cell, open_models, tmp_path):
    evaluation = Evaluation(suite=suite, cells=(make_cell(),), runs=2)
    told = []

    def stop(progress):
        told.append(progress)
        return progress.done == 3

    first = evaluate(evaluation, open_models, tmp_path, report=stop)
    assert len(first) == 3
    with (tmp_path / RESULTS).open("a") as file:
        file.write('{"key": "half a li\n')
    every = evaluate(evaluation, open_models, tmp_path, report=lambda p: told.append(p) or False)
    assert every[:3] == first
    assert len(every) == 4
    assert [progress.done for progress in told] == [0, 1, 2, 3, 3, 4]
    assert told[-1].seconds_left == 0


def test_other_switches_under_the_same_names_are_attempted_anew(
    suite, make_cell, open_models, tmp_path
):
    evaluate(Evaluation(suite=suite, cells=(make_cell(),)), open_models, tmp_path)
    again = Evaluation(suite=suite, cells=(make_cell(temperature=0.9),))
    made = []
    evaluate(again, open_models, tmp_path, report=lambda p: made.append(p.last) or False)
    assert len([each for each in made if each]) == 2
    made.clear()
    evaluate(again, open_models, tmp_path, report=lambda p: made.append(p.last) or False)
    assert made == [None]


def test_half_a_line_that_a_death_left_spoils_no_other(suite, make_cell, open_models, tmp_path):
    evaluation = Evaluation(suite=suite, cells=(make_cell(),))
    evaluate(evaluation, open_models, tmp_path)
    whole = (tmp_path / RESULTS).read_bytes()
    (tmp_path / RESULTS).write_bytes(whole[:40] + "ü".encode()[:1])
    assert read_results(tmp_path / RESULTS) == []
    every = evaluate(evaluation, open_models, tmp_path)
    assert read_results(tmp_path / RESULTS) == every


def test_no_attempt_is_begun_after_the_time_is_up(suite, make_cell, open_models, tmp_path):
    evaluation = Evaluation(suite=suite, cells=(make_cell(),), seconds=0.0)
    assert evaluate(evaluation, open_models, tmp_path) == []


def test_languages_are_attempted_where_a_task_has_them(suite, make_cell, open_models, tmp_path):
    evaluation = Evaluation(suite=suite, cells=(make_cell(),), languages=("all",))
    found = evaluate(evaluation, open_models, tmp_path)
    assert [(r.task, r.language) for r in found] == [
        ("banana in the bowl", "en"),
        ("banana in the bowl", "de"),
        ("apple in the bowl", "en"),
    ]
    assert found[1].instruction == "Leg die Banane in die Schüssel"


def test_of_two_lines_with_one_key_the_last_counts(suite, make_cell, open_models, tmp_path):
    evaluation = Evaluation(suite=suite, cells=(make_cell(),))
    evaluate(evaluation, open_models, tmp_path)
    line = (tmp_path / RESULTS).read_text().splitlines()[0]
    with (tmp_path / RESULTS).open("a") as file:
        file.write(line.replace('"verdict": null', '"verdict": {"success": false}') + "\n")
    found = read_results(tmp_path / RESULTS)
    assert len(found) == 2
    assert found[0].verdict is not None


def test_several_processes_find_what_one_finds(suite, make_cell, open_models, tmp_path):
    evaluation = Evaluation(suite=suite, cells=(make_cell(),))
    one = evaluate(evaluation, open_models, tmp_path / "one")
    two = evaluate(evaluation, open_models, tmp_path / "two", jobs=2)
    assert [(r.key, r.plan) for r in one] == [(r.key, r.plan) for r in two]


def test_a_process_goes_on_with_what_begins_like_its_last_attempt(suite, make_cell):
    cells = (make_cell("one"), make_cell("two"))
    waiting = Evaluation(suite=suite, cells=cells).units()
    one, two = waiting[0].start, waiting[-1].start
    assert next_place(waiting, two, set()) == 2
    assert next_place(waiting, None, {one}) == 2
    assert next_place(waiting, "gone", {one, two}) == 0
