"""Documents: scenes, plans and programs of the domain as JSON, and back."""

from typing import Any, assert_never

from pydantic import TypeAdapter

from app.domain.plan import Plan
from app.domain.program import (
    ActionCall,
    Argument,
    Assertion,
    Branch,
    Comment,
    Helper,
    Loop,
    Pass,
    Program,
    Statement,
    Variable,
    literal,
)
from app.domain.scene import Scene
from app.programs.conditions import print_condition
from app.programs.printer import loop_head

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
        "program_tree": [
            *map(_helper, program.helpers),
            *map(_statement, program.body),
        ],
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
        case Branch(condition=condition, body=body, otherwise=otherwise, line=line):
            return {
                "kind": "branch",
                "line": line,
                "condition": print_condition(condition),
                "body": [_statement(each) for each in body],
                "otherwise": [_statement(each) for each in otherwise],
            }
        case Loop(body=body, line=line):
            return {
                "kind": "loop",
                "line": line,
                "text": loop_head(statement),
                "body": [_statement(each) for each in body],
            }
        case Pass(line=line):
            return {"kind": "pass", "line": line}
        case _:
            assert_never(statement)


def _helper(helper: Helper) -> dict[str, Any]:
    return {
        "kind": "helper",
        "line": helper.line,
        "name": helper.name,
        "parameters": list(helper.parameters),
        "body": [_statement(each) for each in helper.body],
    }


def _call(call: ActionCall) -> dict[str, Any]:
    shown: dict[str, Any] = {"kind": "call", "line": call.line, "action": call.action}
    shown["arguments"] = list(map(_argument, call.arguments))
    if call.keywords:
        shown["keywords"] = {name: _argument(value) for name, value in call.keywords}
    return shown


def _argument(value: Argument) -> Argument:
    """A variable, as it is written; a name or a number as it is."""
    return literal(value) if isinstance(value, Variable) else value
