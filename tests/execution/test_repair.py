"""A kitchen of facts: what is in a closed thing cannot be taken, and putting wants a held thing."""

import json

import pytest

from app.domain.action import ActionSignature, Parameter
from app.domain.condition import Relation
from app.domain.errors import ActionFailure
from app.domain.plan import GroundedCall
from app.domain.program import ActionCall, Assertion, Branch, Comment
from app.domain.scene import Scene, SceneObject
from app.domain.world import Stage
from app.execution.interpreter import execute
from app.execution.repair import MAX_ADDED, repair
from app.programs.grounding import ground
from app.programs.parser import parse_program
from app.programs.printer import print_program

SCENE = Scene(
    world="kitchen",
    objects=tuple(SceneObject(name=name) for name in ("fridge", "milk", "table", "safe", "key")),
)
ACTIONS = tuple(
    ActionSignature(name=name, parameters=parameters, meaning="")
    for name, parameters in {
        "open": (Parameter(name="obj"),),
        "close": (Parameter(name="obj"),),
        "grab": (Parameter(name="obj"),),
        "unlock": (Parameter(name="obj"),),
        "empty": (Parameter(name="obj"),),
        "clean": (Parameter(name="obj"),),
        "puton": (Parameter(name="obj1"), Parameter(name="obj2")),
    }.items()
)


def call(action, *arguments):
    return ActionCall(action=action, arguments=arguments)


class Kitchen:
    scene = SCENE
    time = 0.0

    def __init__(self, *closed):
        self.closed = set(closed)
        self.held = set()
        self.on = set()

    def perform(self, action, arguments):
        yield Stage(name="suppose")
        getattr(self, f"_{action}")(*arguments)

    def _open(self, name):
        if name == "safe":
            raise ActionFailure("check", "the safe is locked", remedy=(call("unlock", "safe"),))
        self.closed.discard(name)

    def _close(self, name):
        self.closed.add(name)

    def _unlock(self, name):
        raise ActionFailure("check", "the key does not fit", remedy=(call("unlock", name),))

    def _clean(self, name):
        raise ActionFailure("check", f"the {name} is clean", needless=True)

    def _empty(self, name):
        remedy = (call("open", "fridge"), call("unlock", "safe"))
        raise ActionFailure("check", "it takes all doors", remedy=remedy)

    def _grab(self, name):
        for inside, place in (("milk", "fridge"), ("key", "safe")):
            if name == inside and place in self.closed:
                raise ActionFailure("reach", f"{place} is closed", remedy=(call("open", place),))
        self.held.add(name)

    def _puton(self, name, place):
        if name not in self.held:
            raise ActionFailure("check", f"{name} is not held", remedy=(call("grab", name),))
        self.held.discard(name)
        self.on.add((name, place))

    def holds(self, relation):
        if relation.name == "closed":
            return relation.arguments[0] in self.closed
        return relation in self.facts()

    def facts(self):
        return frozenset(Relation("on", pair) for pair in self.on)

    def begin(self):
        pass

    def settle(self):
        pass

    def frames(self):
        return ()

    def save(self):
        return json.dumps([sorted(self.closed), sorted(self.held), sorted(self.on)]).encode()

    def restore(self, state):
        closed, held, on = json.loads(state)
        self.closed, self.held, self.on = set(closed), set(held), {tuple(pair) for pair in on}


def grounded(program):
    return ground(program, SCENE, ACTIONS, {"closed": 1, "on": 2})


def repaired(*lines, closed=("fridge", "safe"), above="", shuts=False):
    program = parse_program("\n".join([above, "def f():", *(f"    {line}" for line in lines)]))
    return repair(program, SCENE, Kitchen(*closed), grounded, shuts=shuts), program


def calls(program):
    return [str(each) for each in program.body if isinstance(each, ActionCall)]


def test_what_a_step_lacks_is_put_before_it_with_the_reason():
    found, _ = repaired("# bring the milk", "puton('milk', 'table')")
    assert print_program(found.program) == (
        "def f():\n"
        "    # bring the milk\n"
        "    # added, for milk is not held\n"
        "    # added, for fridge is closed\n"
        "    open('fridge')\n"
        "    grab('milk')\n"
        "    puton('milk', 'table')\n"
    )
    assert [str(each) for each in found.added] == ["open('fridge')", "grab('milk')"]
    world = Kitchen("fridge")
    list(execute(grounded(parse_program(print_program(found.program))), world))
    assert world.on == {("milk", "table")}


def test_a_program_that_lacks_nothing_is_the_same_program():
    found, program = repaired(
        "for x in ['milk']:", "    grab(x)", "    puton(x, 'table')", closed=()
    )
    assert found.program is program
    assert found.added == ()


def test_a_loop_is_written_out_where_a_round_of_it_lacks_something():
    found, _ = repaired("for x in ['table', 'milk']:", "    grab(x)")
    assert calls(found.program) == ["grab('table')", "open('fridge')", "grab('milk')"]


def test_helpers_are_written_out():
    above = "def bring(x):\n    grab(x)\n    puton(x, 'table')"
    found, _ = repaired("bring('milk')", above=above)
    assert not found.program.helpers
    assert calls(found.program) == ["open('fridge')", "grab('milk')", "puton('milk', 'table')"]


@pytest.mark.parametrize(
    "line", ["open('safe')", "grab('key')", "grab('nothing')", "fly('milk')", "grab('milk', 'key')"]
)
def test_what_no_remedy_helps_stays_as_it_is(line):
    found, program = repaired(line, "grab('table')")
    assert found.program is program


def test_a_remedy_that_comes_to_nothing_leaves_no_trace():
    found, _ = repaired("empty('safe')", "grab('milk')")
    assert calls(found.program) == ["empty('safe')", "open('fridge')", "grab('milk')"]
    assert [str(each) for each in found.added] == ["open('fridge')"]


def test_an_assertion_s_recovery_is_taken_into_account():
    found, program = repaired("assert not closed('fridge'), open('fridge')", "grab('milk')")
    assert found.program is program


def test_a_needless_step_is_left_out_with_the_reason():
    found, _ = repaired("clean('table')", "grab('table')")
    assert print_program(found.program) == (
        "def f():\n    # left out, for the table is clean\n    grab('table')\n"
    )
    assert [str(each) for each in found.dropped] == ["clean('table')"]


def test_a_program_of_needless_steps_only_can_still_be_read():
    found, _ = repaired("clean('table')")
    assert not calls(parse_program(print_program(found.program)))


def test_an_assertion_whose_recovery_lacks_something_is_written_out_with_it():
    found, _ = repaired("assert on('milk', 'table'), grab('milk')")
    assert calls(found.program) == ["open('fridge')", "grab('milk')"]


def test_of_an_assertion_what_cannot_be_done_is_left_out():
    found, _ = repaired("assert not closed('safe'), open('safe')", "grab('table')")
    assert calls(found.program) == ["grab('table')"]
    assert not [each for each in found.program.body if isinstance(each, Assertion)]
    assert [str(each) for each in found.dropped] == ["open('safe')"]


def test_of_a_branch_the_side_that_is_taken_is_repaired():
    found, _ = repaired(
        "if closed('fridge'):", "    grab('milk')", "else:", "    puton('milk', 'table')"
    )
    (branch,) = found.program.body
    assert isinstance(branch, Branch)
    assert [str(each) for each in branch.body if not isinstance(each, Comment)] == [
        "open('fridge')",
        "grab('milk')",
    ]
    assert [str(each) for each in branch.otherwise] == ["puton('milk', 'table')"]


def test_no_more_than_so_many_calls_are_added():
    found, _ = repaired(*(["close('fridge')", "grab('milk')"] * (MAX_ADDED + 5)))
    assert len(found.added) == MAX_ADDED
    steps = grounded(found.program).steps
    assert sum(isinstance(each, GroundedCall) for each in steps) == 2 * (MAX_ADDED + 5) + MAX_ADDED


def test_what_a_remedy_opened_is_closed_again():
    found, _ = repaired("grab('milk')", "grab('key')", closed=("fridge",), shuts=True)
    wanted = ["open('fridge')", "grab('milk')", "close('fridge')", "grab('key')"]
    assert calls(found.program) == wanted


def test_it_stays_open_for_a_step_that_takes_it_so():
    found, _ = repaired("grab('milk')", "grab('milk')", closed=("fridge",), shuts=True)
    wanted = ["open('fridge')", "grab('milk')", "grab('milk')", "close('fridge')"]
    assert calls(found.program) == wanted


def test_what_the_program_itself_opened_stays_open():
    found, program = repaired("open('fridge')", "grab('milk')", shuts=True)
    assert found.program is program
