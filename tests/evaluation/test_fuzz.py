from app.evaluation.fuzz import fuzz_programs


def test_thousands_of_mutated_programs_bring_programs_or_refusals():
    report = fuzz_programs(5000, seed=3)
    assert report.broken == ()
    assert report.cases == 5000
    assert 500 < report.parsed < 4500, "the mutations neither all pass nor all fail"
    assert report.slowest < 5.0, (
        "one that hangs takes longer; collecting the garbage of all tests does not"
    )
    assert report.grown < 50_000


def test_the_same_seed_sends_the_same_texts():
    assert fuzz_programs(200, seed=1).parsed == fuzz_programs(200, seed=1).parsed
