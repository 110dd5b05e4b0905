"""Noun phrases: things, sets of things, places for them, in many ways of naming them."""

from app.domain.program import literal
from app.programs.knowledge.uses import phrases
from app.training.describing import described
from app.training.said import Said, one, tidy
from app.training.words import ThingClass, Words, article, plural

NUMBERS = ("one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")
INTO = {
    "in": ("in", "in", "in", "into", "into", "inside"),
    "on": ("on", "on", "on", "onto", "on top of"),
}
TOWARDS = {"in": ("into", "to", "over to"), "on": ("onto", "to", "over to")}


class Nouns:
    """Somebody who names things."""

    def __init__(self, words: Words, *, familiar: bool = False) -> None:
        self.words = words
        self.rng = words.rng
        self.familiar = familiar
        self.used: set[str] = set()

    # Bare nouns

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

    # One thing

    def thing(self) -> Said:
        """``the red mug``; the sketch's words are the same without the article."""
        draw = self.rng.random()
        if draw < 0.03:
            return self.odd(self.noun())
        if draw < 0.09:
            return self.related()
        if draw < 0.12:
            return self.superlative()
        if draw < 0.18:
            return self.indirect()
        return self._named(self.noun())

    def _named(self, noun: str) -> Said:
        draw = self.rng.random()
        if draw < 0.22:
            noun = f"{self.adjective()} {noun}"
        elif draw < 0.28:
            noun = f"{self.words.say('speech', 'marks')} {noun}"
        elif draw < 0.31:
            noun = f"{noun} {self.words.say('speech', 'sides')}"
        elif draw < 0.34:
            noun = f"{self.adjective()} {self.adjective()} {noun}"
        elif draw < 0.37:
            noun = f"{noun} {self.rng.choice(('1', '2', '3', '4', '7', '12', 'a', 'b', 'c'))}"
            return one(noun, noun)
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

    def related(self) -> Said:
        """``the cup next to the plate``."""
        noun, other = self.noun(), self.with_article(self.noun())
        key = self.rng.choice(list(self.words.lists["speech"]["relations"]))
        place = self.words.say("speech", "relations", key).format(r=other.text)
        return Said(
            f"the {noun} {place}", (f"one({literal(noun)}, {key}={other.words})",), literal(noun)
        )

    def superlative(self) -> Said:
        """``the cup that is furthest to the left``."""
        noun = self.noun()
        key = self.rng.choice(list(self.words.lists["speech"]["superlatives"]))
        how = self.words.say("speech", "superlatives", key)
        return Said(
            f"the {noun} {how}", (f"one({literal(noun)}, where={literal(key)})",), literal(noun)
        )

    def indirect(self) -> Said:
        """``something to write with``, ``the thing that tells the time``."""
        draw = self.rng.random()
        if draw < 0.5:
            return one(*described(self.rng, self.words.choose(phrases())))
        if draw < 0.75:
            task = self.words.say("speech", "tasks")
            head = self.rng.choice(
                ("something", "something", "a thing", "the thing", "an object", "one thing")
            )
            if not task.startswith(("to ", "for ")):
                head = "something"
            found = one(f"{head} {task}", f"thing {task}")
        else:
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
            found = one(f"{head} {fact}", f"thing {'' if drop else 'that '}{fact}")
        return found

    def many_things(self, count: int | None = None) -> Said:
        """``the knife, the fork and the spoon``."""
        number = count or self.rng.choice((2, 2, 2, 3, 3, 4))
        same = self.rng.random()
        items = [self.with_article(self.noun()) for _ in range(number)]
        if same < 0.25:
            noun = self.noun()
            colours = self.rng.sample(self.words.lists["words"]["colours"], number)
            items = [one(f"the {colour} {noun}", f"{colour} {noun}") for colour in colours]
            if same < 0.12:
                text = (
                    f"the {self.listed(colours)} {plural(noun) if self.words.chance(0.6) else noun}"
                )
                return self.joined(items, text)
        return self.joined(items, self.listed([each.text for each in items]))

    def joined(self, items: list[Said], text: str) -> Said:
        """Several things as one phrase."""
        found = tuple(argument for each in items for argument in each.arguments)
        words = (
            items[0].words if len(items) == 1 else f"[{', '.join(each.words for each in items)}]"
        )
        nor = f"not {text}"
        if len(items) == 2:
            nor = f"neither {items[0].text} nor {items[1].text}"
        return Said(text, found, words, plural=len(items) > 1, forms={"nor": nor})

    def listed(self, texts: list[str]) -> str:
        """``a, b and c``, and other ways."""
        if len(texts) == 1:
            return texts[0]
        last = self.rng.choice(
            (" and ", " and ", " and ", ", and ", " as well as ", " plus ", " & ", ", ")
        )
        if len(texts) == 2:
            last = self.rng.choice((" and ", " and ", " and ", " as well as ", " plus ", " & "))
        return ", ".join(texts[:-1]) + last + texts[-1]

    # Sets

    def kind(self) -> ThingClass:
        """A class or a noun with several of it, now and then with an adjective."""
        draw = self.rng.random()
        if draw < 0.5:
            found = self.rng.choice(self.words.classes())
        else:
            noun = self.noun()
            members = tuple(f"{self.adjective()} {noun}" for _ in range(4))
            found = ThingClass(plural(noun), noun, members)
        if draw < 0.12 or draw > 0.82:
            adjective = self.adjective()
            found = ThingClass(
                f"{adjective} {found.many}", f"{adjective} {found.one}", found.members
            )
        if found.many in self.used:
            return self.kind()
        self.used.add(found.many)
        return found

    def class_said(self, found: ThingClass) -> Said:
        """Its plain plural and the forms templates need."""
        forms = {"many": found.many, "one": found.one, "nmany": found.many, "mmany": found.many}
        return Said(
            f"the {found.many}", (f"all({literal(found.many)})",), literal(found.many), True, forms
        )

    def member(self, found: ThingClass) -> Said:
        """What is to be left out: one or two of its members."""
        lists = self.words.lists
        members = [each for each in found.members if each not in self.used]
        draw = self.rng.random()
        if draw < 0.12:
            adjective = self.adjective()
            phrase = f"{adjective} {found.one}"
            text = self.rng.choice((f"the {adjective} one", f"the {phrase}"))
            return one(text, phrase)
        if draw < 0.2:
            adjective = self.adjective()
            phrase = f"{adjective} {found.many}"
            text = self.rng.choice((f"the {adjective} ones", f"{adjective} ones", f"the {phrase}"))
            return Said(text, (f"all({literal(phrase)})",), literal(phrase), plural=True)
        count = self.rng.choice((1, 1, 1, 1, 2, 2, 3)) if len(members) > 4 else 1
        chosen = [self.words.choose(members or lists["nouns"]) for _ in range(1)]
        while len(chosen) < count:
            more = self.rng.choice(members)
            if more not in chosen:
                chosen.append(more)
        self.used.update(chosen)
        items = [self.with_article(each) for each in chosen]
        return self.joined(items, self.listed([each.text for each in items]))

    def all_of(self) -> Said:
        """A whole set, by class, property, material or use."""
        draw = self.rng.random()
        if draw < 0.08:
            return self.everything()
        if draw < 0.14:
            mass = self.words.say("speech", "mass")
            return self._set(self.words.say("sets", "mass").format(m=mass), mass)
        if draw < 0.17:
            belong = self.words.say("speech", "belong")
            return self._set(
                self.words.say("sets", "belong").format(b=belong), f"things that belong {belong}"
            )
        if draw < 0.24:
            adjective = self.adjective()
            text = self.words.say("sets", "adjective_things").format(adj=adjective)
            return self._set(text, f"{adjective} things")
        if draw < 0.30:
            material = self.words.say("speech", "materials")
            if self.words.chance(0.3):
                found = self.kind()
                text = self.words.say("sets", "class_made_of").format(
                    many=found.many, one=found.one, material=material
                )
                return self._set(text, f"{found.many} made of {material}")
            text = self.words.say("sets", "made_of").format(material=material)
            return self._set(text, f"things made of {material}")
        if draw < 0.37:
            return self.useful()
        return self.class_set()

    def useful(self) -> Said:
        """``everything you can write with``."""
        use = self.words.say("speech", "uses")
        shown = f"can {use}" if self.words.chance(0.5) else use
        text = self.words.say("sets", "use").format(use=shown)
        text = text.replace("can can", "can").replace("could can", "could").replace("'d can", "'d")
        able = "" if use.startswith("need") else "can "
        return self._set(text, f"things you {able}{use}")

    def class_set(self) -> Said:
        """All of a class or of a noun."""
        found, draw = self.kind(), self.rng.random()
        shown = {"many": found.many, "one": found.one}
        if draw < 0.08:
            return self._set(self.words.say("sets", "being").format(**shown), found.many)
        if draw < 0.16:
            adjective = self.adjective()
            text = self.words.say("sets", "class_adjective").format(**shown, adj=adjective)
            return self._set(text, f"{adjective} {found.many}")
        if draw < 0.21:
            return self._related_set(found)
        return self._set(self.words.say("sets", "all").format(**shown), found.many)

    def _related_set(self, found: ThingClass) -> Said:
        key = self.rng.choice(list(self.words.lists["speech"]["relations"]))
        other = self.with_article(self.noun())
        place = self.words.say("speech", "relations", key).format(r=other.text)
        if "closest" in place or "nearest" in place:
            place = f"near {other.text}"
            key = "near"
        text = (
            f"{self.rng.choice(('all the', 'the', 'all', 'every one of the'))} {found.many} {place}"
        )
        return Said(
            text,
            (f"all({literal(found.many)}, {key}={other.words})",),
            literal(found.many),
            plural=True,
        )

    def _set(self, text: str, phrase: str) -> Said:
        single = text.split()[0] in {
            "every",
            "each",
            "any",
            "everything",
            "anything",
            "whatever",
            "what",
        }
        single = single and not text.startswith(("each of", "every one of"))
        return Said(text, (f"all({literal(phrase)})",), literal(phrase), plural=not single)

    def mass_named(self) -> Said:
        """``cutlery``, all of it."""
        mass = self.words.say("speech", "mass")
        return Said(f"the {mass}", (f"all({literal(mass)})",), literal(mass), forms={"many": mass})

    def everything(self) -> Said:
        """``all('things')``."""
        return self._set(self.words.say("sets", "things"), "things")

    def all_but(self) -> Said:
        """A set with something left out of it."""
        draw = self.rng.random()
        if draw < 0.14:
            found, adjective = self.kind(), self.adjective()
            text = self.words.say("sets", "negated").format(
                many=found.many, one=found.one, adj=adjective
            )
            return self._but(text, found.many, literal(f"{adjective} {found.many}"))
        if draw < 0.22:
            adjective = self.adjective()
            text = self.words.say("sets", "negated_things").format(adj=adjective)
            return self._but(text, "things", literal(f"{adjective} things"))
        if draw < 0.34:
            found = self.kind()
            text = self.words.say("sets", "negated_class").format(many=found.many, one=found.one)
            return self._but(text, "things", literal(found.many))
        if draw < 0.56:
            whole, left = self.everything(), self.left_out()
            return self._but(self._without(whole, left), "things", left.words)
        found = self.kind()
        whole = self._set(
            self.words.say("sets", "all").format(many=found.many, one=found.one), found.many
        )
        left = self.member(found)
        return self._but(self._without(whole, left), found.many, left.words, plural=whole.plural)

    def _without(self, whole: Said, left: Said) -> str:
        template = self.words.say("sets", "except")
        if "{e.isnt}" in template or "aren't {e}" in template:
            template = "{s} except {e}"
        return tidy(template.format(s=whole.text, e=left.text))

    def _but(self, text: str, phrase: str, left: str, *, plural: bool | None = None) -> Said:
        said = self._set(text, phrase)
        return Said(
            text,
            (f"all({literal(phrase)}, but={left})",),
            "",
            said.plural if plural is None else plural,
        )

    def left_out(self) -> Said:
        """Things or a class that stay where they are."""
        if self.words.chance(0.25):
            found = self.kind()
            return Said(
                f"the {found.many}",
                (f"all({literal(found.many)})",),
                literal(found.many),
                plural=True,
            )
        items = [
            self.with_article(self._adjective_noun())
            for _ in range(self.rng.choice((1, 1, 1, 2, 2, 3)))
        ]
        return self.joined(items, self.listed([each.text for each in items]))

    def _adjective_noun(self) -> str:
        noun = self.noun()
        return f"{self.adjective()} {noun}" if self.words.chance(0.25) else noun

    def counted(self) -> Said:
        """``two of the blocks``, ``a block``."""
        found = self.kind()
        if self.words.chance(0.35):
            text = self.words.say("sets", "one_of").format(many=found.many, one=found.one)
            text = text.replace("a a", "an a") if text.startswith("a a") else text
            if text.startswith("a ") and article(found.one) == "an":
                text = f"an {text[2:]}"
            words = found.one if found.many not in text else found.many
            return Said(text, (f"all({literal(words)}, count=1)",), literal(words))
        number = self.rng.choice((2, 2, 2, 3, 3, 4, 5, 6))
        shown = NUMBERS[number - 1] if self.words.chance(0.8) else str(number)
        text = self.words.say("sets", "count").format(many=found.many, n=shown)
        if number == 2 and self.words.chance(0.1):
            text = (
                f"a couple of {found.many}" if self.words.chance(0.5) else f"a pair of {found.many}"
            )
        return Said(
            text, (f"all({literal(found.many)}, count={number})",), literal(found.many), plural=True
        )

    def number(self) -> Said:
        """A number on its own."""
        number = self.rng.choice((1, 2, 2, 2, 3, 3, 4, 5))
        shown = NUMBERS[number - 1] if self.words.chance(0.8) else str(number)
        return Said(shown, (), forms={"digit": str(number)}, plural=number > 1)

    def movable(self) -> Said:
        """Anything that can be asked to be moved."""
        draw = self.rng.random()
        if draw < 0.50:
            return self.thing()
        if draw < 0.61:
            return self.many_things()
        if draw < 0.80:
            return self.all_of()
        return self.all_but() if draw < 0.91 else self.counted()

    # Where things go

    def holder(self) -> Said:
        """``the bowl``, with its preposition."""
        lists = self.words.lists
        kind = self.rng.choice(("in", "in", "in", "on", "on"))
        extra = "containers_extra" if kind == "in" else "surfaces_extra"
        noun = self.words.choose([*lists["words"]["containers"][kind], *lists["speech"][extra]])
        if noun in self.used:
            return self.holder()
        self.used.add(noun)
        draw = self.rng.random()
        if draw < 0.03:
            said = self.odd(noun)
        elif draw < 0.06:
            found = self.with_article(self.noun())
            key = self.rng.choice(("left_of", "right_of", "near", "behind", "in_front_of"))
            place = self.words.say("speech", "relations", key).format(r=found.text)
            said = Said(f"the {noun} {place}", (f"one({literal(noun)}, {key}={found.words})",))
        elif draw < 0.08:
            key = self.rng.choice(list(lists["speech"]["superlatives"]))
            how = self.words.say("speech", "superlatives", key)
            said = Said(f"the {noun} {how}", (f"one({literal(noun)}, where={literal(key)})",))
        else:
            said = self.holder_named(noun)
        return self.placed(said, kind)

    def box(self) -> Said:
        """A container by its plain name."""
        while True:
            found = self.holder()
            if found.kind == "in" and found.words:
                return found

    def holder_named(self, noun: str) -> Said:
        """With a colour, a side or nothing, and an article."""
        draw = self.rng.random()
        if draw < 0.14:
            noun = f"{self.adjective()} {noun}"
        elif draw < 0.24:
            noun = f"{self.words.say('speech', 'marks')} {noun}"
        elif draw < 0.28:
            noun = f"{noun} {self.words.say('speech', 'sides')}"
        elif draw < 0.33:
            noun = f"{noun} {self.rng.choice(('1', '2', '3', '4', 'a', 'b'))}"
            return one(noun, noun)
        elif draw < 0.37:
            text = f"{self.rng.choice(('a', 'any', 'one of the', 'some'))} {noun}"
            text = text if not text.startswith("one of") else f"one of the {plural(noun)}"
            words = plural(noun) if text.startswith("one of") else noun
            if text.startswith("a ") and article(noun) == "an":
                text = f"an {noun}"
            return Said(text, (f"all({literal(words)}, count=1)",))
        return self.with_article(noun)

    def placed(self, said: Said, kind: str) -> Said:
        """With the forms that say where."""
        choose = self.rng.choice
        forms = {
            "in": f"{choose(INTO[kind])} {said.text}",
            "to": f"{choose(TOWARDS[kind])} {said.text}",
            "to2": f"to {said.text}",
            "inin": kind,
            "space": f"{kind} {said.text}",
            "there": choose(("in it", "inside", "inside it", "there", "into it"))
            if kind == "in"
            else choose(("on it", "on top", "onto it", "there", "on top of it")),
        }
        return Said(said.text, said.arguments, said.words, forms={**said.forms, **forms}, kind=kind)
