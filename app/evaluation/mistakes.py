"""Mistakes: what is wrong with a failed plan, in the paper's words and some more."""

from collections import Counter

from app.evaluation.judging import Judged
from app.evaluation.tasks import SuiteTask

KINDS = (
    "unusable program",
    "hallucinated object",
    "hallucinated action",
    "affordance",
    "missing step",
    "wrong order",
    "additional step",
    "wrongly declined",
    "wrongly accepted",
    "perception",
    "motion",
)
"""In the order in which they are told; a failed task has one or more of them."""
_SEEING = ("look", "perceive")
"""Stages of an action at which nothing has moved yet."""


def mistakes(
    task: SuiteTask, status: str, plan: Judged, physics: Judged | None = None
) -> tuple[str, ...]:
    """The kinds of mistakes that explain why the task failed; none where it did not."""
    if plan.strict:
        return _in_physics(physics)
    found = _of_planning(task, status, plan) if status == "planned" else _of_refusing(status)
    if not found:
        found = {"missing step"}
    return tuple(kind for kind in KINDS if kind in found)


def _of_refusing(status: str) -> set[str]:
    return {"wrongly declined" if status == "declined" else "unusable program"}


def _of_planning(task: SuiteTask, status: str, plan: Judged) -> set[str]:
    del status  # It is a plan.
    if not task.goal:
        return {"wrongly accepted"}
    found = {kind for problem in plan.problems if (kind := _of_problem(problem))}
    if not plan.performed and not plan.problems:
        return {"wrongly declined"}
    wanted, done = Counter(task.truth), Counter(plan.performed)
    if not plan.success:
        found |= {"wrong order"} if done >= wanted else {"missing step"}
    if plan.changed:
        found.add("additional step")
    return found


def _of_problem(problem: str) -> str | None:
    place, _, reason = problem.partition(": ")
    if not place.endswith("grounding"):
        return "affordance"
    if "the robot has no action" in reason:
        return "hallucinated action"
    return "hallucinated object" if "there is no object" in reason else "affordance"


def _in_physics(physics: Judged | None) -> tuple[str, ...]:
    if physics is None or physics.success:
        return ()
    stages = {problem.partition(": ")[0].rpartition(" ")[2] for problem in physics.problems}
    return ("perception",) if stages and stages <= set(_SEEING) else ("motion",)
