"""Metrics in Prometheus' text form."""

from collections.abc import Iterator, Mapping

from fastapi import APIRouter, Request, Response

from app.api.parts import Using
from app.storage import executions, plans, workers

router = APIRouter(tags=["health"])


@router.get("/metrics", response_class=Response)
def read_metrics(request: Request, parts: Using) -> Response:
    """Requests answered, plans and executions by status, workers alive."""
    with parts.database.reading() as session:
        plans_by_status = plans.count_by_status(session)
        executions_by_status = executions.count_by_status(session)
        alive = workers.alive(session)
    requests: Mapping[tuple[str, str, int], int] = request.app.state.requests
    lines = [
        *_family(
            "requests_total",
            "counter",
            {
                f'method="{method}",route="{route}",status="{status}"': count
                for (method, route, status), count in sorted(requests.items())
            },
        ),
        *_family("plans", "gauge", _labelled("status", plans_by_status)),
        *_family("executions", "gauge", _labelled("status", executions_by_status)),
        *_family("worker_ready", "gauge", _labelled("worker", {w.id: int(w.ready) for w in alive})),
    ]
    return Response("\n".join(lines) + "\n", media_type="text/plain; version=0.0.4")


def _labelled(label: str, values: Mapping[str, int]) -> dict[str, int]:
    return {f'{label}="{name}"': value for name, value in sorted(values.items())}


def _family(name: str, kind: str, values: Mapping[str, int]) -> Iterator[str]:
    yield f"# TYPE progprompt_{name} {kind}"
    for labels, value in values.items():
        yield f"progprompt_{name}{{{labels}}} {value}"
