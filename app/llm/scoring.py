"""Scoring: log-probabilities of candidates from those of single tokens, asked as rarely as can be.

The candidates' tokens form a tree. Only where it branches the model is asked for its next token;
between two branches there is nothing to choose, and the tokens there count as certain.
"""

from collections.abc import Callable, Mapping, Sequence

Tokens = tuple[int, ...]
NextToken = Callable[[Tokens], Mapping[int, float]]
"""The tokens so far → log-probability of the likeliest next tokens [nat]."""


def score_sequences(sequences: Sequence[Tokens], next_token: NextToken) -> tuple[float, ...]:
    """The log-probability of each sequence [nat], in their order.

    A token that is not among those the model tells of gets the smallest of their values, which is
    more than its own. A sequence that another one continues ends where the other goes on.
    """
    scores = [0.0] * len(sequences)
    waiting: list[tuple[int, list[int]]] = [(0, list(range(len(sequences))))]
    while waiting:
        depth, members = waiting.pop()
        if len(members) < 2:
            continue
        depth = _branch(sequences, members, depth)
        children: dict[int, list[int]] = {}
        for member in members:
            if len(sequences[member]) > depth:
                children.setdefault(sequences[member][depth], []).append(member)
        if not children:
            continue
        known = next_token(sequences[members[0]][:depth])
        floor = min(known.values(), default=0.0)
        for token, those in children.items():
            for member in those:
                scores[member] += known.get(token, floor)
            waiting.append((depth + 1, those))
    return tuple(scores)


def _branch(sequences: Sequence[Tokens], members: Sequence[int], depth: int) -> int:
    """How far the members go on alike, from ``depth`` on; where one ends the others branch off."""
    first = min((sequences[member] for member in members), key=len)
    for position in range(depth, len(first)):
        if any(sequences[member][position] != first[position] for member in members):
            return position
    return len(first)
