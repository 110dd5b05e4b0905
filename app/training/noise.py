"""How a sentence is finally typed: courtesies, capitals, full stops, slips of the finger."""

import re
from random import Random

from app.training.said import tidy
from app.training.words import Words

SHORT = {
    "please": "pls",
    "and": "n",
    "you": "u",
    "are": "r",
    "for": "4",
    "to": "2",
    "with": "w/",
    "the": "da",
    "thanks": "thx",
    "everything": "evrything",
    "because": "cuz",
    "want to": "wanna",
}
KEYS = {
    "a": "sqz",
    "s": "adw",
    "d": "sfe",
    "e": "wrd",
    "r": "etf",
    "t": "ryg",
    "i": "uok",
    "o": "ipl",
    "n": "bm",
    "m": "n",
    "l": "ko",
    "p": "ol",
    "c": "vx",
    "b": "vn",
    "g": "fh",
    "h": "gj",
    "u": "yi",
    "y": "tu",
    "k": "jl",
    "w": "qe",
    "v": "cb",
    "f": "dg",
}


def dress(words: Words, sentence: str, *, order: bool) -> str:
    """With what people say around it."""
    share = 0.42 if order else 0.12
    while words.chance(share):
        sentence = tidy(
            words.say("wraps", "imperative" if order else "any").replace(
                "{s}", sentence.rstrip(".")
            )
        )
        order, share = order and sentence.split()[0] in {"please", "just", "put", "move"}, 0.1
    return sentence


def typed(words: Words, sentence: str) -> str:
    """Capitals and an end."""
    draw = words.rng.random()
    if draw < 0.02:
        return sentence.upper() + words.rng.choice(("", "!", "!!!"))
    if draw < 0.48:
        sentence = sentence[0].upper() + sentence[1:]
        sentence = re.sub(r"([.!?]) ([a-z])", lambda m: f"{m[1]} {m[2].upper()}", sentence)
        sentence = re.sub(r"\bi('|\b)", r"I\1", sentence)
        if sentence[-1] not in ".?!" and words.chance(0.7):
            sentence += "."
    elif draw < 0.55 and sentence[-1] not in ".?!":
        sentence += words.rng.choice((".", "!", " ."))
    return sentence


def misspell(rng: Random, text: str) -> str:
    """A few words with letters swapped, dropped, doubled or hit beside; now and then shorthand."""
    if rng.random() < 0.3:
        text = " ".join(
            SHORT.get(word, word) if rng.random() < 0.6 else word for word in text.split(" ")
        )
    if rng.random() < 0.25:
        text = re.sub(r"\b(the|a|an) ", "", text)
    words = text.split(" ")
    long = [i for i, word in enumerate(words) if len(word) > 3 and word.strip(",.!?").isalpha()]
    for index in rng.sample(long, min(len(long), rng.choice((1, 1, 2, 2, 3, 4)))):
        words[index] = _slip(rng, words[index])
    return " ".join(words)


def _slip(rng: Random, word: str) -> str:  # noqa: C901 (a case for each slip)
    at = rng.randrange(1, len(word) - 1)
    kind = rng.randrange(7)
    if kind == 0:
        return word[:at] + word[at + 1] + word[at] + word[at + 2 :]
    if kind == 1:
        return word[:at] + word[at + 1 :]
    if kind == 2:
        return word[:at] + word[at] + word[at:]
    if kind == 3:
        return word[:at] + rng.choice(KEYS.get(word[at].lower(), "e")) + word[at + 1 :]
    if kind == 4:
        vowels = [i for i, letter in enumerate(word) if letter in "aeiou" and i > 0]
        if vowels:
            at = rng.choice(vowels)
            return word[:at] + rng.choice("aeiou") + word[at + 1 :]
    if kind == 5:
        for old, new in rng.sample(
            (
                ("ck", "k"),
                ("ph", "f"),
                ("tt", "t"),
                ("oo", "u"),
                ("ee", "ea"),
                ("ss", "s"),
                ("c", "k"),
                ("y", "ie"),
                ("ll", "l"),
                ("rr", "r"),
                ("ea", "ee"),
                ("er", "re"),
            ),
            6,
        ):
            if old in word[1:]:
                return word[0] + word[1:].replace(old, new, 1)
    return word[:at] + rng.choice("aeioustrln") + word[at:]
