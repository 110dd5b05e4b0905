from pathlib import Path

import pytest

from app.domain.condition import AnyOf, Count, Not, Relation
from app.programs.state_query import MAX_FACTS, write_state_query

GOLDEN = Path(__file__).parent / "golden"
FACTS = frozenset(
    {
        Relation("in", ("lime", "fridge")),
        Relation("closed", ("fridge",)),
        Relation("near", ("lime",)),
        Relation("on", ("cup", "table")),
        Relation("held", ("cup",)),
    }
)


def test_the_query_is_the_golden_text_whatever_the_order_of_the_facts():
    text = write_state_query(Relation("open", ("fridge",)), FACTS)
    assert text == (GOLDEN / "state_query.txt").read_text(encoding="utf-8")
    assert text == write_state_query(Relation("open", ("fridge",)), sorted(FACTS, key=str))


@pytest.mark.parametrize(
    ("condition", "seen", "asserted"),
    [
        (Relation("near", ("lime",)), "'lime' in 'fridge'; 'close' to 'lime'", "'close' to 'lime'"),
        (Relation("held", ("cup",)), "'cup' in 'hands'; 'cup' on 'table'", "'cup' in 'hands'"),
        (Not(Relation("on", ("pan", "hob"))), "nothing of it", "not 'pan' on 'hob'"),
        (
            Count("fridge", ("lime", "pie"), 1),
            "'fridge' is 'closed'; 'lime' in 'fridge'; 'close' to 'lime'",
            "count('fridge', 'lime', 'pie') == 1",
        ),
    ],
)
def test_only_facts_of_the_asserted_objects_are_told(condition, seen, asserted):
    *_, last = write_state_query(condition, FACTS).split("\n\n")
    assert last == f"You see: {seen}\nassert({asserted})\n"


def test_there_are_at_least_seven_worked_examples_with_both_answers():
    worked = write_state_query(Relation("near", ("lime",)), ()).split("\n\n")[:-1]
    assert len(worked) >= 7
    answers = [example.splitlines()[-1] for example in worked]
    assert set(answers) == {"True", "False"}


@pytest.mark.parametrize("name", ["x'\nTrue\nYou see: ", "😀" * 200, "a\x00b", "'); assert True #"])
def test_no_name_breaks_out_of_its_quotes(name):
    plain = write_state_query(Relation("near", ("lime",)), [Relation("near", ("lime",))])
    odd = write_state_query(
        AnyOf((Relation("near", (name,)), Relation("held", (name,)))), [Relation("near", (name,))]
    )
    assert odd.count("\n") == plain.count("\n")
    assert odd.count("You see: ") - name.count("You see: ") * 3 == plain.count("You see: ")


def test_of_a_crowded_scene_the_facts_that_matter_most_are_told():
    facts = [Relation("in", (f"ball {n}", "box")) for n in range(500)]
    query = write_state_query(Relation("in", ("ball 99", "box")), facts)
    assert query.count("'ball ") == MAX_FACTS + 1
    assert "'ball 99' in 'box'; " in query or "; 'ball 99' in 'box'\n" in query
