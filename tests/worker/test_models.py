from app.llm.backends.scripted import ScriptedModel
from app.llm.models import Endpoint, LlmConfig
from app.worker.models import Models


class Heavy(ScriptedModel):
    """A model that takes memory until it is closed."""

    closed = False

    def close(self):
        self.closed = True


class Opened(list):
    """Opens models, and remembers them in turn."""

    def __call__(self, name, config):
        kind = ScriptedModel if name == "light" else Heavy
        self.append(kind([], name))
        return self[-1]


def models(opened, most):
    endpoint = Endpoint(base_url="http://llm.test/v1", model="m")
    names = ("light", "a", "b", "c")
    config = LlmConfig(endpoints=tuple((name, endpoint) for name in names), most_models=most)
    return Models(config, "default", opened)


def test_model_is_opened_once_and_kept():
    held = models(opened := Opened(), 2)
    assert held("a", "x") is held("a", "x")
    assert [model.name for model in opened] == ["a"]


def test_model_longest_unused_is_closed_for_another():
    held = models(opened := Opened(), 2)
    for name in ("a", "b", "a", "c"):
        held(name, "x")
    assert [(model.name, model.closed) for model in opened] == [
        ("a", False),
        ("b", True),
        ("c", False),
    ]
    held("b", "x")
    assert [model.name for model in opened] == ["a", "b", "c", "b"]


def test_models_without_memory_of_their_own_do_not_count():
    held = models(opened := Opened(), 1)
    for name in ("light", "a", "light"):
        held(name, "x")
    assert [model.name for model in opened] == ["light", "a"]
    assert not opened[1].closed
