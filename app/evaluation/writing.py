"""Writing: the files an evaluation leaves in its folder."""

import json
from collections.abc import Sequence
from pathlib import Path

from app.evaluation.report import html_report
from app.evaluation.results import Result, result_document
from app.evaluation.tables import Table, csv_text, markdown, table_document

FILES = ("results.json", "tables.csv", "tables.md", "report.html")


def write_files(
    out: Path,
    title: str,
    found: Sequence[Table],
    results: Sequence[Result],
    *,
    charts: Sequence[tuple[str, str]] = (),
    note: str = "",
) -> None:
    """Write ``FILES`` into the folder, each whole or not at all."""
    document = {
        "title": title,
        "note": note,
        "tables": [table_document(table) for table in found],
        "results": [result_document(result) for result in results],
    }
    head = f"# {title}\n\n" + (f"{note}\n\n" if note else "")
    texts = {
        "results.json": json.dumps(document, ensure_ascii=False, indent=1) + "\n",
        "tables.csv": csv_text(found),
        "tables.md": head + markdown(found),
        "report.html": html_report(title, found, results, charts=charts, note=note),
    }
    for name in FILES:
        part = out / f"{name}.part"
        part.write_text(texts[name], encoding="utf-8")
        part.replace(out / name)
