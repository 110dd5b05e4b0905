"""Events told in lines for people, as they come."""

from typing import Any

from rich.console import Console
from rich.markup import escape
from rich.syntax import Syntax

from app.domain.program import literal

SCORES = {"sr": "SR", "gcr": "GCR", "exec": "Exec", "precision": "precision"}


class Narrator:
    """Prints a plan and its rollout as they happen."""

    def __init__(self, console: Console) -> None:
        self._console = console
        self._writing = False
        self._written = False

    def plan_accepted(self, plan: dict[str, Any]) -> None:
        """The service took the instruction."""
        names = ", ".join(item["name"] for item in plan["scene"].get("objects", ()))
        self._console.print(f"[bold]{escape(plan['instruction'])}[/bold]")
        self._console.print(f"[dim]scene: {escape(names)}[/dim]")

    def tell(self, event: dict[str, Any]) -> None:
        """One line (or some more of the program) per event."""
        kind = event["kind"]
        if kind == "completion_grew":
            self._writing = self._written = True
            self._console.print(escape(event["text"]), end="", style="cyan", soft_wrap=True)
            return
        if self._writing:
            self._writing = False
            self._console.print()
        if line := _line(kind, event):
            self._console.print(line, highlight=False, soft_wrap=True)

    def plan_ready(self, plan: dict[str, Any]) -> None:
        """The program as it was understood, or why there is none."""
        usage = plan.get("usage") or {}
        told = self._written and (plan.get("completion") or "").strip() in (plan["program"] or "")
        if plan.get("program") and not told:
            code = Syntax(
                plan["program"].strip(), "python", background_color="default", word_wrap=True
            )
            self._console.print(code)
        if usage.get("seconds") is not None:
            sure = plan.get("confidence")
            self._console.print(
                f"[dim]planned by {escape(str(usage.get('model')))} in {usage['seconds']:.1f} s "
                f"({usage.get('prompt_tokens')} + {usage.get('completion_tokens')} tokens)"
                f"{'' if sure is None else f', {sure:.0%} sure'}[/dim]"
            )
        for rejected in plan.get("rejected") or ():
            reason = escape(f"{rejected['text']}: {rejected['reason']}")
            self._console.print(f"[yellow]rejected[/yellow] line {rejected['line']}: {reason}")
        if plan.get("error"):
            self._console.print(f"[red]{escape(_reason(plan['error']))}[/red]")
        declined = plan.get("declined") or {}
        if declined.get("question"):
            self._console.print(f"[bold]{escape(declined['question'])}[/bold]")
        for choice in declined.get("choices", ()):
            self._console.print(f"  {escape(choice)}", highlight=False)

    def execution_over(self, plan: dict[str, Any], execution: dict[str, Any]) -> None:
        """Scores and outcome."""
        scores = execution.get("scores") or {}
        plan_scores = plan.get("plan_scores") or {}
        told = [f"{label} {_number(scores.get(name))}" for name, label in SCORES.items()]
        told.append(f"Plan SR {_number(plan_scores.get('sr'))}")
        colour = "green" if plan["status"] == "succeeded" else "red"
        self._console.print(f"[bold {colour}]{plan['status']}[/]  " + "  ".join(told))

    def where_to_watch(self, url: str, plan: dict[str, Any]) -> None:
        """The page that shows all of it."""
        self._console.print(f"watch it at {url}/#/plans/{plan['id']}", highlight=False)


def _line(kind: str, event: dict[str, Any]) -> str | None:  # noqa: C901 - one case per event
    at = f"[dim]{event['time']:6.1f} s[/dim]  " if "time" in event else ""
    match kind:
        case "planning_started":
            return f"[dim]planning with {escape(str(event['model'] or event['planner']))} …[/dim]"
        case "comment_reached":
            return f"{at}[dim]# {escape(event['text'])}[/dim]"
        case "action_started":
            call = f"{event['action']}({', '.join(map(literal, event['arguments']))})"
            return f"{at}{escape(call)}"
        case "stage_reached":
            again = f" (attempt {event['attempt']})" if event["attempt"] > 1 else ""
            return f"{at}  [dim]{escape(event['stage'])}{again}[/dim]"
        case "action_performed":
            return f"{at}  [green]done[/green]"
        case "action_failed":
            return f"{at}  [red]failed[/red] {escape(event['stage'])}: {escape(event['reason'])}"
        case "call_skipped":
            return (
                f"{at}[yellow]skipped[/yellow] {escape(event['text'])}: {escape(event['reason'])}"
            )
        case "branch_decided":
            return f"{at}if {escape(event['condition'])}: {'yes' if event['holds'] else 'no'}"
        case "recovery_taken":
            return f"{at}  recovering"
        case _:
            return None


def _reason(error: object) -> str:
    if isinstance(error, dict):
        return str(error.get("reason") or error.get("detail") or error)
    return str(error)


def _number(value: float | None) -> str:
    return "-" if value is None else f"{value:.2f}".rstrip("0").rstrip(".")
