"""From a name people give to the entry of a vocabulary it means."""

import difflib
import re
import unicodedata
from collections.abc import Container, Mapping

COLOUR_WORDS: Mapping[str, str] = {
    **{hue: hue for hue in ("red", "green", "blue", "yellow", "orange", "purple", "pink")},
    **{hue: hue for hue in ("brown", "black", "white", "gray", "grey", "beige", "violet")},
    **{hue: hue for hue in ("cyan", "magenta", "turquoise", "silver", "gold")},
    **{"wooden": "burlywood", "metal": "silver", "steel": "silver", "golden": "gold"},
    **{"mustard": "#dba514", "ketchup": "#c1121f"},
}
"""Words of a name that tell an object's colour, and the colour as CSS has it."""
_THINGS = ("orange", "mustard", "ketchup")
"""What at a name's end is the object, not its colour."""
_SHADED = tuple(f"{shade}{hue}" for shade in ("light", "dark") for hue in ("green", "blue", "gray"))
_PLACES = ("left", "right", "front", "back", "middle", "top", "bottom", "first", "second")
_TYPO = 0.84
"""The similarity from which a word counts as another one misspelt."""


def best_match(name: str, vocabulary: Mapping[str, str]) -> str | None:
    """The entry that ``name`` means, or None.

    Looked for in this order: the whole name, its longest ending that is in the vocabulary (its
    head noun: ``mustard bottle`` is a bottle), and its last word with a slip in it. ``bowl of
    soup`` is a bowl; case, dashes, plural, numbers and places (``block_2``, ``bowls (left)``)
    do not count.

    Args:
        name: what somebody calls an object.
        vocabulary: from names and synonyms, lower case, to entries.
    """
    phrases = _phrases(name)
    for words in phrases:
        for start in range(len(words)):
            if (ending := " ".join(words[start:])) in vocabulary:
                return vocabulary[ending]
    for words in phrases:
        if words and (meant := _misspelt(words[-1], vocabulary)):
            return vocabulary[meant]
    return None


def colour_in(name: str) -> str | None:
    """The CSS colour a name tells of its object, as ``red block`` does; an orange tells none."""
    words = _unmarked(_words(name))
    for index, word in enumerate(words):
        if word in COLOUR_WORDS and not (word in _THINGS and index == len(words) - 1):
            found = COLOUR_WORDS[word]
            shaded = words[index - 1] + found if index else found
            return shaded if shaded in _SHADED else found
    return None


def _phrases(name: str) -> list[tuple[str, ...]]:
    """The ways to read a name, the likeliest first, each without what does not count."""
    whole = _words(name)
    readings = [whole[: whole.index(link)] for link in ("of", "with", "for") if link in whole[1:]]
    unmarked = [_unmarked(words) for words in (*readings, whole)]
    uncoloured = [_unmarked(words, COLOUR_WORDS) for words in unmarked]
    return [(*words[:-1], _singular(words[-1])) for words in (*unmarked, *uncoloured) if words]


def _words(name: str) -> tuple[str, ...]:
    plain = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode()
    apart = re.sub(r"(?<=[a-z])(?=[A-Z])|(?<=[a-zA-Z])(?=\d)", " ", plain)  # redBlock2
    return tuple(re.findall(r"[a-z0-9]+", apart.lower().replace("'s", "")))


def _unmarked(words: tuple[str, ...], marks: Container[str] = ()) -> tuple[str, ...]:
    """Without numbers, single letters, places and the given words at the end; never empty."""
    while len(words) > 1 and (_is_mark(words[-1]) or words[-1] in marks):
        words = words[:-1]
    return words


def _is_mark(word: str) -> bool:
    return word.isdigit() or len(word) == 1 or word in _PLACES


def _singular(word: str) -> str:
    irregular = {"knives": "knife", "dice": "die", "loaves": "loaf", "leaves": "leaf"}
    if word in irregular:
        return irregular[word]
    if word.endswith("ies") and len(word) > 4:
        return word[:-3] + "y"
    if re.search(r"(s|x|z|ch|sh|to)es$", word):
        return word[:-2]
    return (
        word[:-1] if re.search(r"[^siu]s$", word) and word not in ("scissors", "pliers") else word
    )


def _misspelt(word: str, vocabulary: Mapping[str, str]) -> str | None:
    """The single word of the vocabulary that ``word`` is with a slip in it; never a short one."""
    if len(word) < 5:
        return None
    near = difflib.get_close_matches(
        word, [known for known in vocabulary if len(known) > 4], 1, _TYPO
    )
    return near[0] if near and near[0][0] == word[0] else None
