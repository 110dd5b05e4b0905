import pytest

from app.domain.action import ActionSignature, Parameter
from app.programs.sketches.order import in_order, unsaid
from app.programs.sketches.sketch import Phrase, SketchCall


def verb(name, *parameters):
    taken = tuple(Parameter(name=each) for each in parameters)
    return ActionSignature(name=name, parameters=taken, meaning="")


def ordered(signature, sentence, *texts):
    call = SketchCall(signature.name, tuple(Phrase(text=each) for each in texts))
    found = in_order(call, signature, sentence)
    return tuple(each.text for each in found.arguments if isinstance(each, Phrase))


@pytest.mark.parametrize(
    ("signature", "sentence", "wanted"),
    [
        (verb("label", "box", "sticker"), "label the crate with the tag", ("crate", "tag")),
        (verb("drizzle", "sauce", "dish"), "drizzle the oil over the salad", ("oil", "salad")),
        (verb("load", "container", "obj"), "load the oil into the jug", ("jug", "oil")),
        (verb("wipe", "tool", "surface"), "wipe the pane with the rag", ("rag", "pane")),
        (verb("wipe", "obj", "tool"), "clean the plate using the sponge", ("plate", "sponge")),
    ],
)
def test_small_words_and_names_of_parameters_tell_which_is_which(signature, sentence, wanted):
    assert ordered(signature, sentence, *wanted) == wanted
    assert ordered(signature, sentence, *wanted[::-1]) == wanted


def test_where_no_small_word_tells_the_sketch_stands():
    hand = verb("hand", "person", "item")
    assert ordered(hand, "hand the nurse the swab", "nurse", "swab") == ("nurse", "swab")
    assert ordered(hand, "hand the nurse the swab", "swab", "nurse") == ("swab", "nurse")


def test_a_verb_that_is_said_and_not_called_is_missed():
    verbs = [verb("scan", "document"), verb("shred", "document"), verb("file", "document")]
    calls = [SketchCall("shred", (Phrase(text="bill"),))]
    assert unsaid(calls, verbs, "scan the map before shredding the bill") == {"scan"}
    assert unsaid(calls, verbs, "do not scan the map, shred the bill") == set()
