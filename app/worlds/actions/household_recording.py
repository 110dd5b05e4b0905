"""Recorded lines of a household, ``[putin] <apple> (438) <fridge> (305)``, carried out again."""

import re
from collections.abc import Iterable

from app.domain.errors import ActionFailure
from app.worlds.actions.household import actions
from app.worlds.simulators.household_agent import HouseholdAgent
from app.worlds.simulators.household_graph import HouseholdGraph
from app.worlds.simulators.household_states import derive

_LINE = re.compile(r"\[(\w+)\]|\((\d+)\)")


def replay(graph: HouseholdGraph, lines: Iterable[str], *, official: bool = True) -> int:
    """Carry out recorded lines; how many could be.

    The instances are those of the lines; a line that cannot be carried out changes nothing.
    """
    agent = HouseholdAgent(graph, official=official)
    done = 0
    derive(graph, official=official)
    for line in lines:
        verb, *ids = (verb or identifier for verb, identifier in _LINE.findall(line))
        chosen = [graph.nodes[int(each)] for each in ids]
        try:
            actions[verb].check(agent, *chosen)
        except ActionFailure:
            continue
        actions[verb].apply(agent, *chosen)
        derive(graph, official=official)
        done += 1
    return done
