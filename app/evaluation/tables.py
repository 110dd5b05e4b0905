"""Tables: what an evaluation amounts to, in rows; as Markdown and as CSV."""

import csv
import io
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from app.evaluation.comparison import compare
from app.evaluation.metrics import (
    BY_NAME,
    Figure,
    Metric,
    by_cell,
    figure,
    grouped,
    length_class,
)
from app.evaluation.mistakes import KINDS
from app.evaluation.printed import Printed
from app.evaluation.results import Result

Entry = str | int | Figure | Printed | None
MAIN = ("sr", "plan_sr", "strict", "gcr", "exec", "precision", "seconds")
CORE = ("sr", "core_sr", "strict", "gcr", "core_gcr", "exec", "precision", "seconds")


@dataclass(frozen=True, slots=True, kw_only=True)
class Table:
    """Figures in rows; the first column says what of."""

    name: str
    title: str
    columns: tuple[str, ...]
    rows: tuple[tuple[Entry, ...], ...]
    note: str = ""


def tables(results: Sequence[Result]) -> list[Table]:
    """Every table that the results fill."""
    if not results:
        return []
    main = BY_NAME["strict"]
    found = [
        methods(results),
        breakdown(results, main, "category", "By category", lambda result: result.category),
        breakdown(results, main, "length", "By length of the ground truth", length_class),
    ]
    for name, title, key in (
        ("environment", "By environment", lambda result: result.environment),
        ("language", "By language", lambda result: result.language),
        ("split", "By split", lambda result: result.split),
    ):
        if len({key(result) for result in results}) > 1:
            found.append(breakdown(results, main, name, title, key))
    found += [tasks(results), wrong(results)]
    cells = by_cell(results)
    if len(cells) > 1:
        found.append(pairs(cells, main))
    return found


def methods(results: Sequence[Result]) -> Table:
    """One row for each method, one column for each metric."""
    goals_differ = any(
        r.plan.scores.get("core_gcr") != r.plan.scores.get("gcr")
        for r in results
        if not r.impossible
    )
    metrics = [BY_NAME[name] for name in (CORE if goals_differ else MAIN)]
    metrics = [metric for metric in metrics if figure(results, metric) is not None]
    rows = tuple(
        (cell, len(of_cell), *(figure(of_cell, metric) for metric in metrics))
        for cell, of_cell in by_cell(results).items()
    )
    return Table(
        name="methods",
        title="Methods",
        columns=("method", "n", *(metric.title for metric in metrics)),
        rows=rows,
        note="; ".join(f"{metric.title}: {metric.meaning}" for metric in metrics) + ".",
    )


def breakdown(
    results: Sequence[Result],
    metric: Metric,
    name: str,
    title: str,
    key: Callable[[Result], str],
) -> Table:
    """One row for each value of ``key``, one column for each method."""
    cells = list(by_cell(results))
    rows = tuple(
        (value, len(group), *(_of_cell(group, cell, metric) for cell in cells))
        for value, group in sorted(grouped(results, key).items())
    )
    return Table(
        name=name,
        title=title,
        columns=(name, "n", *cells),
        rows=rows,
        note=f"{metric.title}: {metric.meaning}.",
    )


def tasks(results: Sequence[Result]) -> Table:
    """One row for each task: strict Plan SR of each method."""
    metric = BY_NAME["strict"]
    cells = list(by_cell(results))
    groups = grouped(results, lambda result: result.task)
    rows = tuple(
        (
            task,
            group[0].category,
            group[0].steps,
            *(_of_cell(group, cell, metric) for cell in cells),
        )
        for task, group in groups.items()
    )
    return Table(
        name="tasks", title="Task by task", columns=("task", "category", "|A|", *cells), rows=rows
    )


def wrong(results: Sequence[Result]) -> Table:
    """How often each kind of mistake was made, by method; a failed task may show several."""
    cells = by_cell(results)
    rows: list[tuple[Entry, ...]] = []
    for kind in KINDS:
        counts = [sum(kind in r.mistakes for r in of_cell) for of_cell in cells.values()]
        if any(counts):
            rows.append((kind, *counts))
    return Table(name="mistakes", title="Mistakes", columns=("mistake", *cells), rows=tuple(rows))


def pairs(cells: dict[str, list[Result]], metric: Metric) -> Table:
    """Each method against the first, task by task."""
    first, *others = cells
    rows: list[tuple[Entry, ...]] = []
    for other in others:
        found = compare(cells[first], cells[other], metric, (first, other))
        interval = f"{found.low:+.2f} to {found.high:+.2f}"
        rows.append(
            (
                f"{other} minus {first}",
                found.pairs,
                f"{found.difference:+.2f} ({interval})",
                found.only_second,
                found.only_first,
                f"{found.p:.3g}",
                found.verdict,
            )
        )
    return Table(
        name="pairs",
        title="Pair by pair",
        columns=(
            "methods",
            "pairs",
            "difference",
            "only the first named",
            "only the other",
            "p",
            "",
        ),
        rows=tuple(rows),
        note=f"{metric.title}; interval bootstrapped over tasks, p by the exact sign test.",
    )


def markdown(found: Sequence[Table]) -> str:
    """The tables as Markdown."""
    parts: list[str] = []
    for table in found:
        lines = [f"## {table.title}", "", _line(table.columns), _line(["---"] * len(table.columns))]
        lines += [_line([shown(entry) for entry in row]) for row in table.rows]
        parts.append("\n".join([*lines, *(["", table.note] if table.note else [])]))
    return "\n\n".join(parts) + "\n"


def csv_text(found: Sequence[Table]) -> str:
    """All tables as one CSV: table, row, column, value, std, low, high, count."""
    file = io.StringIO()
    writer = csv.writer(file)
    writer.writerow(["table", "row", "column", "value", "std", "low", "high", "count"])
    for table in found:
        for row in table.rows:
            for column, entry in zip(table.columns[1:], row[1:], strict=True):
                writer.writerow([table.name, row[0], column, *_numbers(entry)])
    return file.getvalue()


def table_document(table: Table) -> dict[str, object]:
    """The table as JSON."""
    return {
        "name": table.name,
        "title": table.title,
        "note": table.note,
        "columns": list(table.columns),
        "rows": [[_entry(entry) for entry in row] for row in table.rows],
    }


def shown(entry: Entry) -> str:
    """An entry as a person reads it."""
    return "-" if entry is None else str(entry)


def _of_cell(group: Sequence[Result], cell: str, metric: Metric) -> Figure | None:
    return figure([result for result in group if result.cell == cell], metric)


def _line(entries: Sequence[str]) -> str:
    return f"| {' | '.join(entry.replace('|', '/') for entry in entries)} |"


def _numbers(entry: Entry) -> list[object]:
    if isinstance(entry, Figure):
        std = "" if entry.std is None else round(entry.std, 4)
        return [*(round(x, 4) for x in (entry.mean,)), std, round(entry.low, 4),
                round(entry.high, 4), entry.count]  # fmt: skip
    if isinstance(entry, Printed):
        return [entry.mean, "" if entry.std is None else entry.std, "", "", ""]
    return ["" if entry is None else entry, "", "", "", ""]


def _entry(entry: Entry) -> object:
    if isinstance(entry, Printed):
        return {"printed": entry.mean, "std": entry.std}
    if not isinstance(entry, Figure):
        return entry
    return {
        "mean": entry.mean,
        "std": entry.std,
        "interval": [entry.low, entry.high],
        "count": entry.count,
    }
