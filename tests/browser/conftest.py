"""The service as people start it, and a browser to look at it."""

import json
import os
import re
import signal
import subprocess
import sys
import threading

import pytest
from playwright.sync_api import expect, sync_playwright

from tests.browser.chromium import ARGUMENTS, executable

LIMIT = 120.0  # [s], generous: drawing in software takes its time on a busy machine
PROGRAM = (
    "    # 1: put the banana in the bowl\n    grab_and_putin('banana', 'bowl')\n    # 2: Done\n"
)
SCRIPT = [
    {"when": "put the banana in the bowl", "text": PROGRAM, "delay": 0.05},
    {"when": "put the banana in the vase", "text": "    grab_and_putin('banana', 'vase')\n"},
    {"when": "go on forever", "text": "    # on and on\n", "endless": True, "delay": 0.05},
    {"when": "and rest now", "text": "    pass\n"},
    {"when": "say nothing", "error": "the model said nothing"},
]


class Service:
    """``progprompt serve`` in a process of its own; started again it keeps port and data."""

    def __init__(self, folder):
        self._folder = folder
        self._script = folder / "script.json"
        self._script.write_text(json.dumps(SCRIPT))
        self._port = "0"

    def start(self):
        self._lines = []
        ready = threading.Event()
        command = [sys.executable, "-m", "app.cli", "serve", "--model=scripted"]
        self._process = subprocess.Popen(
            [*command, f"--port={self._port}", f"--data-dir={self._folder / 'data'}"],
            env=os.environ | {"PROGPROMPT_SCRIPTED": str(self._script), "PYTHONUNBUFFERED": "1"},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        threading.Thread(target=self._listen, args=(ready,), daemon=True).start()
        assert ready.wait(LIMIT), "\n".join(self._lines)

    def _listen(self, ready):
        assert self._process.stdout
        with self._process.stdout as output:
            for line in output:
                self._lines.append(line.rstrip())
                if found := re.match(r"ready: (\S+)", line):
                    self.url = found[1]
                    self._port = self.url.rpartition(":")[2]
                    ready.set()

    def stop(self):
        self._process.send_signal(signal.SIGINT)
        self._process.wait(LIMIT)


@pytest.fixture(scope="session")
def service(tmp_path_factory):
    service = Service(tmp_path_factory.mktemp("service"))
    service.start()
    yield service
    service.stop()


@pytest.fixture(scope="module")
def browser():
    # Not longer: while Playwright is open nobody else may run an event loop in this thread.
    with sync_playwright() as playwright:
        path = executable(playwright)
        yield playwright.chromium.launch(executable_path=path, args=list(ARGUMENTS))


@pytest.fixture
def open_page(browser, service):
    """Opens the page in a fresh browser profile; nothing may go wrong in it unseen."""
    expect.set_options(timeout=LIMIT * 1000)
    contexts, faults = [], []

    def open_page(path="/", **options):
        # Without motion a page draws only when asked to, which is cheap where nobody looks on.
        usual = {"viewport": {"width": 900, "height": 700}, "reduced_motion": "reduce"}
        context = browser.new_context(**usual | options)
        contexts.append(context)
        page = context.new_page()
        page.set_default_timeout(LIMIT * 1000)
        page.on("pageerror", lambda error: faults.append(str(error)))
        page.goto(service.url + path)
        expect(page.locator("#object-list input").first).to_be_visible()
        return page

    yield open_page
    for context in contexts:
        context.close()
    assert not faults
