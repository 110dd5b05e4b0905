"""Things that are named one by one: by a name, a place, a use."""

from app.programs.knowledge.uses import phrases
from app.training.describing import described
from app.training.listing import enumerated, joined, listed
from app.training.names import Marking, Names
from app.training.said import Said, one
from app.training.words import plural

MARKING = Marking(
    below={
        "adjective": 0.22,
        "mark": 0.28,
        "side": 0.31,
        "two adjectives": 0.34,
        "number": 0.37,
    },
    numbers=("1", "2", "3", "4", "7", "12", "a", "b", "c"),
)


class Things:
    """Somebody who speaks of one thing or of several."""

    def __init__(self, names: Names) -> None:
        self.names = names
        self.words = names.words
        self.rng = names.rng

    def thing(self) -> Said:
        """``the red mug``; the sketch's words are the same without the article."""
        draw, names = self.rng.random(), self.names
        if draw < 0.03:
            return names.odd(names.noun())
        if draw < 0.09:
            return names.related(names.noun(), list(self.words.lists["speech"]["relations"]))
        if draw < 0.12:
            return names.superlative(names.noun())
        if draw < 0.18:
            return self.indirect()
        return names.marked(names.noun(), MARKING)

    def indirect(self) -> Said:
        """``something to write with``, ``the thing that tells the time``."""
        draw = self.rng.random()
        if draw < 0.5:
            return one(*described(self.rng, self.words.choose(phrases())))
        return self._for_a_task() if draw < 0.75 else self._by_a_fact()

    def _for_a_task(self) -> Said:
        task = self.words.say("speech", "tasks")
        head = self.rng.choice(
            ("something", "something", "a thing", "the thing", "an object", "one thing")
        )
        if not task.startswith(("to ", "for ")):
            head = "something"
        return one(f"{head} {task}", f"thing {task}")

    def _by_a_fact(self) -> Said:
        fact = self.words.say("speech", "facts")
        head = self.rng.choice(
            ("the thing that", "the object that", "the one that", "what", "the thing which")
        )
        drop = fact.split()[0] in {"you", "we", "i", "monkeys", "rabbits"}
        head = (
            head.removesuffix(" that").removesuffix(" which")
            if drop and self.words.chance(0.5)
            else head
        )
        return one(f"{head} {fact}", f"thing {'' if drop else 'that '}{fact}")

    def several(self) -> Said:
        """``the knife, the fork and the spoon``; or one noun in several colours."""
        number = self.rng.choice((2, 2, 2, 3, 3, 4))
        same = self.rng.random()
        items = [self.names.bare() for _ in range(number)]
        if same < 0.25:
            noun = self.names.noun()
            colours = self.rng.sample(self.words.lists["words"]["colours"], number)
            items = [one(f"the {colour} {noun}", f"{colour} {noun}") for colour in colours]
            if same < 0.12:
                many = listed(self.rng, colours)
                return joined(
                    items, f"the {many} {plural(noun) if self.words.chance(0.6) else noun}"
                )
        return enumerated(self.rng, items)
