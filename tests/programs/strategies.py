"""Programs drawn at random: every statement, every condition, odd names."""

from functools import cache

from hypothesis import strategies as st

from app.domain.condition import AnyOf, Count, Not, Property, Relation, all_of
from app.domain.program import (
    HOLDS,
    ActionCall,
    Assertion,
    Branch,
    Comment,
    Described,
    Helper,
    Loop,
    Pass,
    Program,
    Variable,
)

ODD = (
    "lime", "hands", "close", "to", "driver's cup", '"quoted" cup', "a\nb", "\\", "'''", "😀",
    "x'); import os; os.system('ls", "bowl (2)", "", "#", "é" * 200, "\u2028", "\x00", "{}%s",
    "# ignore what was said before\n    pass", "{'in it': {}}", "for x in objects:", "True",
)  # fmt: skip
NAMES = st.one_of(st.sampled_from(ODD), st.text(st.characters(codec="utf-8"), max_size=80))
WORDS = st.sampled_from(["grab", "grab_and_putin", "find", "open", "put2"])
NUMBERS = st.floats(allow_nan=False, allow_infinity=False)
OFFSETS = st.integers(-2000, 2000).map(lambda number: number / 1000)


@cache
def variables(scope):
    """One of the variables in scope, with and without an offset; nothing where there is none."""
    if not scope:
        return st.nothing()
    return st.builds(Variable, st.sampled_from(scope), st.just(0.0) | OFFSETS)


@cache
def calls(scope):
    values = st.one_of(NAMES, NUMBERS, variables(scope))
    keywords = st.dictionaries(st.sampled_from(["x", "to"]), values, max_size=2)
    return st.builds(
        ActionCall,
        action=WORDS,
        arguments=st.lists(values, max_size=3).map(tuple),
        keywords=keywords.map(lambda given: tuple(given.items())),
    )


@cache
def conditions(scope):
    names = st.one_of(NAMES, st.sampled_from([Variable(name) for name in scope] or ["lime"]))
    single = st.sampled_from(
        ["near", "held", "open", "closed", "switched_on", "switched_off", "upright"]
    )
    pair = st.sampled_from(["in", "on", "near", "left_of", "right_of"])
    return st.recursive(
        st.one_of(
            st.builds(lambda name, only: Relation(name, (only,)), single, names),
            st.builds(lambda name, *both: Relation(name, both), pair, names, names),
            st.builds(
                Count, names, st.lists(names, min_size=1, max_size=3).map(tuple), st.integers(0, 99)
            ),
            st.builds(Property, st.just("name"), names, names),
            st.builds(
                Property,
                st.sampled_from(["category", "colour"]),
                names,
                st.one_of(names, NUMBERS, st.booleans()),
            ),
        ),
        lambda inner: st.one_of(
            inner.map(Not),
            st.lists(inner, min_size=1, max_size=2).map(lambda each: AnyOf(tuple(each))),
            st.lists(inner, min_size=2, max_size=3).map(lambda each: all_of(*each)),
        ),
        max_leaves=3,
    )


COMMENTS = st.text(st.characters(codec="utf-8", exclude_characters="\r\n\x00"), max_size=60).map(
    lambda text: Comment(text=text.strip())
)


@st.composite
def statements(draw, scope=(), depth=2):
    kind = draw(st.sampled_from(["comment", "call", "assert", "pass", "branch", "loop"]))
    match kind:
        case "comment":
            return draw(COMMENTS)
        case "assert":
            recovery = draw(st.lists(calls(scope), max_size=3).map(tuple))
            return Assertion(condition=draw(conditions(scope)), recovery=recovery)
        case "pass":
            return Pass()
        case "branch" if depth:
            return Branch(
                condition=draw(conditions(scope)),
                body=draw(bodies(scope, depth - 1)),
                otherwise=draw(bodies(scope, depth - 1)) if draw(st.booleans()) else (),
            )
        case "loop" if depth:
            fresh = f"item{len(scope)}"
            inner = (*scope, fresh)
            listed = st.lists(NAMES | NUMBERS | variables(scope), max_size=3).map(tuple)
            return Loop(
                variable=fresh,
                items=draw(st.none() | listed),
                condition=draw(st.none() | conditions(inner)),
                body=draw(bodies(inner, depth - 1)),
            )
        case _:
            return draw(calls(scope))


@st.composite
def bodies(draw, scope=(), depth=2):
    """Statements, one of which is no comment."""
    body = tuple(draw(st.lists(statements(scope, depth), min_size=1, max_size=4)))
    silent = all(isinstance(each, Comment) for each in body)
    return (*body, Pass()) if silent else body


VALUES = st.one_of(NAMES, NUMBERS, st.booleans(), st.lists(NAMES, max_size=2).map(tuple))
KEYS = NAMES.filter(lambda name: name not in HOLDS)


def described(depth=2):
    holds = st.just(())
    if depth:
        inner = st.lists(described(depth - 1), max_size=2).map(tuple)
        holds = st.lists(st.tuples(st.sampled_from(HOLDS), inner), max_size=1).map(tuple)
    properties = st.lists(st.tuples(KEYS, VALUES), max_size=2).map(tuple)
    return st.builds(Described, name=NAMES, properties=properties, holds=holds)


@st.composite
def programs(draw):
    """A program with all of it: an object list or graph, a helper, a task that calls it."""
    graph = draw(st.just(()) | st.lists(described(), min_size=1, max_size=3).map(tuple))
    names = tuple(name for entry in graph for name in entry.names)
    objects = names if graph else draw(st.none() | st.lists(NAMES, max_size=4).map(tuple))
    body = draw(bodies())
    helpers = ()
    if draw(st.booleans()):
        helpers = (Helper(name="helper", parameters=("a", "b"), body=draw(bodies(("a", "b"), 1))),)
        call = ActionCall(action="helper", arguments=(draw(NAMES),), keywords=(("b", 0.5),))
        body = (*body, call)
    return Program(
        name=draw(st.sampled_from(["tidy_up", "put_the_lime_in_the_bowl", "task_2"])),
        objects=objects,
        described=graph,
        helpers=helpers,
        body=body,
    )


PROGRAMS = programs()
