"""Tasks that describe their object: by use, by class, by what sets it apart, by another word."""

from app.training.phrases import NounPhrase, Speaker
from app.training.scenes import Setting
from app.training.tasks import Answered, answer, put, stated, task_kind


@task_kind("by use")
def by_use(say: Speaker, scene: Setting) -> Answered | None:
    """The thing is told by what it is for."""
    names = {item.name: item for item in scene.things}
    found = [
        (use, names[noun])
        for use, nouns in say.vocabulary.words["uses"].items()
        for noun in nouns
        if noun in names and sum(other in names for other in nouns) == 1
    ]
    if not found:
        return None
    use, item = say.rng.choice(found)
    holder = say.rng.choice(scene.holders)
    sentence = say.move(NounPhrase(use), holder)
    if use.startswith("something ") and say.rng.random() < 0.5:
        sentence = say.choose(
            (
                f"i need {use}. put it {holder.preposition} {say.the(holder).text}",
                f"find {use} and leave it {holder.preposition} {say.the(holder).text}",
                f"is there {use}? it goes {holder.preposition} {say.the(holder).text}",
            )
        )
    return answer(say.dress(sentence), [stated(_bare(use), [item]), *put([item], holder)])


@task_kind("by class")
def by_class(say: Speaker, scene: Setting) -> Answered | None:
    """The thing is told by its class, of which it is the only one here."""
    alone = [
        item
        for item in scene.things
        if item.kind and sum(other.kind == item.kind for other in scene.things) == 1
    ]
    if not alone:
        return None
    item, holder = say.rng.choice(alone), say.rng.choice(scene.holders)
    one = say.vocabulary.classes[item.kind].one
    sentence = say.move(NounPhrase(f"the {one}"), holder)
    return answer(say.dress(sentence), [stated(one, [item]), *put([item], holder)])


@task_kind("by property")
def by_property(say: Speaker, scene: Setting) -> Answered | None:
    """One of several look-alikes, told by what sets it apart."""
    if not scene.marked or scene.marked == "position":
        return None
    items = [
        item
        for item in scene.things
        if sum(
            o.noun == item.noun and o.properties[scene.marked] == item.properties[scene.marked]
            for o in scene.things
        )
        == 1
        and sum(o.noun == item.noun for o in scene.things) > 1
    ]
    if not items:
        return None
    item, holder = say.rng.choice(items), say.rng.choice(scene.holders)
    value = item.properties[scene.marked]
    word = (
        say.rng.choice(say.vocabulary.words["size_words"][value])
        if scene.marked == "size"
        else value
    )
    what = f"{word} {item.noun}"
    steps = put([item], holder)
    if item.name != what:
        steps = [stated(what, [item]), *steps]
    return answer(say.dress(say.move(NounPhrase(f"the {what}"), holder)), steps)


@task_kind("other word")
def other_word(say: Speaker, scene: Setting) -> Answered | None:
    """The thing is called by a synonym or by part of its name."""
    item, holder = say.rng.choice(scene.things), say.rng.choice(scene.holders)
    words = [
        b if a == item.name else a
        for a, b in say.vocabulary.words["synonyms"]
        if item.name in (a, b)
    ]
    head = item.name.rpartition(" ")[2]
    others = [o for o in scene.order if o != item]
    if (
        not words
        and " " in item.name
        and not head.isdigit()
        and len(head) > 2
        and not any(head in o.name for o in others)
    ):
        words = [head]
    if not words or any(words[0] in o.name for o in others):
        return None
    return answer(
        say.dress(say.move(NounPhrase(f"the {words[0]}"), holder)),
        [stated(words[0], [item]), *put([item], holder)],
    )


def _bare(phrase: str) -> str:
    return phrase.removeprefix("something ").removeprefix("the ")
