"""Tasks for the other verbs of an import line, alone and around a put."""

from app.training.phrases import Speaker
from app.training.scenes import Setting
from app.training.tasks import Answered, answer, put
from app.training.verbs import OTHERS, Verbs


def make(say: Speaker, scene: Setting, verbs: Verbs) -> Answered | None:
    """One of them, or opening and closing around a put."""
    if "open" in verbs.others and say.rng.random() < 0.6:
        return _around_put(say, scene, closing="close" in verbs.others)
    verb = say.rng.choice(verbs.others)
    count, frames = OTHERS[verb]
    items = say.rng.sample(scene.order, count)
    texts = [say.the(item).text for item in items]
    sentence = say.choose(frames).format(x=texts[0], y=texts[-1])
    steps = [(verb, *(item.name for item in items))]
    if say.rng.random() < 0.4:
        item, holder = say.rng.choice(scene.things), say.rng.choice(scene.holders)
        sentence = f"{sentence.rstrip('?')}, then {say.move(say.the(item), holder)}"
        return answer(say.dress(sentence), [*steps, *put([item], holder)])
    return answer(sentence, steps)


def _around_put(say: Speaker, scene: Setting, *, closing: bool) -> Answered:
    item, holder = say.rng.choice(scene.things), say.rng.choice(scene.holders)
    the, at = say.the(item).text, say.the(holder).text
    steps = [("open", holder.name), *put([item], holder)]
    sentence = say.choose(
        (
            f"open {at} and put {the} {holder.preposition} it",
            f"open {at}, then put {the} inside",
            f"put {the} {holder.preposition} {at}, but open it first",
            f"open {at}. {the} goes {holder.preposition} it",
        )
    )
    if closing and say.rng.random() < 0.6:
        steps.append(("close", holder.name))
        sentence += say.choose(
            (
                " and close it",
                ", then close it again",
                ". close it afterwards",
                " and shut it after that",
            )
        )
    return answer(say.dress(sentence), steps)
