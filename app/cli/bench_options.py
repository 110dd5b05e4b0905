"""Options that the measurements of ``progprompt bench`` share."""

import functools
from collections.abc import Callable
from typing import Literal

import click

from app.domain.perception import Perception

Source = Literal["cameras", "privileged"]
SEED = click.option("--seed", default=0, show_default=True, type=click.IntRange(min=0))
AS_JSON = click.option(
    "--json", "as_json", is_flag=True, help="One JSON object on standard output."
)
PERCEPTION = click.option(
    "--perception",
    "source",
    default="cameras",
    show_default=True,
    type=click.Choice(["cameras", "privileged"]),
    help="Depth cameras alone, or the simulator's geometry.",
)


def seeing(function: Callable[..., None]) -> Callable[..., None]:
    """The options that say how the robot sees, gathered into one argument ``perception``."""

    @PERCEPTION
    @click.option("--noise", default=2.0, show_default=True, type=click.FloatRange(0, 20),
                  help="Standard deviation of a camera's depth in millimetres.")  # fmt: skip
    @click.option("--confusion", default=0.0, show_default=True, type=click.FloatRange(0, 1),
                  help="Share of objects that are taken for another one.")  # fmt: skip
    @functools.wraps(function)
    def wrapped(source: Source, noise: float, confusion: float, **rest: object) -> None:
        perception = Perception(source=source, noise=noise / 1000, confusion=confusion)
        function(**rest, perception=perception)

    return wrapped
