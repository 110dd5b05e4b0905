"""What is left out of a set: ``everything but the mug``, ``the fruits that are not red``."""

from app.domain.program import literal
from app.training.listing import enumerated
from app.training.said import Said, one, tidy
from app.training.sets import Sets, class_said, set_said
from app.training.words import ThingClass


class Leaving:
    """Somebody who speaks of a set and of what is not meant."""

    def __init__(self, sets: Sets) -> None:
        self.sets = sets
        self.names = sets.names
        self.words = sets.words
        self.rng = sets.rng

    def all_but(self) -> Said:
        """A set with something left out of it."""
        draw, sets = self.rng.random(), self.sets
        if draw < 0.14:
            found, adjective = sets.kind(), self.names.adjective()
            text = sets.told("negated", found, adj=adjective)
            return _but(text, found.many, literal(f"{adjective} {found.many}"))
        if draw < 0.22:
            adjective = self.names.adjective()
            text = self.words.say("sets", "negated_things").format(adj=adjective)
            return _but(text, "things", literal(f"{adjective} things"))
        if draw < 0.34:
            found = sets.kind()
            return _but(sets.told("negated_class", found), "things", literal(found.many))
        if draw < 0.56:
            whole, left = sets.everything(), self.left_out()
            return _but(self._without(whole, left), "things", left.words)
        found = sets.kind()
        whole = sets.whole(found)
        left = self.member(found)
        return _but(self._without(whole, left), found.many, left.words, plural=whole.plural)

    def _without(self, whole: Said, left: Said) -> str:
        template = self.words.say("sets", "except")
        if "{e.isnt}" in template or "aren't {e}" in template:
            template = "{s} except {e}"
        return tidy(template.format(s=whole.text, e=left.text))

    def left_out(self) -> Said:
        """Things or a class that stay where they are."""
        if self.words.chance(0.25):
            return class_said(self.sets.kind())
        items = [
            self.names.with_article(self._adjective_noun())
            for _ in range(self.rng.choice((1, 1, 1, 2, 2, 3)))
        ]
        return enumerated(self.rng, items)

    def _adjective_noun(self) -> str:
        noun = self.names.noun()
        return f"{self.names.adjective()} {noun}" if self.words.chance(0.25) else noun

    def member(self, found: ThingClass) -> Said:
        """One or more members of the class, by name or by what they look like."""
        names = self.names
        members = [each for each in found.members if each not in names.used]
        draw = self.rng.random()
        if draw < 0.12:
            adjective = names.adjective()
            phrase = f"{adjective} {found.one}"
            text = self.rng.choice((f"the {adjective} one", f"the {phrase}"))
            return one(text, phrase)
        if draw < 0.2:
            adjective = names.adjective()
            phrase = f"{adjective} {found.many}"
            text = self.rng.choice((f"the {adjective} ones", f"{adjective} ones", f"the {phrase}"))
            return Said(text, (f"all({literal(phrase)})",), literal(phrase), plural=True)
        count = self.rng.choice((1, 1, 1, 1, 2, 2, 3)) if len(members) > 4 else 1
        chosen = [self.words.choose(members or self.words.lists["nouns"])]
        while len(chosen) < count:
            more = self.rng.choice(members)
            if more not in chosen:
                chosen.append(more)
        names.used.update(chosen)
        return enumerated(self.rng, [names.with_article(each) for each in chosen])


def _but(text: str, phrase: str, left: str, *, plural: bool | None = None) -> Said:
    """All that the phrase fits but what is left; of one or many as the text says, or as told."""
    said = set_said(text, phrase)
    argument = f"all({literal(phrase)}, but={left})"
    return Said(text, (argument,), "", said.plural if plural is None else plural)
