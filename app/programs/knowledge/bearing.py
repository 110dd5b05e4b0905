"""What a thing's name says it holds, is a dose, a plant or a sheet of: "the milk" of a ``milk jug``.

Who asks for the milk means the jug, where that is all the milk there is. The head of the name
decides: a vessel or a plant stands for what it bears, a tool or a piece of furniture does not
(``apple corer``, ``dog lead``, ``piano stool``).
"""

from collections.abc import Sequence

from app.programs.knowledge.classes import HOLDERS, classes, normal
from app.programs.knowledge.compounds import parted
from app.programs.knowledge.membership import belonging
from app.programs.knowledge.names import PORTIONS, is_mark, singular, without_marks, words
from app.programs.knowledge.properties import MATERIALS
from app.programs.knowledge.synonyms import mean_the_same
from app.programs.knowledge.word_lists import word_list
from app.programs.knowledge.wordnet import nouns

VESSELS = word_list("vessels")
"""They stand for what can be poured, eaten or used up: no ``flower pot`` for a flower."""
_DISHES = frozenset(("bowl", "cup", "mug", "glass", "plate", "dish", "bucket", "basket"))
"""They stand for what is said to be in them: a bowl of porridge."""
_AMOUNTS = frozenset(("stack", "pile", "heap", "bunch", "bundle", "batch", "portion", "punnet"))
_DOSES = word_list("doses")
_PLANTS = word_list("plants")
_SHEETS = word_list("sheets")
_CONSUMED = ("substance", "food", "beverage", "liquid", "fluid", "powder", "cosmetic", "toiletry")
_KEPT = ("toiletry", "cleaning supply", "condiment", "medicine")
_LIVING = ("animal", "person")
_APART = ("fruit", "vegetable")
"""What grows on a plant is a thing of its own."""
_ALIKE = (
    frozenset(("box", "tin", "jar", "caddy", "canister", "tub", "barrel")),
    frozenset(("pot", "jug", "pitcher", "carafe", "decanter")),
    frozenset(("bag", "sack", "packet", "pouch", "sachet")),
)
"""Containers that one is said for the other."""
LIKELY = 0.4
"""From which share of its meanings on a word is taken to mean a substance."""


def borne(name: str) -> tuple[str, ...]:
    """What the thing bears, as its name tells: ``tea`` of a ``teapot``; often nothing."""
    found = without_marks(words(name))
    if "of" in found[1:-1]:
        place = found.index("of", 1)
        head = singular(found[place - 1])
        held = found[place + 1 :]
        bears = head in VESSELS | HOLDERS | PORTIONS | _DISHES
        return (normal(" ".join(held)),) if bears and held else ()
    if len(found) == 1:
        found = parted(found[0], VESSELS)
    if len(found) < 2 or is_mark(found[-1]):
        return ()
    held, head = normal(" ".join(found[:-1])), singular(found[-1])
    return (held,) if _bears(head, held) else ()


def stands_for(name: str, wanted: str) -> bool:
    """Whether who asks for ``wanted``, as ``normal`` makes it, may mean the thing of this name."""
    return any(each == wanted or each.endswith(f" {wanted}") for each in borne(name))


def holds_the_same(name: str, core: Sequence[str]) -> bool:
    """Whether the words, head last, are for such a container of the same: the cookie box is a biscuit tin."""
    held, head = normal(" ".join(core[:-1])), singular(core[-1])
    heads = {head, singular(without_marks(words(name))[-1])}
    alike = any(heads <= group for group in _ALIKE)
    return alike and any(mean_the_same(held, each) for each in borne(name))


def holds_another(name: str, held: str) -> bool:
    """Whether the thing is a container of something else: no milk carton is a box of cookies."""
    wanted, own = normal(held), borne(name)
    if not own or not _consumed(wanted):
        return False
    return not any(
        mean_the_same(wanted, each)
        or f" {wanted}".endswith(f" {each}")
        or each.endswith(f" {wanted}")
        for each in own
    )


def _bears(head: str, held: str) -> bool:
    if head in _DOSES | _SHEETS | _AMOUNTS:
        return True
    if head in VESSELS | HOLDERS:
        return _consumed(held)
    if head in _PLANTS:
        return not any(belonging(held, classes().named(each)) >= LIKELY for each in _APART)
    return False


def _consumed(held: str) -> bool:
    """Whether it is kept in vessels: milk and shampoo are, a flower and a cat are not."""
    if held in MATERIALS:
        return False  # a paper bag
    if any(belonging(held, classes().named(each)) >= LIKELY for each in _KEPT):
        return True
    known = held if nouns().knows(held) else held.split()[-1]
    kept, lives = (_likely(known, kinds) for kinds in (_CONSUMED, _LIVING))
    return kept >= LIKELY and kept > lives


def _likely(noun: str, kinds: tuple[str, ...]) -> float:
    return max(nouns().is_a(noun, nouns().root(each)) for each in kinds)
