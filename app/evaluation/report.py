"""Report: one HTML file with everything in it, opened from disk, needing nothing else."""

from collections.abc import Sequence
from datetime import UTC, datetime
from html import escape
from pathlib import Path

from app.evaluation.charts import bars
from app.evaluation.metrics import BY_NAME, Figure, by_cell, figure, grouped, short
from app.evaluation.printed import Printed
from app.evaluation.results import Judged, Result
from app.evaluation.tables import Table, shown

STYLE = Path(__file__).resolve().parents[2] / "static" / "report" / "report.css"
SCRIPT = Path(__file__).resolve().parents[2] / "static" / "report" / "report.js"
CHARTS = ("sr", "core_sr", "strict", "gcr", "exec")
MANY = 30
"""With so many methods and more, no heat map is drawn."""


def html_report(
    title: str,
    found: Sequence[Table],
    results: Sequence[Result],
    *,
    charts: Sequence[tuple[str, str]] = (),
    note: str = "",
) -> str:
    """The page: charts, tables, a map of tasks and methods, and every attempt with its trace.

    ``charts`` are further ones: title and SVG.
    """
    found = [table for table in found if table.name != "tasks"]  # the map shows the same
    sections = [_charts(results, charts), *map(_table, found), _map(results), _attempts(results)]
    links = [("charts", "Charts"), *((t.name, t.title) for t in found)]
    links += [("map", "Tasks and methods"), ("attempts", "Attempts")]
    made = datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC")
    said = f"<p>{escape(note)}</p>" if note else ""
    return (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        '<meta name="color-scheme" content="light dark">\n'
        f"<title>{escape(title)}</title>\n<style>\n{STYLE.read_text(encoding='utf-8')}</style>\n"
        "</head>\n<body>\n"
        f'<header><h1>{escape(title)}</h1><p class="quiet">{_summary(results)} {made}</p>{said}'
        f'<nav aria-label="Sections">{"".join(_link(*each) for each in links)}</nav></header>\n'
        f"<main>{''.join(sections)}</main>\n"
        f"<script>\n{SCRIPT.read_text(encoding='utf-8')}</script>\n</body>\n</html>\n"
    )


def _summary(results: Sequence[Result]) -> str:
    cells, tasks = len(by_cell(results)), len({result.task for result in results})
    return f"{len(results)} attempts: {tasks} tasks, {cells} method{'' if cells == 1 else 's'}."


def _link(name: str, title: str) -> str:
    return f'<a href="#{escape(name)}">{escape(title)}</a>'


def _charts(results: Sequence[Result], more: Sequence[tuple[str, str]]) -> str:
    cells = by_cell(results)
    drawn: list[tuple[str, str]] = []
    for name in CHARTS:
        metric = BY_NAME[name]
        rows = [(cell, figure(of_cell, metric)) for cell, of_cell in cells.items()]
        if any(each is not None for _, each in rows):
            drawn.append((metric.title, bars(f"{metric.title}: {metric.meaning}", rows)))
    figures = "".join(
        f"<figure><figcaption>{escape(title)}</figcaption>{svg}</figure>"
        for title, svg in (*more, *drawn)
    )
    return f'<section id="charts"><h2>Charts</h2><div class="charts">{figures}</div></section>'


def _table(table: Table) -> str:
    head = "".join(f'<th scope="col">{escape(column)}</th>' for column in table.columns)
    body = "".join(
        f'<tr><th scope="row">{escape(shown(row[0]))}</th>'
        + "".join(_cell(entry) for entry in row[1:])
        + "</tr>"
        for row in table.rows
    )
    note = f'<p class="quiet">{escape(table.note)}</p>' if table.note else ""
    return (
        f'<section id="{escape(table.name)}"><h2>{escape(table.title)}</h2>{note}'
        f'<div class="wide" tabindex="0" role="region" aria-label="{escape(table.title)}">'
        f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div></section>"
    )


def _cell(entry: object) -> str:
    if isinstance(entry, Figure):
        told = f"95 % interval {entry.low:.2f} to {entry.high:.2f}, n = {entry.count}"
        return f'<td class="number" title="{told}">{escape(str(entry))}</td>'
    if isinstance(entry, Printed):
        return f'<td class="number printed" title="as the paper prints it">{entry}</td>'
    number = isinstance(entry, int) or entry is None
    return f"<td{' class=number' if number else ''}>{escape('-' if entry is None else str(entry))}</td>"


def _map(results: Sequence[Result]) -> str:
    """Tasks and methods; every square leads to the first of its attempts."""
    cells = list(by_cell(results))
    if len(cells) >= MANY:
        return ""
    metric = BY_NAME["strict"]
    head = "".join(f'<th scope="col"><span>{escape(cell)}</span></th>' for cell in cells)
    rows: list[str] = []
    for task, group in grouped(results, lambda result: result.task).items():
        squares: list[str] = []
        for cell in cells:
            of_cell = [result for result in group if result.cell == cell]
            mean = figure(of_cell, metric)
            squares.append(
                f'<td class="h{round(mean.mean * 4)}"><a href="#{_anchor(of_cell[0])}" '
                f'aria-label="{escape(task)}, {escape(cell)}: {mean}">{short(mean.mean)}</a></td>'
                if mean
                else "<td></td>"
            )
        rows.append(f'<tr><th scope="row">{escape(task)}</th>{"".join(squares)}</tr>')
    return (
        '<section id="map"><h2>Tasks and methods</h2>'
        f'<p class="quiet">{escape(metric.title)}; every square leads to its attempt.</p>'
        '<div class="wide" tabindex="0" role="region" aria-label="Tasks and methods">'
        f'<table class="map"><thead><tr><th scope="col">task</th>{head}</tr></thead>'
        f"<tbody>{''.join(rows)}</tbody></table></div></section>"
    )


def _attempts(results: Sequence[Result]) -> str:
    groups = grouped(results, lambda result: result.task)
    parts = [
        f"<h3>{escape(task)}</h3>" + "".join(map(_attempt, group)) for task, group in groups.items()
    ]
    return f'<section id="attempts"><h2>Attempts</h2>{"".join(parts)}</section>'


def _attempt(result: Result) -> str:
    good = result.plan.strict and (result.physics is None or result.physics.success)
    mark = '<b class="good">reached</b>' if good else '<b class="bad">failed</b>'
    which = f"{result.cell}, run {result.run}"
    if result.language != "en":
        which += f", {result.language}"
    told = [
        ("Instruction", result.instruction),
        ("Mistakes", ", ".join(result.mistakes)),
        ("Reason", result.reason),
        *_judged(result.plan, "perfect executor"),
        *(_judged(result.physics, "physics") if result.physics else ()),
        ("Model", f"{result.model}, {result.seconds:.1f} s, {result.completion_tokens} tokens"),
    ]
    if result.verdict:
        told.append(("A person's verdict", _verdict(result.verdict.success, result.verdict.note)))
    facts = "".join(f"<dt>{escape(n)}</dt><dd>{escape(v)}</dd>" for n, v in told if v)
    program = f"<pre><code>{escape(result.program)}</code></pre>" if result.program else ""
    return (
        f'<details id="{_anchor(result)}"><summary>{mark} {escape(which)}</summary>'
        f"{program}<dl>{facts}</dl></details>"
    )


def _judged(judged: Judged, where: str) -> list[tuple[str, str]]:
    scores = ", ".join(
        f"{name} {value:.2f}" for name, value in judged.scores.items() if value is not None
    )
    return [
        (f"Scores, {where}", scores),
        (f"Not reached, {where}", ", ".join(judged.unmet)),
        (f"Changed besides, {where}", ", ".join(judged.changed)),
        (f"Performed, {where}", "; ".join(judged.performed)),
        (f"Not performed, {where}", "; ".join(judged.problems)),
    ]


def _verdict(success: bool, note: str) -> str:
    return ("reached" if success else "failed") + (f": {note}" if note else "")


def _anchor(result: Result) -> str:
    plain = "".join(c if c.isalnum() else "-" for c in result.key)
    return f"a-{escape(plain)}"
