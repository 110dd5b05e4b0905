"""Import line + sentence → a GBNF grammar of a sketch: its verbs, its forms, and the words to use.

The words for things are those of the sentence, one or several of a thing, and a few that stand for
words left out ("everything red": ``all('red things')``). So the model cannot slip from a bowl to a
bucket. What the words mean is for the resolver.
"""

import re
from collections.abc import Iterable, Sequence
from itertools import permutations

from app.domain.action import ActionSignature, Parameter
from app.domain.program import literal
from app.programs.knowledge.classes import normal
from app.programs.printer import INDENT
from app.programs.sketches.sketch import RELATIONS
from app.programs.sketches.whereabouts import SPOKEN_RELATIONS

MAX_CALLS = 12
MAX_LEFT_OUT = 6
MAX_WORDS = 80
"""Characters of a phrase whose words are free."""
MAX_LENGTH = 10
"""Words of a phrase."""
MAX_VOCABULARY = 120
ALWAYS = "thing things object objects item items one ones other it them that"
WHERE = "leftmost rightmost nearest farthest largest smallest tallest heaviest lightest"
ORDERS = ("largest first", "smallest first", "left to right", "right to left")
SHARED = ("colour", "material", "size", "shape", "category")

_FORMS = rf"""several ::= words | "[" words (", " words){{1,{MAX_LEFT_OUT}}} "]"
integer ::= [1-9] [0-9]?
number ::= "-"? [0-9]{{1,4}} ("." [0-9]{{1,4}})?
same ::= "same(" shared ", " words ")"
each ::= "each(" words (", count=" integer)? ")"
thing ::= words | one | all | "rest"
target ::= thing | same | each | "previous"
free ::= target | number
"""


def sketch_grammar(
    actions: Iterable[ActionSignature],
    sentence: str | None = None,
    earlier: Sequence[str] = (),
    *,
    each: bool = False,
    declines: bool = True,
) -> str:
    """The grammar of everything after the prompt: indented calls, or a decline; then an empty line.

    Without a sentence the words for things are free. ``earlier`` are names that turns before this
    one used; the sentence may refer to them. With ``each`` every action is called exactly
    once; ``declines`` says whether it may be declined.
    """
    calls = [f"{_text(f'{action.name}(')} {_arguments(action)} {_text(')')}" for action in actions]
    declined = f'{_text(f"{INDENT}decline(")} "\'impossible\'" {_text(")")} "\\n"'
    steps = [f"step{{1,{MAX_CALLS}}}"] if calls else []
    steps += ["declined"] if declines or not calls else []
    rules = [f'root ::= ({" | ".join(steps)}) "\\n"', f"declined ::= {declined}"]
    if each:
        lines = [f'{_text(INDENT)} {call} "\\n"' for call in calls]
        orders = (" ".join(order) for order in permutations(lines))
        rules = [f'root ::= ({" | ".join(orders)}) "\\n"']
    elif calls:
        rules += [f'step ::= {_text(INDENT)} call "\\n"', f"call ::= {' | '.join(calls)}"]
    rules += _words(sentence, earlier)
    rules += _qualified(sentence)
    return "\n".join(rules) + f"\n{_FORMS}"


def _words(sentence: str | None, earlier: Sequence[str]) -> list[str]:
    """The rule for words in quotes."""
    known = vocabulary(sentence, earlier) if sentence is not None else []
    if not known or len(known) > MAX_VOCABULARY:
        free = rf"""([^'\\\x00-\x1f\x7f] | "\\" ['\\]){{1,{MAX_WORDS}}}"""
        return [f'words ::= "\'" {free} "\'"']
    choices = " | ".join(_text(literal(word)[1:-1]) for word in known)
    whole = "".join(f" | {_text(literal(name))}" for name in earlier)
    return [
        f"word ::= {choices}",
        f'words ::= "\'" word (" " word){{0,{MAX_LENGTH - 1}}} "\'"{whole}',
    ]


def vocabulary(sentence: str, earlier: Sequence[str]) -> list[str]:
    """The words that phrases are made of, lower case, each once."""
    found: dict[str, None] = {}
    for token in sentence.lower().split():
        bare = token.strip('.,!?;:()[]"\u201c\u201d\u2018')
        for piece in (bare, bare.removesuffix("'s"), *re.split(r"[-/,;]", bare)):
            if piece and piece.isprintable():
                found |= dict.fromkeys((piece, *_forms(piece)))
    for name in earlier:
        found |= dict.fromkeys(name.lower().split())
    return [*found, *(word for word in ALWAYS.split() if word not in found)]


def _forms(word: str) -> tuple[str, ...]:
    """One of it, and several."""
    if not word.isalpha() or not word.isascii() or len(word) < 3:
        return ()
    single = normal(word)
    if single == word and re.search(r"[^s]s$", word):
        return (single,)  # Glasses have no plural of their own.
    plural = f"{single[:-1]}ies" if re.search(r"[^aeiou]y$", single) else f"{single}s"
    return (single, f"{single}es" if re.search(r"(s|x|z|ch|sh)$", single) else plural)


def _qualified(sentence: str | None) -> list[str]:
    """The rules for what may be said of a thing besides its words."""
    said = set(re.findall(r"\w+", sentence.lower())) if sentence is not None else None
    keys = [key for key in RELATIONS if said is None or said & SPOKEN_RELATIONS[key]]
    relation = " relation{0,2}" if keys else ""
    rules = [
        f'where ::= ", where=\'" ({_any(WHERE.split())}) "\'"',
        f'order ::= ", order=\'" ({_any(ORDERS)}) "\'"',
        f'shared ::= "\'" ({_any(SHARED)}) "\'"',
        f'one ::= "one(" words where?{relation} ")"',
        'all ::= "all(" words (", but=" several)? (", count=" integer)? where? order?'
        f'{relation} ")"',
    ]
    if keys:
        rules.append(f'relation ::= ", " ({_any(keys)}) "=" words')
    return rules


def _any(choices: Iterable[str]) -> str:
    return " | ".join(map(_text, choices))


def _arguments(action: ActionSignature) -> str:
    kinds = [_kind(action, parameter) for parameter in action.parameters]
    return f" {_text(', ')} ".join(kinds) if kinds else '""'


def _kind(action: ActionSignature, parameter: Parameter) -> str:
    if parameter.role == "word" and parameter.words:
        return f"({_any(literal(word) for word in parameter.words)})"
    if parameter.role == "number":
        return "number"
    return "thing" if len(action.parameters) == 1 else "free"


def _text(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'
