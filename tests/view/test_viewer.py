import threading
import time

import numpy as np
import pytest

from app.domain.errors import NotThere
from app.view.viewer import Viewer

BLOCK = "/world/2"


@pytest.fixture
def viewer(rollouts):
    viewer = Viewer(rollouts)
    yield viewer
    viewer.close()


def highest(browser):
    return max((position[2] for position in browser.positions.get(BLOCK, [])), default=0.0)


def test_browser_gets_the_scene_and_the_motion_to_its_end(viewer, open_browser):
    browser = open_browser(viewer.url("done", "page"))
    browser.watch(lambda seen: highest(seen) > 1.06)
    assert browser.glbs == {"/world/1/looks", "/world/2/looks"}
    heights = [position[2] for position in browser.positions[BLOCK]]
    assert heights == sorted(heights)


def test_two_browsers_watch_two_rollouts(viewer, open_browser):
    done = open_browser(viewer.url("done", "one"))
    live = open_browser(viewer.url("live", "two"))
    done.watch(lambda seen: highest(seen) > 1.06)
    live.watch(lambda seen: highest(seen) > 0.39)
    assert highest(live) < 0.41  # only ten frames of it are there yet


def test_live_browser_sees_what_comes_later(viewer, open_browser, growing):
    browser = open_browser(viewer.url("live", "page"))
    browser.watch(lambda seen: highest(seen) > 0.39)
    growing.known = 30
    browser.watch(lambda seen: highest(seen) > 1.06)


def test_page_moves_the_picture(viewer, open_browser):
    with viewer.screening("done", "page") as screening:
        browser = open_browser(viewer.url("done", "page"))
        browser.watch(lambda seen: highest(seen) > 1.06)
        screening.seek(0.5)
        browser.watch(lambda seen: seen.positions[BLOCK][-1][2] == pytest.approx(0.6, abs=1e-3))


def test_nothing_is_kept_of_browsers_that_have_gone(viewer, open_browser):
    browser = open_browser(viewer.url("done", "page"))
    browser.watch(lambda seen: seen.glbs)
    browser.close()
    deadline = time.monotonic() + 20
    while _drawing() or viewer._screenings or viewer._gone:
        assert time.monotonic() < deadline
        time.sleep(0.05)


def test_unknown_execution_is_not_there(viewer):
    with pytest.raises(NotThere, match="there is no execution 'nope'"):
        viewer.screening("nope", "page").__enter__()
    assert not viewer._screenings


def test_rollout_opened_again_is_not_read_again(viewer, rollout):
    for _ in range(2):
        with viewer.screening("done", "page") as screening:
            screening.tick()
    assert rollout.asked == [0]


def test_same_token_is_the_same_moment_and_another_is_not(viewer):
    with viewer.screening("done", "one") as one, viewer.screening("done", "two") as two:
        one.turn("paused")
        one.seek(0.5)
        two.turn("paused")
        assert one.tick() == 0.5
        assert two.tick() == 0.0
        with viewer.screening("done", "one") as again:
            assert again is one
        np.testing.assert_array_equal(one.footage.at(0.5), two.footage.at(0.5))


def _drawing():
    return [thread for thread in threading.enumerate() if thread.name.startswith("view of")]
