import pytest

from app.domain.action import ActionSignature, Parameter
from app.domain.instruction import Instruction
from app.domain.llm import Completion
from app.domain.planner import PlannerOptions, Task
from app.domain.scene import Scene, SceneObject
from app.llm.backends.scripted import Answer, ScriptedModel
from app.worlds import worlds


class CannedModel:
    """Writes what it was told to, a few characters at a time, stopping where it is asked to.

    Of several texts each request gets the next one, and the last one from then on.
    """

    name = "canned"

    def __init__(self, *texts, follows_grammar=True, streams=True):
        self.texts = texts
        self.follows_grammar = follows_grammar
        self.streams = streams
        self.requests = []

    @property
    def text(self):
        return self.texts[min(max(len(self.requests), 1), len(self.texts)) - 1]

    def complete(self, request, on_text=None):
        self.requests.append(request)
        said = self.text
        ends = [said.find(stop) for stop in request.stop if stop in said]
        text = said[: min(ends)] if ends else said
        finish = "stop"
        if len(text) > 4 * request.max_tokens:
            text, finish = text[: 4 * request.max_tokens], "length"
        for start in range(0, len(text) if self.streams else 0, 4):
            if on_text and on_text(text[start : start + 4]):
                text, finish = text[: start + 4], "cancelled"
                break
        return Completion(
            text=text,
            model=self.name,
            finish=finish,
            prompt_tokens=len(request.prompt) // 4,
            completion_tokens=-(-len(text) // 4),
            seconds=0.0,
            logprob=0.0 if request.logprob else None,
        )

    def score(self, prompt, candidates):
        return ScriptedModel([Answer(text=self.text)]).score(prompt, candidates)


@pytest.fixture
def canned():
    return CannedModel


@pytest.fixture
def task():
    def make(**options):
        scene = Scene(
            world="tabletop",
            objects=(
                SceneObject(name="banana"),
                SceneObject(name="bowl", container=True),
            ),
        )
        return Task(
            scene=scene,
            rehearsal=lambda: worlds["tabletop"].open_perfect(scene, 0),
            actions=(
                ActionSignature(
                    name="grab_and_putin",
                    parameters=(Parameter(name="obj1"), Parameter(name="obj2", role="container")),
                    meaning="Takes up one object and puts it down in another.",
                ),
            ),
            instruction=Instruction("put the banana in the bowl"),
            options=PlannerOptions(**options),
        )

    return make
