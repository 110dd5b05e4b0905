import json
from pathlib import Path

import app.programs.knowledge.hazards as module
from app.programs.knowledge.hazards import hazard

CASES = json.loads((Path(module.FILE).with_name("hazard-cases.json")).read_text(encoding="utf-8"))


def test_hazards_are_refused_and_harmless_things_are_not():
    refused = [case for case in CASES if hazard(case["thing"], case["place"])]
    hazardous = [case for case in CASES if case["hazardous"]]
    assert len(hazardous) >= 40
    assert len(CASES) - len(hazardous) >= 40
    assert [case for case in hazardous if case not in refused] == []
    assert [case for case in refused if case not in hazardous] == []


def test_the_reason_is_for_a_person_to_read():
    found = hazard("bleach", "coffee mug")
    assert found
    assert "poison" in found.reason
