"""Sentences that ask for nothing: a greeting, thanks, a question what can be done."""

import re
from collections.abc import Sequence

from app.domain.errors import TaskDeclined
from app.programs.sketches.qualities import is_container
from app.programs.sketches.things import Thing

_HELLO = (
    r"hi+|hello+|hey+|hiya|howdy|greetings|good (?:morning|afternoon|evening|day)|hallo|guten (?:tag|morgen|abend)|"
    r"moin|servus|bonjour|salut|hola|ciao|how are you(?: doing)?(?: today)?|what's up"
)
_THANKS = (
    r"thanks|thank you|thx|ty|cheers|danke(?: sch\u00f6n)?|vielen dank|merci|gracias|grazie|obrigad[oa]|bedankt|"
    r"(?:well|nicely) done|good (?:job|robot|work)|great|perfect|nice(?: one)?|super|bye|goodbye|see you"
)
_HELP = r"help|what can you do|what do you do|who are you|how does this work|what can i (?:say|ask)"
_MORE = r"(?:[\s,]+(?:there|robot|you|so much|very much|a lot|again|everyone|all|mate|friend|for that|beaucoup))*"
_PATTERNS = {
    "You are welcome.": re.compile(rf"(?:(?:{_THANKS}){_MORE}[\s,.!?]*)+", re.I),
    "Hello.": re.compile(rf"(?:(?:{_HELLO}|{_THANKS}){_MORE}[\s,.!?]*)+", re.I),
    "I turn a sentence into a plan for the robot.": re.compile(
        rf"(?:(?:{_HELLO}){_MORE}[\s,.!?]*)?(?:{_HELP}){_MORE}[\s.!?]*", re.I
    ),
}


def answer_greeting(sentence: str, things: Sequence[Thing]) -> None:
    """Let a sentence pass that asks for something.

    Raises:
        TaskDeclined: it asks for nothing; the reason is a kind answer.
    """
    for answer, pattern in _PATTERNS.items():
        if pattern.fullmatch(sentence.strip()):
            asks = f"Say what should go where{_example(things)}."
            raise TaskDeclined(f"{answer} {asks}", kind="unsure", question="What should be done?")


def _example(things: Sequence[Thing]) -> str:
    place = next((thing for thing in things if is_container(thing)), None)
    thing = next((thing for thing in things if not is_container(thing)), None)
    return f", like \u201cput the {thing.name} in the {place.name}\u201d" if thing and place else ""
