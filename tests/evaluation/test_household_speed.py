from app.evaluation.household_speed import LONG, bench_household


def test_actions_and_long_plans_of_the_example_programs_are_timed():
    measured = bench_household()
    assert measured.actions > 500
    assert measured.plans > 30
    assert measured.steps >= LONG
    assert 0 < measured.action_seconds[0] < measured.plan_seconds[0]
