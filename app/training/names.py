"""Names of single things: a noun, the words beside it that tell it apart, its article."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from app.domain.program import literal
from app.training.said import Said, one
from app.training.words import Words, article, plural


@dataclass(frozen=True, slots=True)
class Marking:
    """How often a noun has a word beside it that tells it apart from others."""

    below: Mapping[str, float]
    """Ways and the bound that a draw is to lie below, rising; what is above them all stays bare."""
    numbers: Sequence[str]
    """Numbers and letters such things go by."""


class Names:
    """Somebody who names things, and no two things of a sentence alike."""

    def __init__(self, words: Words, *, familiar: bool = False) -> None:
        self.words = words
        self.rng = words.rng
        self.familiar = familiar
        self.used: set[str] = set()

    def noun(self) -> str:
        """A thing's name of one to three words, not used before in this sentence."""
        while True:
            draw, lists = self.rng.random(), self.words.lists
            if draw < 0.25 and not self.familiar:
                found = self.words.choose(lists["nouns"])
            elif draw < 0.5:
                found = self.words.choose(lists["words"]["variants"])
            elif draw < 0.6 and "things" in lists:
                found = self.words.choose(lists["things"])
            else:
                found = self.words.choose(self.rng.choice(self.words.classes()).members)
            if found not in self.used:
                self.used.add(found)
                return found

    def adjective(self) -> str:
        """Mostly a colour, a material or a size."""
        lists = self.words.lists["words"]
        kind = self.rng.choice(("colours", "colours", "materials", "sizes", "free"))
        if kind == "free":
            return self.words.say("speech", "adjectives")
        found = self.rng.choice(lists[kind])
        return (
            self.rng.choice(("big", "large", "little", "tiny", found)) if kind == "sizes" else found
        )

    def marked(self, noun: str, marking: Marking) -> Said:
        """With an adjective, a mark, a side, a number or nothing, and mostly an article."""
        draw = self.rng.random()
        match next((way for way, bound in marking.below.items() if draw < bound), "bare"):
            case "adjective":
                noun = f"{self.adjective()} {noun}"
            case "mark":
                noun = f"{self.words.say('speech', 'marks')} {noun}"
            case "side":
                noun = f"{noun} {self.words.say('speech', 'sides')}"
            case "two adjectives":
                noun = f"{self.adjective()} {self.adjective()} {noun}"
            case "number":
                noun = f"{noun} {self.rng.choice(marking.numbers)}"
                return one(noun, noun)
            case "any":
                return self.any_of(noun)
        return self.with_article(noun)

    def with_article(self, noun: str) -> Said:
        """Mostly ``the``; a name of the owner belongs to the words, ``my`` does not."""
        draw = self.rng.random()
        forms = {"a": f"{article(noun)} {noun}", "bare": noun}
        if draw < 0.06:
            owner = self.words.say("speech", "owners")
            text = f"{owner} {noun}"
            phrase = text if "'" in owner else noun
            if "'" in owner and self.words.chance(0.5):
                text = text[0].upper() + text[1:]
            return one(text, phrase, **{**forms, "a": text})
        before = self.rng.choices(("the ", "that ", "this ", ""), (84, 3, 3, 10))[0]
        return one(before + noun, noun, **forms)

    def bare(self) -> Said:
        """A thing by its noun alone, and its article."""
        return self.with_article(self.noun())

    def any_of(self, noun: str) -> Said:
        """``any bowl``, ``one of the bowls``: whichever."""
        text = f"{self.rng.choice(('a', 'any', 'one of the', 'some'))} {noun}"
        text = text if not text.startswith("one of") else f"one of the {plural(noun)}"
        words = plural(noun) if text.startswith("one of") else noun
        if text.startswith("a ") and article(noun) == "an":
            text = f"an {noun}"
        return Said(text, (f"all({literal(words)}, count=1)",))

    def odd(self, noun: str) -> Said:
        """A name nobody would give, to be copied letter by letter."""
        number = self.rng.randint(1, 99)
        styles = (
            *(f"{noun} ({number})", f"{noun} #{number}", f"{noun}_{number}", f"{noun}-{number}"),
            *(f'"quoted" {noun}', f"{noun} no. {number}", f"{noun} [{number}]", f"{noun}/{number}"),
            *(f"{noun} & co", f"{noun} nr {number}", f"{noun}.{number}", f'"{noun}"', f"<{noun}>"),
            *(f"{noun} 🙂", f"{noun}@home", f"{noun} v{number}", f"x'{noun}", f"{noun}'; pass"),
        )
        found = self.rng.choice(styles)
        return one(self.rng.choice(("the ", "the ", "")) + found, found)

    def related(self, noun: str, relations: Sequence[str]) -> Said:
        """By what it stands beside: ``the cup next to the plate``."""
        other = self.bare()
        key = self.rng.choice(relations)
        place = self.words.say("speech", "relations", key).format(r=other.text)
        return Said(
            f"the {noun} {place}", (f"one({literal(noun)}, {key}={other.words})",), literal(noun)
        )

    def superlative(self, noun: str) -> Said:
        """By its place among its like: ``the cup that is furthest to the left``."""
        key = self.rng.choice(list(self.words.lists["speech"]["superlatives"]))
        how = self.words.say("speech", "superlatives", key)
        return Said(
            f"the {noun} {how}", (f"one({literal(noun)}, where={literal(key)})",), literal(noun)
        )
