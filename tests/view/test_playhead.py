from hypothesis import given
from hypothesis import strategies as st

from app.view.playhead import Playhead

moves = st.lists(
    st.one_of(
        st.tuples(st.just("advance"), st.floats(0, 10)),
        st.tuples(st.just("seek"), st.floats(0, 100)),
        st.tuples(st.just("set_speed"), st.floats(0.01, 100)),
        st.tuples(st.sampled_from(["play", "pause", "follow"]), st.none()),
    )
)


@given(moves, st.floats(0, 50), st.booleans())
def test_playhead_never_leaves_what_is_known(moves, end, finished):
    playhead = Playhead()
    for move, value in moves:
        if move == "play":
            playhead.play(end=end, finished=finished)
        elif move in ("pause", "follow"):
            getattr(playhead, move)()
        elif move != "advance":
            getattr(playhead, move)(value)
        playhead.advance(value if move == "advance" else 0.0, end=end, finished=finished)
        assert 0 <= playhead.time <= end


def test_playing_takes_as_long_as_the_rollout_took():
    playhead = Playhead()
    playhead.advance(2.0, end=10, finished=False)
    assert playhead.time == 2


def test_at_the_end_of_a_growing_rollout_it_waits_for_more():
    playhead = Playhead()
    playhead.advance(5.0, end=3, finished=False)
    assert (playhead.time, playhead.mode) == (3, "playing")
    playhead.advance(1.0, end=8, finished=False)
    assert playhead.time == 4


def test_at_the_end_of_a_finished_rollout_it_pauses():
    playhead = Playhead()
    playhead.advance(5.0, end=3, finished=True)
    assert (playhead.time, playhead.mode) == (3, "paused")


def test_playing_a_finished_rollout_again_begins_at_the_start():
    playhead = Playhead(time=3, mode="paused")
    playhead.play(end=3, finished=True)
    assert (playhead.time, playhead.mode) == (0, "playing")


def test_following_shows_the_newest():
    playhead = Playhead()
    playhead.follow()
    playhead.advance(0.03, end=7, finished=False)
    assert playhead.time == 7


def test_seeking_ends_following():
    playhead = Playhead(mode="following")
    playhead.seek(1.0)
    playhead.advance(0.0, end=7, finished=False)
    assert playhead.time == 1


def test_a_paused_playhead_stays():
    playhead = Playhead(time=1, mode="paused")
    playhead.advance(5.0, end=7, finished=False)
    assert playhead.time == 1


def test_twice_the_speed_takes_half_the_time():
    playhead = Playhead(speed=2)
    playhead.advance(1.0, end=7, finished=False)
    assert playhead.time == 2
