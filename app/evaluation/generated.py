"""Generated scenes: a task among distractors that a seed draws from its world's catalogue."""

from dataclasses import replace

import numpy as np

from app.domain.scene import SceneObject
from app.evaluation.tasks import SuiteTask
from app.worlds import worlds


def with_distractors(task: SuiteTask, *, distractors: int, seed: int) -> SuiteTask:
    """The task with so many more objects in its scene, none of a kind or category it has already.

    The same seed draws the same objects, whatever the order in which tasks are read.
    """
    world = worlds[task.scene.world]
    completed = world.complete(task.scene, task.seed)
    kinds = {item.kind for item in completed.objects}
    categories = {item.category for item in completed.objects if not item.container}
    free = [
        kind.name
        for kind in world.catalogue()
        if not kind.container and kind.name not in kinds and kind.category not in categories
    ]
    order = np.random.default_rng((seed, len(free))).permutation(len(free))
    drawn = tuple(free[index] for index in order[:distractors])
    added = tuple(SceneObject(name=name.replace("_", " "), kind=name) for name in drawn)
    scene = replace(task.scene, objects=(*task.scene.objects, *added))
    return replace(
        task, scene=scene, seed=seed, distractors=(*task.distractors, *(a.name for a in added))
    )
