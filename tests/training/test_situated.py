from app.domain.action import ActionSignature, Parameter
from app.domain.instruction import Instruction
from app.domain.planner import PlannerOptions, Task
from app.domain.scene import Scene, SceneObject
from app.programs.situated import colour_word, describe, write_situated_prompt

PUT = ActionSignature(
    name="grab_and_putin",
    parameters=(Parameter(name="obj1"), Parameter(name="obj2", role="container")),
    meaning="",
)


def task(sentence: str, *objects: SceneObject) -> Task:
    return Task(
        scene=Scene(world="tabletop", objects=objects),
        actions=(PUT,),
        instruction=Instruction(sentence),
        options=PlannerOptions(),
    )


def test_a_scene_of_names_is_a_list() -> None:
    banana, bowl = SceneObject(name="banana", colour="yellow"), SceneObject(name="bowl")
    assert write_situated_prompt(task('put the "banana" in the bowl', banana, bowl)) == (
        "from actions import grab_and_putin(obj1, obj2)\n"
        "objects = ['banana', 'bowl']\n"
        "def task():\n"
        '    """put the \'banana\' in the bowl"""\n'
    )


def test_colours_are_told_where_the_sentence_speaks_of_them() -> None:
    cup, bowl = SceneObject(name="cup", colour="#fe0101"), SceneObject(name="bowl")
    prompt = write_situated_prompt(task("put the red thing in the bowl", cup, bowl))
    assert "objects = {'cup': 'red', 'bowl': ''}" in prompt


def test_look_alikes_are_told_apart_by_side_from_left_to_right() -> None:
    cups = [
        SceneObject(name=f"cup {number}", position=(0.4, y, 0.0))
        for number, y in ((1, 0.1), (2, 0.3), (3, -0.2))
    ]
    described = describe(cups, "take the cup on the left")
    assert [told["position"] for told in described.values()] == ["center", "left", "right"]
    assert describe(cups, "take cup 2") == {"cup 1": {}, "cup 2": {}, "cup 3": {}}


def test_sizes_are_told_by_rank() -> None:
    boxes = [SceneObject(name=f"box {n}", size=(n / 10, 0.1, 0.1)) for n in (2, 1)]
    described = describe(boxes, "the smallest box")
    assert [told["size"] for told in described.values()] == ["large", "small"]


def test_a_category_is_always_told_unless_the_name_says_it() -> None:
    objects = [
        SceneObject(name="banana", category="fruit"),
        SceneObject(name="fruit bowl", category="fruit bowl"),
    ]
    assert describe(objects, "go") == {"banana": {"category": "fruit"}, "fruit bowl": {}}


def test_a_sentence_cannot_close_its_own_quotes() -> None:
    prompt = write_situated_prompt(task('put it """\n    pass', SceneObject(name="a")))
    assert prompt.count('"""') == 2


def test_colours_become_words() -> None:
    assert colour_word("#0000ee") == "blue"
    assert colour_word("Crimson") == "crimson"
