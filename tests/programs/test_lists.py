import pytest

from app.domain.action import ActionSignature, Parameter
from app.domain.program import ActionCall
from app.domain.scene import SceneObject
from app.programs.sketches.lists import listed_pairs
from app.programs.sketches.retelling import places_used, retold
from app.programs.sketches.sketch import Phrase, SketchCall
from app.programs.sketches.things import read_things

NAMES = (
    *("newspaper", "cereal box", "glass bottle", "apple core", "soda can"),
    *("paper bin", "glass bin", "compost bin", "metal bin"),
)


def told(sentence, names=NAMES):
    return listed_pairs(sentence, read_things(SceneObject(name=name) for name in names))


def test_every_line_of_a_list_is_read():
    assert told(
        "Newspaper and cereal box in the paper bin, bottle in the glass bin, apple core in the compost"
        " bin, and the can in the metal bin."
    ) == [
        ("newspaper", "paper bin"),
        ("cereal box", "paper bin"),
        ("glass bottle", "glass bin"),
        ("apple core", "compost bin"),
        ("soda can", "metal bin"),
    ]


def test_the_containers_may_stand_first():
    sentence = "paper bin: newspaper; glass bin: glass bottle; compost bin: apple core"
    names = ("newspaper", "glass bottle", "apple core", "paper bin", "glass bin", "compost bin")
    assert told(sentence, [*names[:1], "broken jar", *names[2:]]) is None
    assert told(sentence.replace("glass bottle", "marble"), [*names, "marble"]) == [
        ("newspaper", "paper bin"),
        ("marble", "glass bin"),
        ("apple core", "compost bin"),
    ]


@pytest.mark.parametrize(
    "sentence",
    [
        "newspaper in the paper bin",
        "newspaper in the paper bin, bottle in the glass bin, but leave the apple core by the compost bin",
        "paper in the paper bin, glass in the glass bin, scraps in the compost bin",
        "can you put it all in the paper bin, the glass bin and the metal bin?",
    ],
)
def test_what_is_no_plain_list_of_names_is_left_to_the_model(sentence):
    assert told(sentence) is None


def test_a_list_takes_the_place_of_puts_alone_in_the_order_of_the_verb():
    calls = (
        SketchCall("open", (Phrase(text="glass bin"),)),
        SketchCall("load", (Phrase(text="paper bin"), Phrase(text="newspaper"))),
    )
    verbs = {
        name: ActionSignature(
            name=name, parameters=tuple(Parameter(name=each) for each in parameters), meaning=""
        )
        for name, parameters in (("open", ("obj",)), ("load", ("container", "obj")))
    }
    told = retold(calls, [("newspaper", "paper bin"), ("jar", "glass bin")], verbs)
    assert list(map(str, told)) == [
        "open('glass bin')",
        "load('paper bin', 'newspaper')",
        "load('glass bin', 'jar')",
    ]
    call = ActionCall(action="load", arguments=("glass bin", "jar"))
    assert places_used([call], verbs) == {"glass bin"}
