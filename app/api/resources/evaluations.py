"""Evaluations: start one, watch it, read its tables, compare it, stop it."""

from collections.abc import Callable, Sequence
from typing import Annotated, Any, Literal

from fastapi import APIRouter, Path, Query, Response

from app.api.paging import Cursor, Limit, part, position
from app.api.parts import Parts, Using
from app.api.schemas.base import Page
from app.api.schemas.evaluations import (
    ComparisonShown,
    EvaluationGiven,
    EvaluationShown,
    SuiteShown,
    TablesShown,
    VerdictGiven,
    show_evaluation,
)
from app.api.schemas.plans import PlannerGiven
from app.domain.errors import Conflict, Fault, Refused, UnknownName
from app.domain.planner import PlannerOptions
from app.evaluation.comparison import compare
from app.evaluation.metrics import BY_NAME, by_cell
from app.evaluation.report import html_report
from app.evaluation.results import Result, read_result
from app.evaluation.suites import find_suite, suites
from app.evaluation.tables import Table, csv_text, markdown, table_document, tables
from app.evaluation.wanted import Wanted
from app.llm.models import find_model
from app.storage import evaluations
from app.storage.base import new_id, now
from app.storage.evaluations import UNFINISHED, EvaluationRow
from app.worlds import worlds

router = APIRouter(prefix="/evaluations", tags=["evaluations"])

MOST_ATTEMPTS = 100_000


@router.post("", status_code=202)
def start_evaluation(given: EvaluationGiven, parts: Using, response: Response) -> EvaluationShown:
    """Measure planners and models on a suite; it runs while the answer is already here."""
    wanted = _wanted(parts, given)
    total = len(wanted.evaluation().units())
    if not 0 < total <= MOST_ATTEMPTS:
        message = f"come to {total} attempts; 1 to {MOST_ATTEMPTS} are taken"
        raise Refused(Fault(field="tasks", message=message))
    row = EvaluationRow(
        id=new_id("ev"),
        created_at=now(),
        status="queued",
        suite=wanted.suite,
        request=wanted.document,
        total=total,
        lanes=min(given.lanes, total),
    )
    with parts.database.transaction() as session:
        session.add(row)
        session.flush()
        for index in range(row.lanes):
            parts.jobs.enqueue(session, "planning", f"{row.id}:{index}")
    response.headers["Location"] = f"/evaluations/{row.id}"
    return show_evaluation(row, 0)


@router.get("", response_model=Page)
def list_evaluations(parts: Using, limit: Limit = 20, cursor: Cursor = None) -> Response:
    """Evaluations, newest first."""
    with parts.database.reading() as session:
        rows = evaluations.page(session, before=position(cursor), limit=limit + 1)
        return part(
            rows, limit, lambda row: show_evaluation(row, evaluations.count_done(session, row.id))
        )


@router.get("/suites", response_model=Page)
def list_suites() -> Page:
    """The suites there are."""
    return Page(items=[_suite(name).model_dump(mode="json") for name in suites()], next=None)


@router.get("/{evaluation_id}")
def read_evaluation(evaluation_id: str, parts: Using) -> EvaluationShown:
    """One evaluation: how far it is, and how long it may still take."""
    with parts.database.reading() as session:
        row = evaluations.get(session, evaluation_id)
        return show_evaluation(row, evaluations.count_done(session, evaluation_id))


@router.get("/{evaluation_id}/results", response_model=Page)
def read_results(
    evaluation_id: str,
    parts: Using,
    limit: Annotated[int, Query(ge=1, le=1000, description="Results of one part.")] = 100,
    cursor: Cursor = None,
) -> Page:
    """What came of every attempt so far: program, scores, mistakes."""
    after = position(cursor)
    with parts.database.reading() as session:
        evaluations.get(session, evaluation_id)
        last = -1 if after is None else after
        rows = evaluations.results(session, evaluation_id, after=last, limit=limit + 1)
    items = [{"index": row.index, **(row.result or {})} for row in rows[:limit]]
    return Page(items=items, next=str(rows[limit - 1].index) if len(rows) > limit else None)


@router.get("/{evaluation_id}/tables", response_class=Response)
def read_tables(
    evaluation_id: str,
    parts: Using,
    form: Annotated[
        Literal["json", "csv", "markdown", "html"],
        Query(alias="format", description="`html` is one page that needs nothing else."),
    ] = "json",
) -> Response:
    """Its tables, over the attempts there are results of so far."""
    row, results = _results(parts, evaluation_id)
    found = tables(results)
    write, media_type = _FORMS[form]
    return Response(write(f"Evaluation on {row.suite}", found, results), media_type=media_type)


@router.get("/{evaluation_id}/comparison")
def compare_evaluations(
    evaluation_id: str,
    parts: Using,
    other: Annotated[str, Query(max_length=32, description="The evaluation to compare with.")],
    metric: Annotated[str, Query(max_length=20, description="What is compared.")] = "strict",
) -> ComparisonShown:
    """The other one minus this one, task by task: difference, its interval, and the sign test."""
    if metric not in BY_NAME:
        raise UnknownName("metric", metric, BY_NAME)
    pair = [_results(parts, each)[1] for each in (evaluation_id, other)]
    for each, results in zip((evaluation_id, other), pair, strict=True):
        if len(by_cell(results)) != 1:
            raise Conflict(f"evaluation {each} is to have results of exactly one method")
    found = compare(pair[0], pair[1], BY_NAME[metric], (evaluation_id, other))
    return ComparisonShown.model_validate(found)


@router.put("/{evaluation_id}/results/{index}/verdict")
def give_verdict(
    evaluation_id: str,
    index: Annotated[int, Path(ge=0, lt=MOST_ATTEMPTS)],
    given: VerdictGiven,
    parts: Using,
) -> dict[str, Any]:
    """Keep a person's verdict beside the automatic one; the result as it then is."""
    with parts.database.transaction() as session:
        evaluations.get(session, evaluation_id, lock=True)
        row = evaluations.result(session, evaluation_id, index)
        if row.result is None:
            raise Conflict("the attempt is not finished")
        judged = {**row.result, "verdict": given.model_dump()}
        row.result = judged
        return {"index": index, **judged}


@router.post("/{evaluation_id}/cancel", status_code=202)
def cancel_evaluation(evaluation_id: str, parts: Using) -> EvaluationShown:
    """Stop it; the results until then are kept, and their tables can be read."""
    with parts.database.transaction() as session:
        row = evaluations.get(session, evaluation_id, lock=True)
        if row.status in UNFINISHED:
            row.status, row.finished_at = "cancelled", now()
        elif row.status != "cancelled":
            raise Conflict(f"the evaluation is {row.status} already")
        return show_evaluation(row, evaluations.count_done(session, evaluation_id))


def _wanted(parts: Parts, given: EvaluationGiven) -> Wanted:
    if given.suite not in suites():
        raise UnknownName("suite", given.suite, suites())
    world = worlds[find_suite(given.suite).tasks[0].scene.world]
    methods = tuple(
        _options(parts, each, world.feedback, world.planner, given.seed) for each in given.planners
    )
    wanted = Wanted(
        suite=given.suite,
        methods=methods,
        runs=given.runs,
        languages=tuple(given.languages),
        physics=given.physics,
        split=given.split,
        categories=tuple(given.categories),
        tasks=tuple(given.tasks),
        limit=given.limit,
    )
    wanted.evaluation()
    return wanted


def _options(
    parts: Parts, given: PlannerGiven, feedback: bool, best: str, seed: int
) -> PlannerOptions:
    values = given.model_dump()
    named = {given.model, parts.default_model} != {"default"}
    values["name"] = given.name or ("progprompt" if named else best)
    values["feedback"] = feedback if given.feedback is None else given.feedback
    find_model(given.model, parts.llm)
    return PlannerOptions(**values, seed=seed)


def _results(parts: Parts, evaluation_id: str) -> tuple[EvaluationRow, list[Result]]:
    with parts.database.reading() as session:
        row = evaluations.get(session, evaluation_id)
        rows = evaluations.results(session, evaluation_id)
    return row, [read_result(each.result) for each in rows]


def _suite(name: str) -> SuiteShown:
    tasks = find_suite(name).tasks
    return SuiteShown(
        name=name,
        tasks=len(tasks),
        worlds=sorted({task.scene.world for task in tasks}),
        categories=list(dict.fromkeys(task.category for task in tasks)),
        languages=sorted({"en", *(code for task in tasks for code in task.variants)}),
        test=sum(task.split == "test" for task in tasks),
    )


def _as_json(title: str, found: Sequence[Table], results: Sequence[Result]) -> str:
    del results  # Read on their own.
    shown = [table_document(table) for table in found]
    return TablesShown(title=title, tables=shown).model_dump_json()


def _as_csv(title: str, found: Sequence[Table], results: Sequence[Result]) -> str:
    del title, results  # A CSV holds figures only.
    return csv_text(found)


def _as_markdown(title: str, found: Sequence[Table], results: Sequence[Result]) -> str:
    del results  # Read on their own.
    return f"# {title}\n\n{markdown(found)}"


_FORMS: dict[str, tuple[Callable[[str, Sequence[Table], Sequence[Result]], str], str]] = {
    "json": (_as_json, "application/json"),
    "csv": (_as_csv, "text/csv; charset=utf-8"),
    "markdown": (_as_markdown, "text/markdown; charset=utf-8"),
    "html": (html_report, "text/html; charset=utf-8"),
}
