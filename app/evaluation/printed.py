"""Printed: the figures of the paper's tables, to stand beside ours."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Printed:
    """A mean as the paper prints it, with its spread over runs where it has one."""

    mean: float
    std: float | None = None

    def __str__(self) -> str:
        told = f"{self.mean:.2f}".removeprefix("0") if self.mean < 1 else f"{self.mean:g}"
        return told if self.std is None else f"{told} ± {self.std:.2f}".replace("± 0", "± ")


P = Printed

MAIN = {
    "ProgPrompt, largest model": (P(0.40, 0.11), P(0.90, 0.05), P(0.72, 0.09)),
    "ProgPrompt, smaller model": (P(0.22, 0.04), P(0.60, 0.04), P(0.46, 0.04)),
    "ProgPrompt": (P(0.34, 0.08), P(0.84, 0.01), P(0.65, 0.05)),
    "ProgPrompt, no feedback": (P(0.28, 0.04), P(0.82, 0.01), P(0.56, 0.02)),
    "ProgPrompt, no comments": (P(0.30, 0.00), P(0.65, 0.01), P(0.58, 0.02)),
    "ProgPrompt, neither": (P(0.18, 0.04), P(0.68, 0.01), P(0.42, 0.02)),
    "LangPrompt": (P(0.00), P(0.36, 0.00), P(0.42, 0.02)),
    "Huang et al.": (P(0.00), P(0.45, 0.03), P(0.21, 0.03)),
}
"""SR, Exec and GCR by method; Codex, Davinci and then GPT3."""

TASKS = {
    "watch tv": (P(0.20, 0.40), P(0.42, 0.13), P(0.63, 0.28)),
    "turn off light": (P(0.40, 0.49), P(1, 0.00), P(0.65, 0.30)),
    "brush teeth": (P(0.80, 0.40), P(0.74, 0.09), P(0.87, 0.26)),
    "throw away apple": (P(1, 0.00), P(1, 0.00), P(1, 0.00)),
    "make toast": (P(0, 0.00), P(1, 0.00), P(0.54, 0.33)),
    "eat chips on the sofa": (P(0, 0.00), P(0.40, 0.00), P(0.53, 0.09)),
    "put salmon in the fridge": (P(1, 0.00), P(1, 0.00), P(1, 0.00)),
    "wash the plate": (P(0, 0.00), P(0.97, 0.04), P(0.48, 0.11)),
    "bring coffeepot and cupcake to the coffee table": (P(0, 0.00), P(1, 0.00), P(0.52, 0.14)),
    "microwave salmon": (P(0, 0.00), P(0.76, 0.13), P(0.24, 0.09)),
}
"""SR, Exec and GCR of ProgPrompt on GPT3 in Env-0."""

LENGTHS = {
    "0-5": (P(0.20, 0.40), P(0.61, 0.29), P(0.60, 0.25)),
    "6-10": (P(0.60, 0.50), P(0.95, 0.11), P(0.79, 0.29)),
    "11-18": (P(0, 0.00), P(0.87, 0.14), P(0.36, 0.16)),
}
"""The same by length of the ground truth; the rows above make .56 of the .60 printed here."""

PLACES = {
    "env0": (P(0.34, 0.08), P(0.84, 0.01), P(0.65, 0.05)),
    "env1": (P(0.56, 0.08), P(0.85, 0.02), P(0.81, 0.07)),
    "env2": (P(0.56, 0.05), P(0.85, 0.03), P(0.72, 0.09)),
    "average": (P(0.48, 0.13), P(0.85, 0.02), P(0.73, 0.10)),
}
"""SR, Exec and GCR by environment."""

ROBOT = {
    ("put the banana in the bowl", 0): (P(1), P(1), P(1)),
    ("put the banana in the bowl", 4): (P(1), P(1), P(1)),
    ("put the pear on the plate", 0): (P(1), P(1), P(1)),
    ("put the pear on the plate", 4): (P(1), P(1), P(1)),
    ("put the banana on the plate and the pear in the bowl", 0): (P(1), P(1), P(1)),
    ("put the banana on the plate and the pear in the bowl", 3): (P(1), P(1), P(1)),
    ("sort the fruits on the plate and the bottles in the box", 0): (P(0), P(1), P(0.67)),
    ("sort the fruits on the plate and the bottles in the box", 1): (P(1), P(1), P(1)),
    ("sort the fruits on the plate and the bottles in the box", 2): (P(0), P(0), P(0.67)),
}
"""SR, Plan SR and GCR of the physical robot, by task and number of distractors."""
