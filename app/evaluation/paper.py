"""The paper: its four tables and the sweep over examples, ours and the printed figures side by side."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from app.domain.planner import PlannerOptions
from app.evaluation.attempt import Unit
from app.evaluation.charts import lines
from app.evaluation.household_data import plain_name
from app.evaluation.metrics import BY_NAME, figure, grouped, length_class
from app.evaluation.printed import LENGTHS, MAIN, PLACES, ROBOT, TASKS, Printed
from app.evaluation.results import Cell, Result
from app.evaluation.suites import Suite, find_suite
from app.evaluation.tables import Entry, Table
from app.worlds import worlds

TRIPLE = ("sr", "exec", "gcr")
"""The order of the paper's columns."""
EXAMPLES = range(1, 8)
FULL = "ProgPrompt"
ROBOT_CELL = "ProgPrompt, robot"
OURS = "best of ours"
MAX_TOKENS = 300
"""Of one completion: more than the longest ground truth takes, so that an endless plan costs less."""
NOTE = (
    "Temperature 0: every run would be the same, so each attempt is made once and no spread over "
    "runs is told; the intervals are over tasks. With a temperature the runs differ, as in the paper."
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Plan:
    """What is run for the paper's tables."""

    household: Suite
    """The paper's tasks, or ours in their stead."""
    first_home: str = "env0"
    models: tuple[str, ...] = ("default", "small")
    """Backbones of the full method; the first one carries all the rest."""
    runs: int = 1
    temperature: float = 0.0
    layouts: int = 1
    """Of every robot task, in physics."""
    quick: bool = False
    """A few tasks and methods only."""
    own: bool = False
    """The tasks are ours, to which no printed figure belongs."""


def methods(plan: Plan) -> tuple[Cell, ...]:
    """The rows of the main table; the paper's come first, then ours."""
    base = PlannerOptions(
        name="progprompt",
        model=plan.models[0],
        feedback=True,
        affordances=False,
        temperature=plan.temperature,
        max_tokens=MAX_TOKENS,
    )
    bare = replace(base, feedback=False)
    rows = [
        Cell(name=FULL, options=base),
        Cell(name=f"{FULL}, no feedback", options=bare),
        Cell(name=f"{FULL}, no comments", options=replace(base, comments=False)),
        Cell(name=f"{FULL}, neither", options=replace(bare, comments=False)),
        Cell(name="LangPrompt", options=replace(base, name="langprompt")),
        Cell(name="Huang et al.", options=replace(base, name="zero_shot")),
        Cell(name="SayCan", options=replace(base, name="saycan")),
    ]
    rows += [
        Cell(name=f"{FULL} on {model}", options=replace(base, model=model))
        for model in plan.models[1:]
    ]
    rows += [
        Cell(name=f"{FULL}, functions without names", options=replace(base, cue=False)),
        Cell(name=f"{FULL}, unconstrained", options=replace(base, constrained=False)),
        Cell(name=f"{FULL}, affordances", options=replace(base, affordances=True)),
        Cell(name=f"{FULL}, similar examples", options=replace(base, choice="similar")),
        Cell(name=f"{FULL}, repair", options=replace(base, repair=True)),
        Cell(name=f"{FULL}, repair and replanning", options=_helped(base)),
    ]
    best = worlds["household"].planner
    if best != "progprompt":
        alone = replace(base, name=best, model="default", affordances=True)
        rows += [
            Cell(name=f"{best}, unconstrained", options=replace(alone, constrained=False)),
            Cell(name=f"{best}, no repair", options=replace(alone, repair=False)),
            Cell(name=OURS, options=replace(_helped(alone), choice="fixed")),
        ]
    return tuple(rows)


def _helped(options: PlannerOptions) -> PlannerOptions:
    return replace(options, repair=True, max_replans=2, choice="similar", affordances=True)


def units(plan: Plan) -> list[Unit]:
    """All attempts, the most important first: what is cut off by the time is at the end."""
    first = [task for task in plan.household.tasks if task.environment == plan.first_home]
    others = [task for task in plan.household.tasks if task.environment != plan.first_home]
    rows = methods(plan)
    sweep = _sweep(plan)
    if plan.quick:
        first, others, rows, sweep = first[:3], others[:2], (*rows[:2], *rows[-1:]), sweep[:2]
    wanted = [(rows[:1], first, False), (_robot(plan), _robot_tasks(plan), True)]
    wanted += [((row,), first, False) for row in rows[1:]]
    wanted += [((*rows[:1], *rows[-1:]), others, False)]
    wanted += [((cell,), first, False) for cell in sweep]
    return [
        Unit(task=task, cell=cell, run=run, physics=physics)
        for cells, tasks, physics in wanted
        for cell in cells
        for run in range(plan.layouts if physics else plan.runs)
        for task in tasks
    ]


def _robot(plan: Plan) -> tuple[Cell, ...]:
    """Comments and no feedback, as on the paper's robot."""
    options = PlannerOptions(
        name="progprompt", model=plan.models[0], temperature=plan.temperature, feedback=False
    )
    return (Cell(name=ROBOT_CELL, options=options),)


def _robot_tasks(plan: Plan) -> Sequence:
    tasks = find_suite("robot-tasks").tasks
    shown = [task for task in tasks if (task.category, len(task.distractors)) in ROBOT]
    return shown[:3] if plan.quick else shown


def _sweep(plan: Plan) -> list[Cell]:
    full = methods(plan)[0]
    return [
        full
        if count == full.options.examples
        else Cell(
            name=f"{FULL}, {count} example{'' if count == 1 else 's'}",
            options=replace(full.options, examples=count),
        )
        for count in EXAMPLES
    ]


def paper_tables(plan: Plan, results: Sequence[Result]) -> list[Table]:
    """The paper's tables, as far as there are results."""
    home = [r for r in results if r.environment == plan.first_home and r.cell != ROBOT_CELL]
    found = [
        _main(plan, home),
        _tasks(plan, [result for result in home if result.cell == FULL]),
        _places(plan, [result for result in results if result.cell == FULL]),
        _places_of_ours(plan, results),
        _robot_table([result for result in results if result.cell == ROBOT_CELL]),
        _sweep_table(plan, home),
    ]
    return [table for table in found if table.rows]


def paper_charts(plan: Plan, results: Sequence[Result]) -> list[tuple[str, str]]:
    """The sweep over the number of examples."""
    home = [result for result in results if result.environment == plan.first_home]
    series = []
    for name in ("sr", "gcr", "exec"):
        points = []
        for count, cell in zip(EXAMPLES, _sweep(plan), strict=True):
            mean = figure([r for r in home if r.cell == cell.name], BY_NAME[name])
            if mean is not None:
                points.append((float(count), mean))
        series.append((BY_NAME[name].title, points))
    svg = lines("Scores by the number of example programs", series)
    return [("Number of example programs", svg)] if svg else []


def _beside(
    results: Sequence[Result], printed: Sequence[Printed] | None, names: Sequence[str] = TRIPLE
) -> list[Entry]:
    """Ours and the paper's, metric by metric."""
    entries: list[Entry] = []
    for place, name in enumerate(names):
        entries += [figure(results, BY_NAME[name]), printed[place] if printed else None]
    return entries


def _columns(
    *first: str, names: Sequence[str] = TRIPLE, more: Sequence[str] = ()
) -> tuple[str, ...]:
    pairs = [(BY_NAME[name].title, f"{BY_NAME[name].title}, paper") for name in names]
    return (*first, *(title for pair in pairs for title in pair), *more)


def _main(plan: Plan, home: Sequence[Result]) -> Table:
    rows: list[tuple[Entry, ...]] = []
    groups = grouped(home, lambda result: result.cell)
    for cell in methods(plan):
        of_cell = groups.get(cell.name)
        if not of_cell:
            continue
        printed = None if plan.own else MAIN.get(cell.name)
        core = [figure(of_cell, BY_NAME[name]) for name in ("core_sr", "core_gcr", "seconds")]
        rows.append((cell.name, of_cell[0].model, len(of_cell), *_beside(of_cell, printed), *core))
    for name in ("ProgPrompt, largest model", "ProgPrompt, smaller model"):
        if not plan.own:
            model = "Codex" if "largest" in name else "Davinci"
            told = [entry for printed in MAIN[name] for entry in (None, printed)]
            rows.append((f"{name}, as printed", model, None, *told, None, None, None))
    return Table(
        name="main",
        title="Table 1: methods and ablations",
        columns=_columns("method", "model", "n", more=("core SR", "core GCR", "seconds")),
        rows=tuple(rows),
        note="The printed figures are GPT3's (text-davinci-002), with 3 examples and 5 runs. Core "
        "scores leave out conditions that only say where somebody stands, three quarters of all.",
    )


def _tasks(plan: Plan, results: Sequence[Result]) -> Table:
    rows: list[tuple[Entry, ...]] = []
    for task, group in grouped(results, lambda result: result.task).items():
        printed = None if plan.own else TASKS.get(plain_name(task))
        rows.append((plain_name(task), group[0].steps, *_beside(group, printed)))
    for length, group in sorted(grouped(results, length_class).items()):
        printed = None if plan.own else LENGTHS.get(length)
        rows.append((f"average of {length} steps", None, *_beside(group, printed)))
    return Table(
        name="by-task",
        title="Table 2: task by task",
        columns=_columns("task", "|A|"),
        rows=tuple(rows),
        note="The paper prints .60 for 6 to 10 steps; its own five rows make .56.",
    )


def _places(plan: Plan, results: Sequence[Result]) -> Table:
    rows = [
        (place, *_beside(group, None if plan.own else PLACES.get(place)))
        for place, group in sorted(grouped(results, lambda result: result.environment).items())
    ]
    if len(rows) > 1:
        rows.append(("average", *_beside(results, None if plan.own else PLACES["average"])))
    return Table(
        name="places",
        title="Table 3: environments",
        columns=_columns("environment"),
        rows=tuple(rows),
    )


def _places_of_ours(plan: Plan, results: Sequence[Result]) -> Table:
    """The same of the last method, with the core scores beside."""
    cell = methods(plan)[-1].name
    chosen = [result for result in results if result.cell == cell]
    names = ("sr", "exec", "gcr", "core_sr", "core_gcr")
    rows: list[tuple[Entry, ...]] = [
        (place, *(figure(group, BY_NAME[name]) for name in names))
        for place, group in sorted(grouped(chosen, lambda result: result.environment).items())
    ]
    if len(rows) > 1:
        rows.append(("average", *(figure(chosen, BY_NAME[name]) for name in names)))
    return Table(
        name="places-ours",
        title=f"Environments, {cell}",
        columns=("environment", *(BY_NAME[name].title for name in names)),
        rows=tuple(rows),
    )


def _robot_table(results: Sequence[Result]) -> Table:
    names = ("sr", "plan_sr", "gcr")
    rows: list[tuple[Entry, ...]] = []
    for group in grouped(results, lambda result: result.task).values():
        task, distractors = group[0].category, int(group[0].task.rpartition(", ")[2].split()[0])
        printed = ROBOT.get((task, distractors))
        strict = figure(group, BY_NAME["strict"])
        rows.append((task, distractors, *_beside(group, printed, names), strict))
    return Table(
        name="robot",
        title="Table 4: robot tasks among distractors",
        columns=_columns("task", "distractors", names=names, more=("strict Plan SR",)),
        rows=tuple(rows),
        note="Ours in physics, the paper's on the robot. The text speaks of one to three "
        "distractors, the table of up to four.",
    )


def _sweep_table(plan: Plan, home: Sequence[Result]) -> Table:
    rows: list[tuple[Entry, ...]] = []
    names = (*TRIPLE, "core_sr", "seconds")
    for count, cell in zip(EXAMPLES, _sweep(plan), strict=True):
        group = [result for result in home if result.cell == cell.name]
        if group:
            rows.append((str(count), len(group), *(figure(group, BY_NAME[name]) for name in names)))
    return Table(
        name="sweep",
        title="Number of example programs",
        columns=("examples", "n", *(BY_NAME[name].title for name in names)),
        rows=tuple(rows),
    )
