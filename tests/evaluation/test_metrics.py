from dataclasses import replace

import pytest

from app.evaluation.comparison import compare
from app.evaluation.metrics import BY_NAME, figure, length_class, short
from app.evaluation.results import Verdict
from app.evaluation.tables import csv_text, markdown, tables

RIGHT = "grab_and_putin('banana', 'bowl')"
WRONG = "grab_and_putin('apple', 'bowl')"
STRICT = BY_NAME["strict"]


@pytest.fixture
def good(make_task, try_it):
    return try_it(make_task(), RIGHT)


@pytest.fixture
def bad(make_task, try_it):
    return try_it(make_task(), WRONG)


def known(runs, metric):
    found = figure(runs, metric)
    assert found is not None
    return found


def test_the_spread_is_over_the_means_of_the_runs_as_in_the_paper(good, bad):
    other = [replace(each, task="other") for each in (good, bad)]
    runs = [replace(r, run=k) for k, pair in enumerate(((good, other[0]), (bad, other[0])))
            for r in pair]  # fmt: skip
    found = known(runs, STRICT)
    assert found.mean == 0.75
    assert found.std == pytest.approx(0.3535, abs=1e-3)
    assert str(found) == ".75 ± .35"
    assert known([good, other[1]], STRICT).std is None


def test_the_interval_is_wilsons_for_single_runs_and_bootstrapped_over_tasks_for_more(good, bad):
    single = known([good, replace(bad, task="other")], STRICT)
    assert (single.low, single.high) == pytest.approx((0.0945, 0.9055), abs=1e-3)
    same = [replace(good, run=run) for run in range(5)]
    assert (known(same, STRICT).low, known(same, STRICT).high) == (1, 1)


def test_sr_is_of_physics_or_of_a_person_and_else_unknown_on_the_tabletop(good):
    assert figure([good], BY_NAME["sr"]) is None
    assert known([replace(good, physics=good.plan)], BY_NAME["sr"]).mean == 1
    judged = replace(good, physics=good.plan, verdict=Verdict(success=False))
    assert known([judged], BY_NAME["sr"]).mean == 0


def test_a_program_that_cannot_be_used_executes_nothing(make_task, try_it):
    assert known([try_it(make_task(), "import os")], BY_NAME["exec"]).mean == 0


@pytest.mark.parametrize(
    ("steps", "name"), [(0, "0-5"), (5, "0-5"), (6, "6-10"), (18, "11-18"), (19, "19 and more")]
)
def test_lengths_are_classed_as_in_the_paper(good, steps, name):
    assert length_class(replace(good, steps=steps)) == name


@pytest.mark.parametrize(("value", "text"), [(0, ".00"), (0.344, ".34"), (0.999, "1"), (1, "1")])
def test_figures_are_printed_as_the_paper_does(value, text):
    assert short(value) == text


def test_two_methods_are_compared_over_the_pairs_both_have(good, bad):
    first = [replace(bad, task=str(n)) for n in range(8)]
    second = [replace(good, task=str(n)) for n in range(1, 9)]
    found = compare(first, second, STRICT, ("a", "b"))
    assert (found.pairs, found.only_second, found.only_first) == (7, 7, 0)
    assert found.difference == 1
    assert found.p == pytest.approx(2 / 2**7)
    assert found.verdict == "b is better"
    assert compare(first, first, STRICT, ("a", "a")).verdict == "no difference shown"


def test_every_table_is_written_as_markdown_and_csv(good, bad):
    results = [good, replace(bad, cell="other", language="de")]
    found = tables(results)
    names = [table.name for table in found]
    assert names == ["methods", "category", "length", "language", "tasks", "mistakes", "pairs"]
    assert "| paper | 1 | 1 | 1 |" in markdown(found)
    lines = csv_text(found).splitlines()
    assert lines[0] == "table,row,column,value,std,low,high,count"
    assert "mistakes,missing step,other,1,,,," in lines
    assert tables([]) == []
