"""How people say it: noun phrases, sentence frames, politeness, slips of the finger."""

from collections.abc import Sequence
from dataclasses import dataclass
from random import Random

from app.training.scenes import Item
from app.training.things import Split, Vocabulary, choose

INTO = {"in": ("in", "in", "into", "inside"), "on": ("on", "on", "onto", "on top of")}
TOWARDS = {"in": ("into", "to", "over to"), "on": ("onto", "to", "over to")}
NUMBERS = ("no", "one", "two", "three", "four", "five", "six", "seven")
IRREGULAR = {"knife": "knives", "mouse": "mice", "goose": "geese", "loaf": "loaves"}

MOVES = (
    *("put {x} {p} {h}", "place {x} {p} {h}", "move {x} {t} {h}", "put  {x} {p} {h}"),
    *("transfer {x} {t} {h}", "drop {x} {p} {h}", "set {x} {p} {h}", "stick {x} {p} {h}"),
    *("get {x} {t} {h}", "pop {x} {p} {h}", "grab {x} and put {it} {p} {h}", "bring {x} {t} {h}"),
    *("take {x} and place {it} {p} {h}", "pick up {x} and drop {it} {p} {h}", "{x} {t} {h}"),
    *("{x} should be {p} {h}", "{x} should go {p} {h}", "i want {x} {p} {h}", "store {x} {p} {h}"),
    *("i'd like {x} to be {p} {h}", "i would like to have {x} {p} {h}", "keep {x} {p} {h}"),
    *("{p} {h} you should put {x}", "{h} is the place for {x}", "let's have {x} {p} {h}"),
    *("fetch {x} and leave {it} {p} {h}", "stow {x} {p} {h}", "use {h} for {x}", "{h} is for {x}"),
    *("find {x} and put {it} {p} {h}", "{p} {h} goes {x}", "i need {x} {p} {h}", "lay {x} {p} {h}"),
    *("arrange for {x} to be {p} {h}", "make {x} end up {p} {h}", "relocate {x} {t} {h}"),
)
GATHERINGS = (
    *("collect {x} {p} {h}", "gather {x} {p} {h}", "fill {h} with {x}", "tidy {x} away {t} {h}"),
    *(
        "sort {x} {t} {h}",
        "pack {x} {t} {h}",
        "clear {x} away {t} {h}",
        "look for {x}; {h} is for them",
    ),
    *("pick out {x} and put them {p} {h}", "take {x} and put them {p} {h}", "load {h} with {x}"),
)
DRESSES = (
    *(
        ("{s}", 30),
        ("{s}, please", 5),
        ("please {s}", 8),
        ("could you {s}?", 5),
        ("can you {s}", 5),
    ),
    *(("i need you to {s}", 3), ("robot, {s}", 2), ("would you please {s}?", 2), ("now {s}", 2)),
    *(("i want you to {s}", 2), ("{s} for me", 2), ("your job: {s}", 1), ("you may {s} now", 1)),
    *(("kindly {s}", 1), ("just {s}", 1), ("go ahead and {s}", 2), ("{s}, thanks", 2)),
)


@dataclass(frozen=True, slots=True)
class NounPhrase:
    """What is meant, in words."""

    text: str
    plural: bool = False


class Speaker:
    """Somebody who asks for things, in one of many ways."""

    def __init__(self, rng: Random, vocabulary: Vocabulary) -> None:
        self.rng = rng
        self.vocabulary = vocabulary
        self.split: Split = vocabulary.split

    def choose(self, options: Sequence[str]) -> str:
        """One of several ways of saying it."""
        return choose(self.rng, options, self.split)

    def the(self, item: Item) -> NounPhrase:
        """One object by its own name."""
        if item.name[-1].isdigit() or item.name[-1].isupper():
            return NounPhrase(item.name)
        article = self.rng.choices(("the ", "my ", "that ", ""), (90, 2, 3, 3))[0]
        return NounPhrase(article + item.name)

    def both(self, items: Sequence[Item]) -> NounPhrase:
        """Several objects by their names, in any order."""
        texts = [self.the(item).text for item in self.rng.sample(items, len(items))]
        return NounPhrase(
            ", ".join(texts[:-1]) + self.rng.choice((" and ", " and ", " as well as ")) + texts[-1],
            True,
        )

    def move(self, what: NounPhrase, holder: Item, *, gather: bool = False) -> str:
        """A wish that ``what`` be in or on the holder."""
        frames = (*MOVES, *GATHERINGS, *GATHERINGS) if gather and what.plural else MOVES
        frame = self.choose(frames) if self.rng.random() < 0.6 else self.choose(frames[:6])
        text = frame.format(
            x=what.text,
            h=self.the(holder).text,
            p=self.rng.choice(INTO[holder.preposition or "on"]),
            t=self.rng.choice(TOWARDS[holder.preposition or "on"]),
            it="them" if what.plural else "it",
        )
        return " ".join(text.split())

    def dress(self, sentence: str) -> str:
        """The sentence as it is finally typed."""
        imperative = sentence.split()[0] in {frame.split()[0] for frame in (*MOVES, *GATHERINGS)}
        if imperative and not sentence.startswith(("i ", "i'd", "{")):
            options, weights = zip(*DRESSES, strict=True)
            sentence = self.rng.choices(options, weights)[0].format(s=sentence)
        if self.rng.random() < 0.06:
            sentence = f"{self.rng.choice(self.vocabulary.words['prefaces'])} {sentence}"
        if self.rng.random() < 0.45:
            sentence = sentence[0].upper() + sentence[1:]
            if self.rng.random() < 0.75 and sentence[-1] not in ".?!":
                sentence += "."
        return sentence


def plural(noun: str) -> str:
    """More than one of it."""
    head, _, last = noun.rpartition(" ")
    if last in IRREGULAR:
        many = IRREGULAR[last]
    elif last.endswith(("s", "x", "ch", "sh")):
        many = last if last.endswith("s") and not last.endswith("ss") else f"{last}es"
    elif last.endswith("y") and last[-2] not in "aeiou":
        many = f"{last[:-1]}ies"
    else:
        many = f"{last}s"
    return f"{head} {many}".strip()


def misspell(rng: Random, text: str) -> str:
    """One or two of the longer words with a letter swapped, dropped, doubled or replaced."""
    words = text.split(" ")
    long = [index for index, word in enumerate(words) if len(word) > 3 and word.isalpha()]
    for index in rng.sample(long, min(len(long), rng.choice((1, 1, 2, 3)))):
        word, at = words[index], rng.randrange(1, len(words[index]) - 1)
        kinds = (
            word[:at] + word[at + 1] + word[at] + word[at + 2 :],
            word[:at] + word[at + 1 :],
            word[:at] + word[at] + word[at:],
            word[:at] + rng.choice("aeiourstnl") + word[at + 1 :],
        )
        words[index] = rng.choice(kinds)
    return " ".join(words)
