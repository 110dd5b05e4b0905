"""Documents: scenes, plans and programs of the domain as JSON, and back."""

from typing import Any

from pydantic import TypeAdapter

from app.domain.plan import Plan
from app.domain.program import ActionCall, Assertion, Comment, Program, Statement
from app.domain.scene import Scene
from app.programs.conditions import print_condition

_scenes: TypeAdapter[Scene] = TypeAdapter(Scene)


def scene_document(scene: Scene) -> dict[str, Any]:
    """A scene as JSON."""
    return _scenes.dump_python(scene, mode="json", exclude={"names"})


def read_scene(document: dict[str, Any]) -> Scene:
    """The scene of such a document."""
    return _scenes.validate_python(document)


def plan_columns(program: Program, plan: Plan) -> dict[str, Any]:
    """What is kept of a program and its plan, by the names of the columns of a plan."""
    return {
        "program_tree": [_statement(statement) for statement in program.body],
        "steps": [
            {
                "line": call.line,
                "action": call.action,
                "arguments": list(call.arguments),
                "comment": call.comment,
            }
            for call in plan.calls
        ],
        "rejected": [
            {"line": call.line, "text": call.text, "reason": call.reason} for call in plan.rejected
        ],
    }


def _statement(statement: Statement) -> dict[str, Any]:
    match statement:
        case Comment(text=text, line=line):
            return {"kind": "comment", "line": line, "text": text}
        case ActionCall():
            return _call(statement)
        case Assertion(condition=condition, recovery=recovery, line=line):
            return {
                "kind": "assertion",
                "line": line,
                "condition": print_condition(condition),
                "recovery": [_call(call) for call in recovery],
            }
        case _:
            return {"kind": "pass", "line": statement.line}


def _call(call: ActionCall) -> dict[str, Any]:
    return {
        "kind": "call",
        "line": call.line,
        "action": call.action,
        "arguments": list(call.arguments),
    }
