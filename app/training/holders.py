"""Places that things are put: ``in the bowl``, ``onto a tray``."""

from dataclasses import replace

from app.training.names import Marking, Names
from app.training.said import Said

INTO = {
    "in": ("in", "in", "in", "into", "into", "inside"),
    "on": ("on", "on", "on", "onto", "on top of"),
}
TOWARDS = {"in": ("into", "to", "over to"), "on": ("onto", "to", "over to")}
THERE = {
    "in": ("in it", "inside", "inside it", "there", "into it"),
    "on": ("on it", "on top", "onto it", "there", "on top of it"),
}
BESIDE = ("left_of", "right_of", "near", "behind", "in_front_of")
"""What a holder stands to another thing."""
MARKING = Marking(
    below={"adjective": 0.14, "mark": 0.24, "side": 0.28, "number": 0.33, "any": 0.37},
    numbers=("1", "2", "3", "4", "a", "b"),
)


class Holders:
    """Somebody who says where things go."""

    def __init__(self, names: Names) -> None:
        self.names = names
        self.words = names.words
        self.rng = names.rng

    def holder(self) -> Said:
        """``the bowl``, with its preposition."""
        lists, names = self.words.lists, self.names
        kind = self.rng.choice(("in", "in", "in", "on", "on"))
        extra = "containers_extra" if kind == "in" else "surfaces_extra"
        noun = self.words.choose([*lists["words"]["containers"][kind], *lists["speech"][extra]])
        if noun in names.used:
            return self.holder()
        names.used.add(noun)
        draw = self.rng.random()
        if draw < 0.03:
            said = names.odd(noun)
        elif draw < 0.06:
            said = replace(names.related(noun, BESIDE), words="")
        elif draw < 0.08:
            said = replace(names.superlative(noun), words="")
        else:
            said = self.named(noun)
        return self.placed(said, kind)

    def box(self) -> Said:
        """A container by its plain name."""
        while True:
            found = self.holder()
            if found.kind == "in" and found.words:
                return found

    def named(self, noun: str) -> Said:
        """With a colour, a side or nothing, and an article."""
        return self.names.marked(noun, MARKING)

    def placed(self, said: Said, kind: str) -> Said:
        """With the forms that say where."""
        choose = self.rng.choice
        forms = {
            "in": f"{choose(INTO[kind])} {said.text}",
            "to": f"{choose(TOWARDS[kind])} {said.text}",
            "to2": f"to {said.text}",
            "inin": kind,
            "space": f"{kind} {said.text}",
            "there": choose(THERE[kind]),
        }
        return Said(said.text, said.arguments, said.words, forms={**said.forms, **forms}, kind=kind)
