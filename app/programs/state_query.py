"""Condition + facts → the paper's state-check prompt, which a model answers with True or False.

Only facts that speak of the asserted objects are told, as the paper does; what holds for objects
nobody asked about would only distract.
"""

from collections.abc import Iterable

from app.domain.condition import Condition, Relation, relations
from app.programs.printer import in_words

MAX_FACTS = 60
"""Those that speak of most of the asserted objects."""
NOTHING = "nothing of it"
_WORKED = (
    (
        "'lid' is 'closed'; 'kettle' is 'switchon'; 'lid' on 'kettle'",
        "'kettle' is 'switchon'",
        True,
    ),
    ("'spoon' in 'drawer'; 'drawer' is 'closed'", "'drawer' is 'opened'", False),
    ("'close' to 'towel'; 'towel' on 'shelf'", "'close' to 'towel'", True),
    ("'ladder' on 'floor'", "'close' to 'ladder'", False),
    ("'key' in 'hands'; 'close' to 'door'", "'key' in 'hands'", True),
    ("'jar' on 'tray'; 'olive' in 'jar'", "'jar' in 'hands'", False),
    ("'plum' in 'basket'; 'fig' in 'basket'", "'plum' in 'basket'", True),
    ("'coin' on 'desk'; 'pen' in 'purse'", "'coin' in 'purse'", False),
    ("'brush' in 'cup'; 'book' on 'shelf'", "'brush' on 'shelf'", False),
    ("'rug' on 'floor'", "'rug' on 'floor'", True),
    (NOTHING, "'vase' on 'easel'", False),
)
"""What is seen, what is asserted, and whether it holds."""


def write_state_query(condition: Condition, facts: Iterable[Relation]) -> str:
    """The prompt; the model is to go on with True or False.

    The text depends on nothing but the condition and the facts, whose order does not count.
    """
    worked = (f"{_question(seen, asserted)}{answer}\n" for seen, asserted, answer in _WORKED)
    seen = "; ".join(_seen(condition, facts)) or NOTHING
    return "\n".join((*worked, _question(seen, in_words(condition))))


def _question(seen: str, asserted: str) -> str:
    return f"You see: {seen}\nassert({asserted})\n"


def _seen(condition: Condition, facts: Iterable[Relation]) -> list[str]:
    """What is true of the objects the condition speaks of, in the paper's words, in order."""
    asked = {name for relation in relations(condition) for name in relation.arguments}
    told = [fact for fact in set(facts) if asked & set(fact.arguments)]
    in_order = sorted(told, key=lambda fact: (fact.name, fact.arguments))
    closest = sorted(in_order, key=lambda fact: len(asked & set(fact.arguments)), reverse=True)
    kept = set(closest[:MAX_FACTS])
    return [in_words(fact) for fact in in_order if fact in kept]
