"""The import line of a made-up robot: how its verb for putting is called, and what else it can do."""

from dataclasses import dataclass
from random import Random

from app.domain.action import ActionSignature, Parameter
from app.programs.printer import import_line
from app.training.things import Split

PUTS = {
    "train": (
        *(("pick_and_place", "obj, target", False), ("put_in", "obj, container", False)),
        *(("move_to", "item, place", False), ("transfer", "thing, destination", False)),
        *(("stow", "obj, where", False), ("load", "container, obj", True)),
        *(("set_down", "obj1, obj2", False), ("fill_with", "container, item", True)),
        *(("carry", "what, to", False), ("zorp", "obj1, obj2", False)),
    ),
    "held": (
        *(("relocate", "object, goal", False), ("receive", "container, obj", True)),
        *(("deposit", "obj, spot", False), ("blick", "obj1, obj2", False)),
    ),
}
OTHERS = {
    "open": (1, ("open {x}", "please open {x}", "i want {x} open", "could you open {x}?")),
    "close": (1, ("close {x}", "shut {x}", "{x} should be closed", "please close {x}")),
    "push": (1, ("push {x}", "give {x} a push", "push {x} away")),
    "wipe": (1, ("wipe {x}", "wipe {x} clean", "give {x} a wipe")),
    "pour": (2, ("pour {x} into {y}", "empty {x} into {y}", "pour the contents of {x} into {y}")),
}


@dataclass(frozen=True, slots=True)
class Verbs:
    """What stands on the import line."""

    put: str
    parameters: str
    swapped: bool
    """The place comes first, then the thing."""
    others: tuple[str, ...] = ()

    @property
    def signatures(self) -> tuple[ActionSignature, ...]:
        """As a planner is told of them."""
        others = (
            (name, ("obj1", "obj2") if OTHERS[name][0] == 2 else ("obj",)) for name in self.others
        )
        verbs = ((self.put, self.parameters.split(", ")), *others)
        return tuple(
            ActionSignature(
                name=name, parameters=tuple(Parameter(name=each) for each in shown), meaning=""
            )
            for name, shown in verbs
        )

    @property
    def imports(self) -> str:
        """The import line."""
        return import_line(self.signatures)


USUAL = Verbs("grab_and_putin", "obj1, obj2", False)


def choose_verbs(rng: Random, split: Split) -> Verbs:
    """Mostly the usual one."""
    put = rng.choice(PUTS[split]) if rng.random() < 0.1 else None
    others = rng.sample(list(OTHERS), rng.choice((1, 2, 2, 3))) if rng.random() < 0.09 else []
    name, parameters, swapped = put or (USUAL.put, USUAL.parameters, USUAL.swapped)
    return Verbs(name, parameters, swapped, tuple(others))
