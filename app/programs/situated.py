"""Task → the short prompt of the adapted models: import line, described objects, the sentence.

The adapters in ``static/adapters`` were trained on exactly this text, so it may not change without
training anew. There are no example programs. The model goes on with the function's body, four
spaces in, and ends it with an empty line: the grammar of ``app.llm.grammar.program_grammar`` (with
comments) fits, and so does the stop string ``STOP``. A set of objects is stated in a comment before
its calls; a program of only a comment and ``pass`` declines, and the comment is the reason.
"""

import re
from collections.abc import Callable, Mapping, Sequence

from app.domain.planner import Task
from app.domain.program import literal
from app.domain.scene import SceneObject
from app.programs.printer import INDENT, import_line

STOP = "\n\n"
HEAD = "def task():\n"
ORDER = ("color", "material", "size", "position", "category")
COLOURS = {
    "red": (255, 0, 0),
    "blue": (0, 0, 255),
    "green": (0, 128, 0),
    "yellow": (255, 255, 0),
    "white": (255, 255, 255),
    "black": (0, 0, 0),
    "orange": (255, 165, 0),
    "purple": (128, 0, 128),
    "pink": (255, 192, 203),
    "brown": (139, 69, 19),
    "grey": (128, 128, 128),
    "turquoise": (64, 224, 208),
    "beige": (245, 245, 220),
}
_SPOKEN = {
    "color": re.compile(
        rf"\b(colou?r\w*|gray|silver|gold\w*|matching|{'|'.join(COLOURS)})\b", re.I
    ),
    "size": re.compile(
        r"\b(big\w*|large\w*|small\w*|little|tiny|tini\w+|medium\w*|size\w*)\b", re.I
    ),
    "material": re.compile(
        r"\b(made|material\w*|wood\w*|plastic|metal\w*|glass|paper|rubber|ceramic|leather|steel|cotton|cardboard|stone|iron|cloth)\b",
        re.I,
    ),
    "position": re.compile(r"\b(left\w*|right\w*|middle|cent(er|re|ral)|between|sides?)\b", re.I),
}


def write_situated_prompt(task: Task) -> str:
    """The whole prompt; what nobody speaks of (colours, sizes, sides) is left out."""
    sentence = task.instruction.text
    return situated_prompt(
        import_line(task.actions), describe(task.scene.objects, sentence), sentence
    )


def situated_prompt(imports: str, described: Mapping[str, Mapping[str, str]], sentence: str) -> str:
    """The prompt from its parts: objects as a list, or with properties as a dict of texts."""
    return f"{situation(imports, described)}{question(sentence)}"


def situation(imports: str, described: Mapping[str, Mapping[str, str]]) -> str:
    """What is the same for every sentence about a scene."""
    texts = {name: " ".join(properties.values()) for name, properties in described.items()}
    if any(texts.values()):
        pairs = (f"{literal(name)}: {literal(text)}" for name, text in texts.items())
        shown = f"{{{', '.join(pairs)}}}"
    else:
        shown = f"[{', '.join(map(literal, texts))}]"
    return f'{imports}\nobjects = {shown}\n{HEAD}{INDENT}"""'


def question(sentence: str) -> str:
    """The sentence as the function's docstring, closed."""
    return f"{' '.join(sentence.split())}".replace('"', "'") + '"""\n'


def describe(objects: Sequence[SceneObject], sentence: str) -> dict[str, dict[str, str]]:
    """The properties worth telling of each object, as words, by its name."""
    sides = _ranked(objects, _leftness)
    sizes = _ranked(objects, _volume)
    described: dict[str, dict[str, str]] = {}
    for item in objects:
        told: dict[str, str] = {}
        if item.colour:
            told["color"] = colour_word(item.colour)
        if item.name in sizes:
            told["size"] = ("small", "medium", "large")[sizes[item.name]]
        if item.name in sides:
            told["position"] = ("right", "center", "left")[sides[item.name]]
        if item.category and item.category not in item.name:
            told["category"] = item.category
        described[item.name] = told
    return spoken_of(described, sentence)


def spoken_of(
    described: Mapping[str, Mapping[str, str]], sentence: str
) -> dict[str, dict[str, str]]:
    """Without the properties that the sentence does not touch on (a category always stays)."""
    told = {name for name, pattern in _SPOKEN.items() if pattern.search(sentence)} | {"category"}
    return {
        name: {key: properties[key] for key in ORDER if key in properties and key in told}
        for name, properties in described.items()
    }


def colour_word(colour: str) -> str:
    """The nearest everyday word for ``#rrggbb``; a name stays as it is."""
    if not re.fullmatch(r"#[0-9a-fA-F]{6}", colour):
        return colour.lower()
    rgb = [int(colour[i : i + 2], 16) for i in (1, 3, 5)]
    return min(
        COLOURS,
        key=lambda word: sum((a - b) ** 2 for a, b in zip(rgb, COLOURS[word], strict=True)),
    )


def _leftness(item: SceneObject) -> float | None:
    return item.position[1] if item.position else None


def _volume(item: SceneObject) -> float | None:
    return item.size[0] * item.size[1] * item.size[2] if item.size else None


def _ranked(
    objects: Sequence[SceneObject], measure: Callable[[SceneObject], float | None]
) -> dict[str, int]:
    """Least, between or most of the look-alikes (0, 1, 2): those whose names end alike."""
    groups: dict[str, list[tuple[float, str]]] = {}
    for item in objects:
        value = measure(item)
        words = [word for word in item.name.split() if not word.isdigit()]
        if value is not None and words:
            groups.setdefault(words[-1], []).append((value, item.name))
    ranks: dict[str, int] = {}
    for group in groups.values():
        if len(group) > 1:
            for place, (_, name) in enumerate(sorted(group)):
                ranks[name] = 0 if place == 0 else 2 if place == len(group) - 1 else 1
    return ranks
