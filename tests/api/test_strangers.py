"""Whatever the service's own description allows a stranger to send, and much that it does not."""

import pytest
import schemathesis
from hypothesis import HealthCheck, Phase, given, settings
from schemathesis import GenerationMode
from schemathesis.core.result import Ok

from app.storage.database import Database
from tests.api.conftest import PROGRAM, REQUEST, parts_over, serving
from tests.engines import ENGINES

ENDLESS = "/events$"
"""What follows a plan that nobody works on never ends."""

EXAMPLES = 8
"""Requests for each operation; what is generated is always the same."""


@pytest.fixture(scope="module", params=ENGINES)
def service(request):
    """A service without workers, that holds one of everything."""
    engine = request.getfixturevalue(request.param)
    with engine.migrated() as url, serving(parts_over(Database(url))) as client:
        yield client


@pytest.fixture(scope="module")
def known(service):
    """Values of path parameters that name something."""
    plan = service.post("/plans", json=REQUEST | {"program": PROGRAM}).json()
    suite = {"suite": "robot-tasks", "planners": [{"model": "scripted"}], "limit": 1}
    return {
        "plan_id": plan["id"],
        "execution_id": plan["executions"][0],
        "scene_id": service.post("/scenes", json=REQUEST["scene"]).json()["id"],
        "evaluation_id": service.post("/evaluations", json=suite).json()["id"],
    }


def check(answer):
    assert answer.status_code < 500 or answer.status_code == 503, answer.text
    if answer.status_code >= 400:
        assert answer.headers["content-type"] == ["application/problem+json"], answer.text
        assert answer.json()["detail"]


def strangers(operation):
    """Requests that are as they should be; where anything can be wrong with them, others too."""
    right = operation.as_strategy(generation_mode=GenerationMode.POSITIVE)
    if not len(operation.query) + len(operation.body):
        return right
    return right | operation.as_strategy(generation_mode=GenerationMode.NEGATIVE)


def asking(operation, known):
    """A test of one operation, with ids that name nothing and with those that name something."""

    @settings(
        max_examples=EXAMPLES,
        deadline=None,
        derandomize=True,
        database=None,
        phases=[Phase.generate],
        suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much],
    )
    @given(strangers(operation))
    def ask(case):
        check(case.call())
        ids = {name: known[name] for name in known if name in (case.path_parameters or {})}
        if ids and case.method != "DELETE":
            case.path_parameters.update(ids)
            check(case.call())

    return ask


def test_whatever_is_sent_is_answered_or_refused_with_a_problem_document(service, known):
    described = schemathesis.openapi.from_url(f"{service.base_url}/openapi.json")
    operations = list(described.exclude(path_regex=ENDLESS).get_all_operations())
    assert len(operations) >= 30
    for operation in operations:
        assert isinstance(operation, Ok)
        asking(operation.ok(), known)()
