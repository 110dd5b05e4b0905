import contextlib
import random

import pytest

from app.domain.action import ActionSignature, Parameter
from app.domain.errors import ProgramRefused
from app.domain.planner import Turn
from app.programs.sketches.grammar import vocabulary
from app.programs.sketches.parser import parse_sketch, print_sketch
from app.programs.sketches.prompt import write_sketch_prompt
from app.programs.sketches.sketch import (
    RELATIONS,
    Decline,
    Each,
    Phrase,
    Previous,
    Rest,
    Same,
    Sketch,
    SketchArgument,
    SketchCall,
)

PUT = ActionSignature(
    name="grab_and_putin", parameters=(Parameter(name="obj1"), Parameter(name="obj2")), meaning=""
)


def test_every_form_is_read() -> None:
    text = """    # a comment
    grab_and_putin(all('fruits', but='banana', count=2), one('plate', where='largest'))
    grab_and_putin(rest, same('colour', 'bowls'))
    grab_and_putin(all('blocks', but=['a', 'b'], order='largest first'), previous)
    grab_and_putin('cup', each('trays', count=2))
    turn('knob', -90.5)
"""
    assert parse_sketch(text).body == (
        SketchCall(
            "grab_and_putin",
            (
                Phrase(text="fruits", quantity="all", but=("banana",), count=2),
                Phrase(text="plate", where="largest"),
            ),
        ),
        SketchCall("grab_and_putin", (Rest(), Same("colour", "bowls"))),
        SketchCall(
            "grab_and_putin",
            (
                Phrase(text="blocks", quantity="all", but=("a", "b"), order="largest first"),
                Previous(),
            ),
        ),
        SketchCall("grab_and_putin", (Phrase(text="cup"), Each("trays", 2))),
        SketchCall("turn", (Phrase(text="knob"), -90.5)),
    )


def test_a_refusal_is_read() -> None:
    assert parse_sketch("    decline('impossible')\n").body == (Decline("impossible"),)


def test_printing_and_parsing_give_the_sketch_back() -> None:
    rng = random.Random(0)
    for _ in range(300):
        sketch = Sketch(tuple(_statement(rng) for _ in range(rng.randint(1, 5))))
        assert parse_sketch(print_sketch(sketch)) == sketch


@pytest.mark.parametrize(
    "text",
    [
        "",
        "# only a comment",
        "grab_and_putin(",
        "grab_and_putin('a' 'b')",
        "grab_and_putin(all('a', but=), 'b')",
        "grab_and_putin(all('a', if_='x'), 'b')",
        "grab_and_putin(all('a', count=0), 'b')",
        "grab_and_putin(all('a', count=2, count=3), 'b')",
        "grab_and_putin(__import__('os'), 'b')",
        "grab_and_putin('', 'b')",
        "import os",
        "a('b'); c('d')",
        "x = 1",
        "a('b')\n" * 41,
        f"a('{'x' * 301}')",
        "a(" + "[" * 100,
    ],
)
def test_what_is_outside_the_form_is_refused(text: str) -> None:
    with pytest.raises(ProgramRefused):
        parse_sketch(text)


def test_mutated_sketches_raise_nothing_but_a_refusal() -> None:
    rng = random.Random(1)
    start = "    grab_and_putin(all('fruits', but=['pear'], count=2), same('colour', \"bowls\"))\n"
    for _ in range(3000):
        characters = list(start)
        for _ in range(rng.randint(1, 6)):
            place = rng.randrange(len(characters))
            characters[place] = rng.choice("()[],='\"\\ \n#al1-é\x00😀")
        with contextlib.suppress(ProgramRefused):
            parse_sketch("".join(characters))


def test_the_prompt_is_the_import_line_and_the_sentence() -> None:
    assert write_sketch_prompt("put the pear\n in the bowl", (PUT,)) == (
        "from actions import grab_and_putin(obj1, obj2)\n# put the pear in the bowl\ndef task():\n"
    )


def test_the_prompt_tells_what_was_done_before() -> None:
    turn = Turn(
        instruction="put the pear in the bowl",
        program="def t():\n    # pear\n    grab_and_putin('pear', 'bowl')\n",
    )
    assert write_sketch_prompt("now the apple", (PUT,), (turn,)) == (
        "from actions import grab_and_putin(obj1, obj2)\n"
        "# put the pear in the bowl\n"
        "#    grab_and_putin('pear', 'bowl')\n"
        "# now the apple\n"
        "def task():\n"
    )


def _statement(rng: random.Random) -> SketchCall | Decline:
    if rng.random() < 0.1:
        return Decline(_words(rng))
    return SketchCall("verb", tuple(_argument(rng) for _ in range(rng.randint(0, 3))))


def _argument(rng: random.Random) -> SketchArgument:
    phrase = Phrase(
        text=_words(rng),
        quantity=rng.choice(("one", "all")),
        but=tuple(_words(rng) for _ in range(rng.randint(0, 2))),
        count=rng.choice((None, 1, 7)),
        where=rng.choice((None, "leftmost")),
        order=rng.choice((None, "largest first")),
        relations=tuple((key, _words(rng)) for key in RELATIONS if rng.random() < 0.2),
    )
    others = (Rest(), Previous(), Same("colour", _words(rng)), Each(_words(rng), 2), -1.5)
    return rng.choice((phrase, phrase, *others))


def _words(rng: random.Random) -> str:
    return "x" + "".join(rng.choice("abc '\"\\\n#é😀,)(") for _ in range(rng.randint(0, 8)))


def test_what_ends_like_several_has_no_further_plural() -> None:
    assert "glasseses" not in vocabulary("put all glasses in the box", ())
