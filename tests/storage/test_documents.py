from app.domain.action import ActionSignature, Parameter
from app.domain.scene import Scene, SceneObject
from app.programs.grounding import ground
from app.programs.parser import parse_program
from app.storage.documents import plan_columns

PLACE = ActionSignature(
    name="place",
    parameters=(Parameter(name="obj"), Parameter(name="x", role="number")),
    meaning="Places it.",
)
TEXT = """\
def away(item):
    place(item, x=0.4)
def tidy():
    for each in ['lime']:
        if 'lime' in 'bowl':
            away(each)
        else:
            pass
"""


def test_a_program_with_loops_branches_and_helpers_is_kept_as_a_tree_with_flat_steps():
    scene = Scene(world="tabletop", objects=(SceneObject(name="lime"), SceneObject(name="bowl")))
    program = parse_program(TEXT)
    columns = plan_columns(program, ground(program, scene, [PLACE], {"in": 2}))
    helper, loop = columns["program_tree"]
    assert helper["kind"] == "helper"
    assert helper["parameters"] == ["item"]
    assert helper["body"] == [
        {
            "kind": "call",
            "line": 2,
            "action": "place",
            "arguments": ["item"],
            "keywords": {"x": 0.4},
        }
    ]
    assert (loop["kind"], loop["text"]) == ("loop", "for each in ['lime']:")
    (branch,) = loop["body"]
    assert (branch["kind"], branch["condition"]) == ("branch", "in(lime, bowl)")
    assert [each["kind"] for each in branch["body"] + branch["otherwise"]] == ["call", "pass"]
    assert columns["steps"] == [
        {"line": 2, "action": "place", "arguments": ["lime", 0.4], "comment": None}
    ]
