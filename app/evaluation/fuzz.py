"""Mutated programs and random text through parser, printer and grounding: nothing but refusals may come."""

import random
import resource
import time
from collections.abc import Callable
from dataclasses import dataclass

from app.domain.action import ActionSignature, Parameter
from app.domain.errors import ProgramRefused
from app.domain.program import Program
from app.domain.scene import Scene, SceneObject
from app.programs.examples import load_examples
from app.programs.grounding import ground
from app.programs.parser import parse_program
from app.programs.printer import print_program

WORLDS = ("tabletop", "household")
SAMPLE = '''\
from actions import grab_and_putin(obj1, obj2), turn(obj, angle)

objects = {'tray': {'material': 'wood', 'on it': {'cup': {'colour': 'red', 'sizes': ['s', 'm']}}},
           'lime': 'green fruit', 'bowl': {'container': True, 'height': 0.07}}

def put_away(item, place):
    # one thing
    assert not item in place
        else: grab_and_putin(item, place)
    if item is 'held' or not near(item, place) and category(item) != 'tool':
        grab_and_putin(item, place)
    else:
        turn(item, angle=-0.5)  # so

def tidy_up():
    """All of it."""
    for angle in [0.5, 1e-3, -2]:
        turn('lime', angle + 0.25)
    for each in [one for one in objects if category(one) == 'fruit' and one != 'lime']:
        put_away(each, place='bowl')
        assert('close' to each)
            else: turn(each, 1)
            else: put('x')
    assert count('bowl', 'lime', 'cup') == 1, (turn('cup', 2), turn('lime', 3))
    if any_of('lime' in ['lime', 'cup'], 'cup' on 'tray'):
        pass
    return
'''
PIECES = (
    "def ", "f", "()", ":", "\n", "    ", "\t", "'lime'", '"', "'", "\\", "(", ")", "[", "]", "{", "}", ",",
    "assert", " in ", " is ", "not ", " and ", " or ", "else: ", "else:\n", "if ", "for ", "# why", "objects = ",
    "pass", "return", "#", "=", "==", "!=", "+", "any_of(", "count(", "0.5", "-", "1e9", "1e999", "from actions import ",
    "'''", '"""', "\r", "\x00", "é", "😀", "\ud800", "lambda ", "f''", "\\u12", "\\N{DASH}", "\u2028", "find('lime')",
    "3x", ".", "\x0c", "each", "item", " for ", "for x in objects:\n", "if 'a' in 'b':\n", "def g(x):\n", "    g('a')\n",
    "category(x) == 'fruit'", "True", "'on it': ", "x=", "        ", "import os\n", "__import__('os').system('ls')",
)  # fmt: skip
_SCENE = Scene(
    world="tabletop",
    objects=tuple(SceneObject(name=name, category="fruit") for name in ("lime", "bowl", "cup")),
)
_ACTIONS = (
    ActionSignature(
        name="grab_and_putin",
        parameters=(Parameter(name="obj1"), Parameter(name="obj2", role="support")),
        meaning="Puts one object into or onto another.",
    ),
    ActionSignature(
        name="turn",
        parameters=(Parameter(name="obj"), Parameter(name="angle", role="number")),
        meaning="Turns an object by an angle [rad].",
    ),
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Broken:
    """A text that brought something else than a program or a refusal."""

    text: str
    error: str


@dataclass(frozen=True, slots=True, kw_only=True)
class FuzzReport:
    """What came of all cases."""

    cases: int
    parsed: int
    broken: tuple[Broken, ...]
    """The first ``MAX_TOLD`` of them."""
    slowest: float
    """CPU time of the slowest case [s]."""
    grown: int
    """How much the process's peak memory grew after the first tenth of the cases [kB]."""


MAX_TOLD = 20


def fuzz_programs(
    cases: int, seed: int = 0, on_case: Callable[[], None] = lambda: None
) -> FuzzReport:
    """Send so many texts through the parser; what is parsed is printed, parsed again and grounded."""
    dice = random.Random(seed)
    sources = _sources()
    parsed, slowest, before = 0, 0.0, _peak()
    broken: list[Broken] = []
    for number in range(cases):
        if number == cases // 10:
            before = _peak()
        text = _random_text(dice) if number % 5 == 4 else _mutated(dice.choice(sources), dice)
        started = time.process_time()
        error = ""
        try:
            parsed += _goes_through(text)
        except Exception as raised:
            error = f"{type(raised).__name__}: {raised}"
        slowest = max(slowest, time.process_time() - started)
        if error and len(broken) < MAX_TOLD:
            broken.append(Broken(text=text, error=error))
        on_case()
    return FuzzReport(
        cases=cases, parsed=parsed, broken=tuple(broken), slowest=slowest, grown=_peak() - before
    )


def _goes_through(text: str) -> bool:
    """Whether the text is a program; what is read is the same when it is printed and read again."""
    try:
        program = parse_program(text)
    except ProgramRefused:
        return False
    for style in ("paper", "python"):
        if parse_program(print_program(program, style)) != program:
            raise AssertionError(f"printed in the {style} style it reads otherwise")
    _ground(program)
    return True


def _ground(program: Program) -> None:
    try:
        ground(program, _SCENE, _ACTIONS, {"in": 2, "on": 2, "near": 2, "held": 1})
    except ProgramRefused:  # Written out it is too long.
        return


def _sources() -> tuple[str, ...]:
    examples = [program for world in WORLDS for program in load_examples(world)]
    printed = [print_program(each, style) for each in examples for style in ("paper", "python")]
    return (SAMPLE, SAMPLE, SAMPLE, *printed)


def _mutated(text: str, dice: random.Random) -> str:
    for _ in range(dice.randint(1, 4)):
        at, until = sorted(dice.randrange(len(text) + 1) for _ in range(2))
        until = min(until, at + dice.randint(0, 30))
        match dice.randrange(6):
            case 0:
                text = text[:at] + text[until:]
            case 1:
                text = text[:at] + dice.choice(PIECES) + text[at:]
            case 2:
                text = text[:at] + text[at:until] * dice.choice((2, 2, 3, 40)) + text[until:]
            case 3:
                text = text[:at] + chr(dice.randrange(1, 0x3000)) + text[at + 1 :]
            case 4:
                lines = text.split("\n")
                one, other = dice.randrange(len(lines)), dice.randrange(len(lines))
                lines[one], lines[other] = lines[other], lines[one]
                text = "\n".join(lines)
            case _:
                text = text.replace(
                    "    ", dice.choice(("  ", "\t", "     ", "")), dice.randint(1, 3)
                )
    return text


def _random_text(dice: random.Random) -> str:
    pieces = dice.choices(PIECES, k=dice.randint(0, 80))
    wild = [chr(dice.choice((dice.randrange(128), dice.randrange(0x110000)))) for _ in range(20)]
    match dice.randrange(4):
        case 0:
            return "".join(pieces)
        case 1:
            return "".join(wild * dice.randint(1, 9))
        case 2:
            return "def f():\n    " + "".join(pieces)
        case _:
            return "def f():\n    " + dice.choice(PIECES) * dice.randint(1, 3000)


def _peak() -> int:
    """The most memory this process ever held [kB]."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
