"""Controls inside the 3D view, for a browser that has it open without the page around it."""

from typing import Any

import viser

from app.view.screening import Screening

SPEEDS = ("0.25x", "0.5x", "1x", "2x", "4x")


class Controls:
    """Play and pause, where we are, how fast, and whether to stay with the newest."""

    def __init__(self, gui: viser.GuiApi, screening: Screening) -> None:
        self._screening = screening
        self._shown = 0.0
        gui.configure_theme(show_logo=False, show_share_button=False, dark_mode=False)
        gui.set_panel_label("Rollout")
        self._play = gui.add_button("Play or pause", icon=viser.Icon.PLAYER_PLAY)
        self._time = gui.add_slider("Time [s]", 0.0, 0.1, 0.01, 0.0)
        self._speed = gui.add_dropdown("Speed", SPEEDS, initial_value="1x")
        self._follow = gui.add_checkbox("Follow live", initial_value=False)
        self._play.on_click(self._toggle)
        self._time.on_update(self._scrub)
        self._speed.on_update(self._change_speed)
        self._follow.on_update(self._change_follow)

    def show(self) -> None:
        """Bring the controls up to the playhead."""
        moment = self._screening.moment()
        self._time.max = max(round(moment.duration, 2), 0.1)
        self._shown = round(moment.time, 2)
        if abs(self._time.value - self._shown) > 0.05:
            self._time.value = self._shown
        self._follow.visible = not moment.finished
        if self._follow.value != (moment.mode == "following"):
            self._follow.value = moment.mode == "following"

    def _toggle(self, _: viser.GuiEvent[Any]) -> None:
        paused = self._screening.moment().mode == "paused"
        self._screening.turn("playing" if paused else "paused")

    def _scrub(self, event: viser.GuiEvent[Any]) -> None:
        if event.client is not None:  # else it was us, in ``show``
            self._screening.turn("paused")
            self._screening.seek(self._time.value)

    def _change_speed(self, event: viser.GuiEvent[Any]) -> None:
        if event.client is not None:
            self._screening.set_speed(float(self._speed.value.rstrip("x")))

    def _change_follow(self, event: viser.GuiEvent[Any]) -> None:
        if event.client is not None:
            self._screening.turn("following" if self._follow.value else "playing")
