"""Events as clients see them."""

from typing import Any

from app.programs.conditions import print_condition
from app.storage.events import EventRow


def event_view(row: EventRow) -> dict[str, Any]:
    """An event with its number and the time it was written; conditions as text."""
    told = {"sequence": row.sequence, "kind": row.kind, "at": row.at.isoformat()}
    view = told | row.body
    if "condition" in view:
        view["condition"] = print_condition(getattr(row.event, "condition"))  # noqa: B009
    if "facts" in view:
        view["facts"] = sorted(map(print_condition, getattr(row.event, "facts")))  # noqa: B009
    return view
