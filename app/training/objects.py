"""What a verb is done to: a door, a device, a person, a direction, a text."""

from app.domain.program import literal
from app.training.nouns import Nouns
from app.training.said import Said, one


def verb_object(nouns: Nouns, kind: str) -> Said:
    """What a verb is done to."""
    if kind in ("thing", "holder"):
        return nouns.thing() if kind == "thing" else nouns.holder()
    if kind == "direction":
        word = nouns.words.say("speech", "directions")
        adverb = f"to the {word}" if word in ("left", "right", "side", "front", "back") else word
        return Said(word, (literal(word),), literal(word), forms={"adv": adverb})
    if kind == "person":
        person = nouns.words.say("speech", "persons")
        words = person.removeprefix("the ").removeprefix("my ")
        shown = (
            person.capitalize()
            if person in ("anna", "tom", "maria") and nouns.words.chance(0.5)
            else person
        )
        return one(shown, words)
    if kind == "text":
        text = nouns.words.say("speech", "persons_text")
        return one(text, text)
    if nouns.words.chance(0.15):
        return nouns.thing()
    noun = nouns.words.choose(nouns.words.lists["speech"][f"{kind}s"])
    if nouns.words.chance(0.12):
        noun = f"{nouns.names.adjective()} {noun}"
    return nouns.names.with_article(noun)
