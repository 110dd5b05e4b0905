import pytest

from app.domain.condition import Relation
from app.domain.errors import ActionFailure


@pytest.fixture
def world(tabletop, scene_of):
    scene = scene_of(
        apple=(0.5, 0.3), block=(0.5, 0.15), bowl=(0.5, -0.05), tray=(0.45, -0.35), book=(0.35, 0.2)
    )
    return tabletop.open_perfect(scene, 0)


def told(world):
    return {str(fact) for fact in world.facts()}


def test_it_begins_with_nothing_in_anything(world):
    assert told(world) == set()
    assert world.holds(Relation("left_of", ("apple", "bowl")))


def test_putting_into_a_bowl_adds_in_alone(world, carry_out):
    carry_out(world, "apple", "bowl")
    assert told(world) == {"in(apple, bowl)"}


def test_putting_on_a_tray_adds_both(world, carry_out):
    carry_out(world, "apple", "tray")
    assert told(world) == {"in(apple, tray)", "on(apple, tray)"}


def test_putting_on_a_book_adds_on_alone(world, carry_out):
    carry_out(world, "block", "book")
    assert told(world) == {"on(block, book)"}


def test_what_is_moved_again_leaves_where_it_was(world, carry_out):
    carry_out(world, "apple", "bowl")
    carry_out(world, "apple", "tray")
    assert told(world) == {"in(apple, tray)", "on(apple, tray)"}


def test_a_bowl_takes_its_contents_along(world, carry_out):
    carry_out(world, "apple", "bowl")
    carry_out(world, "bowl", "tray")
    assert told(world) >= {"in(apple, bowl)", "in(bowl, tray)", "in(apple, tray)"}


def test_what_goes_into_a_bowl_on_a_tray_is_in_the_tray_as_well(world, carry_out):
    carry_out(world, "bowl", "tray")
    carry_out(world, "apple", "bowl")
    assert told(world) >= {"in(apple, bowl)", "in(apple, tray)"}


def test_sides_change_with_the_destination(world, carry_out):
    assert world.holds(Relation("left_of", ("apple", "block")))
    carry_out(world, "apple", "tray")
    assert world.holds(Relation("right_of", ("apple", "block")))
    assert world.holds(Relation("left_of", ("block", "apple")))
    assert not world.holds(Relation("left_of", ("apple", "block")))
    assert world.holds(Relation("near", ("apple", "tray")))


def test_doing_it_twice_changes_nothing_more(world, carry_out):
    carry_out(world, "apple", "bowl")
    before = world.save()
    carry_out(world, "apple", "bowl")
    assert world.save() == before


@pytest.mark.parametrize(("item", "target"), [("bowl", "bowl"), ("bowl", "apple")])
def test_what_cannot_be_fails_and_changes_nothing(world, carry_out, item, target):
    carry_out(world, "apple", "bowl")
    before = world.save()
    with pytest.raises(ActionFailure):
        carry_out(world, item, target)
    assert world.save() == before


def test_saved_facts_are_restored(world, tabletop, carry_out):
    carry_out(world, "apple", "bowl")
    fresh = tabletop.open_perfect(world.scene, 0)
    fresh.restore(world.save())
    assert told(fresh) == {"in(apple, bowl)"}
    assert fresh.frames() == ()
    assert fresh.time == 0.0
