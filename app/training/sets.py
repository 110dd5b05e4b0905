"""Sets of things: a class, what is made of metal, what can be written with, two of the blocks."""

from app.domain.program import literal
from app.training.names import Names
from app.training.numbers import shown
from app.training.said import Said
from app.training.words import ThingClass, article, plural

SINGLE = frozenset({"every", "each", "any", "everything", "anything", "whatever", "what"})
"""First words that have a set spoken of as one thing."""


def set_said(text: str, phrase: str) -> Said:
    """All that the phrase fits, and whether the text speaks of one or of many."""
    single = text.split()[0] in SINGLE and not text.startswith(("each of", "every one of"))
    return Said(text, (f"all({literal(phrase)})",), literal(phrase), plural=not single)


def class_said(found: ThingClass) -> Said:
    """Its plain plural and the forms templates need."""
    forms = {"many": found.many, "one": found.one, "nmany": found.many, "mmany": found.many}
    return Said(
        f"the {found.many}", (f"all({literal(found.many)})",), literal(found.many), True, forms
    )


class Sets:
    """Somebody who speaks of things by what they have in common."""

    def __init__(self, names: Names) -> None:
        self.names = names
        self.words = names.words
        self.rng = names.rng

    def kind(self) -> ThingClass:
        """A class or a noun with several of it, now and then with an adjective."""
        names, draw = self.names, self.rng.random()
        if draw < 0.5:
            found = self.rng.choice(self.words.classes())
        else:
            noun = names.noun()
            members = tuple(f"{names.adjective()} {noun}" for _ in range(4))
            found = ThingClass(plural(noun), noun, members)
        if draw < 0.12 or draw > 0.82:
            adjective = names.adjective()
            found = ThingClass(
                f"{adjective} {found.many}", f"{adjective} {found.one}", found.members
            )
        if found.many in names.used:
            return self.kind()
        names.used.add(found.many)
        return found

    def told(self, how: str, found: ThingClass, **slots: str) -> str:
        """The class in one of the templates for this way of speaking of it."""
        return self.words.say("sets", how).format(many=found.many, one=found.one, **slots)

    def all_of(self) -> Said:
        """A whole set, by class, property, material or use."""
        draw = self.rng.random()
        if draw < 0.08:
            return self.everything()
        if draw < 0.14:
            mass = self.words.say("speech", "mass")
            return set_said(self.words.say("sets", "mass").format(m=mass), mass)
        if draw < 0.17:
            belong = self.words.say("speech", "belong")
            text = self.words.say("sets", "belong").format(b=belong)
            return set_said(text, f"things that belong {belong}")
        if draw < 0.24:
            adjective = self.names.adjective()
            text = self.words.say("sets", "adjective_things").format(adj=adjective)
            return set_said(text, f"{adjective} things")
        if draw < 0.30:
            return self.made_of()
        return self.useful() if draw < 0.37 else self.class_set()

    def made_of(self) -> Said:
        """``everything made of glass``."""
        material = self.words.say("speech", "materials")
        if self.words.chance(0.3):
            found = self.kind()
            text = self.told("class_made_of", found, material=material)
            return set_said(text, f"{found.many} made of {material}")
        text = self.words.say("sets", "made_of").format(material=material)
        return set_said(text, f"things made of {material}")

    def useful(self) -> Said:
        """``everything you can write with``."""
        use = self.words.say("speech", "uses")
        told = f"can {use}" if self.words.chance(0.5) else use
        text = self.words.say("sets", "use").format(use=told)
        text = text.replace("can can", "can").replace("could can", "could").replace("'d can", "'d")
        able = "" if use.startswith("need") else "can "
        return set_said(text, f"things you {able}{use}")

    def class_set(self) -> Said:
        """All of a class or of a noun."""
        found, draw = self.kind(), self.rng.random()
        if draw < 0.08:
            return set_said(self.told("being", found), found.many)
        if draw < 0.16:
            adjective = self.names.adjective()
            text = self.told("class_adjective", found, adj=adjective)
            return set_said(text, f"{adjective} {found.many}")
        if draw < 0.21:
            return self._related(found)
        return self.whole(found)

    def whole(self, found: ThingClass) -> Said:
        """All of this class."""
        return set_said(self.told("all", found), found.many)

    def _related(self, found: ThingClass) -> Said:
        key = self.rng.choice(list(self.words.lists["speech"]["relations"]))
        other = self.names.bare()
        place = self.words.say("speech", "relations", key).format(r=other.text)
        if "closest" in place or "nearest" in place:
            place = f"near {other.text}"
            key = "near"
        before = self.rng.choice(("all the", "the", "all", "every one of the"))
        argument = f"all({literal(found.many)}, {key}={other.words})"
        return Said(f"{before} {found.many} {place}", (argument,), literal(found.many), plural=True)

    def mass(self) -> Said:
        """``cutlery``, all of it."""
        mass = self.words.say("speech", "mass")
        return Said(f"the {mass}", (f"all({literal(mass)})",), literal(mass), forms={"many": mass})

    def everything(self) -> Said:
        """``all('things')``."""
        return set_said(self.words.say("sets", "things"), "things")

    def counted(self) -> Said:
        """``two of the blocks``, ``a block``."""
        found = self.kind()
        if self.words.chance(0.35):
            return self._one_of(found)
        number = self.rng.choice((2, 2, 2, 3, 3, 4, 5, 6))
        spoken = shown(self.words, number)
        text = self.words.say("sets", "count").format(many=found.many, n=spoken)
        if number == 2 and self.words.chance(0.1):
            text = (
                f"a couple of {found.many}" if self.words.chance(0.5) else f"a pair of {found.many}"
            )
        return Said(
            text, (f"all({literal(found.many)}, count={number})",), literal(found.many), plural=True
        )

    def _one_of(self, found: ThingClass) -> Said:
        text = self.told("one_of", found)
        text = text.replace("a a", "an a") if text.startswith("a a") else text
        if text.startswith("a ") and article(found.one) == "an":
            text = f"an {text[2:]}"
        words = found.one if found.many not in text else found.many
        return Said(text, (f"all({literal(words)}, count=1)",), literal(words))
