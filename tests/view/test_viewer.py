import asyncio
import threading
import time

import numpy as np
import pytest

from app.domain.errors import NotThere
from app.view.film import BEGINNING, Film
from app.view.source import Footage
from app.view.viewer import Viewer

BLOCK = "/world/2"


@pytest.fixture
def watch(address, open_browser):
    return lambda execution_id, token: open_browser(f"ws://{address}/viewer/{execution_id}/{token}")


def highest(browser):
    return max((position[2] for position in browser.positions.get(BLOCK, [])), default=0.0)


def test_browser_gets_the_scene_and_the_motion_to_its_end(watch):
    browser = watch("done", "page")
    browser.watch(lambda seen: highest(seen) > 1.06)
    assert browser.glbs == {"/world/1/looks", "/world/2/looks"}
    heights = [position[2] for position in browser.positions[BLOCK]]
    assert heights == sorted(heights)


def test_two_browsers_watch_two_rollouts(watch):
    done = watch("done", "one")
    live = watch("live", "two")
    done.watch(lambda seen: highest(seen) > 1.06)
    live.watch(lambda seen: highest(seen) > 0.39)
    assert highest(live) < 0.41  # only ten frames of it are there yet


def test_live_browser_sees_what_comes_later(watch, growing):
    browser = watch("live", "page")
    browser.watch(lambda seen: highest(seen) > 0.39)
    growing.known = 30
    browser.watch(lambda seen: highest(seen) > 1.06)


def test_page_moves_the_picture(viewer, watch):
    with viewer.screening("done", "page") as screening:
        browser = watch("done", "page")
        browser.watch(lambda seen: highest(seen) > 1.06)
        screening.seek(0.5)
        browser.watch(lambda seen: seen.positions[BLOCK][-1][2] == pytest.approx(0.6, abs=1e-3))


def test_nothing_is_kept_of_browsers_that_have_gone(viewer, watch):
    browser = watch("done", "page")
    browser.watch(lambda seen: seen.glbs)
    browser.close()
    deadline = time.monotonic() + 20
    while viewer._screenings:
        assert time.monotonic() < deadline
        time.sleep(0.05)


def test_unknown_execution_is_not_there(viewer):
    with pytest.raises(NotThere, match="there is no execution 'nope'"):
        viewer.screening("nope", "page").__enter__()
    assert not viewer._screenings


def test_rollout_opened_again_is_not_read_again(viewer, rollout):
    for _ in range(2):
        with viewer.screening("done", "page") as screening:
            asyncio.run(screening.tick())
    assert rollout.asked == [0]


def test_who_leaves_does_not_wait_for_who_comes(rollout, growing):
    coming, ready = threading.Event(), threading.Event()

    def find(execution_id):
        if execution_id == "slow":
            coming.set()
            ready.wait(20)
        return growing if execution_id == "slow" else rollout

    viewer = Viewer(find)
    view = viewer.screening("done", "page")
    view.__enter__()
    slow = viewer.screening("slow", "page")
    other = threading.Thread(target=slow.__enter__)
    other.start()
    assert coming.wait(20)
    leaving = threading.Thread(target=view.__exit__, args=(None, None, None))
    leaving.start()
    leaving.join(5)
    waits = leaving.is_alive()
    ready.set()
    other.join(20)
    leaving.join(20)
    assert not waits
    assert [key for key, _ in viewer._screenings] == ["slow"]


def test_same_token_is_the_same_moment_and_another_is_not(viewer):
    with viewer.screening("done", "one") as one, viewer.screening("done", "two") as two:
        one.turn("paused")
        one.seek(0.5)
        two.turn("paused")
        assert asyncio.run(one.tick()) == 0.5
        assert asyncio.run(two.tick()) == 0.0
        with viewer.screening("done", "one") as again:
            assert again is one
        np.testing.assert_array_equal(one.footage.at(0.5), two.footage.at(0.5))


def test_a_picture_is_made_once_for_all_who_watch(rollout):
    film = Film(Footage(rollout))
    film.footage.refresh()
    moment = film.moment(0.51, 1.0)
    assert film.picture(BEGINNING, moment) is film.picture(BEGINNING, moment)


def test_nothing_is_sent_between_two_pictures_that_look_the_same(growing):
    film = Film(Footage(growing))
    film.footage.refresh()
    assert film.picture(0.1, 0.1) is None


def test_the_last_picture_is_the_newest_frame_whether_it_fits_the_pace_or_not(model, frames):
    late = frames.copy()
    late[-1, 0] += 0.005

    class Late:
        def model(self):
            return model

        def frames(self, after):
            return late[after:]

        def finished(self):
            return True

    film = Film(Footage(Late()))
    film.footage.refresh()
    assert film.moment(99.0, 1.0) == film.footage.duration == late[-1, 0]


def test_slow_motion_has_finer_pictures(rollout):
    film = Film(Footage(rollout))
    film.footage.refresh()
    assert film.moment(0.51, 1.0) == 15 / 30
    assert film.moment(0.51, 0.25) == 61 / 120
