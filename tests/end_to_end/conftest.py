"""``progprompt serve`` as people start it: its own processes, the scripted model, real physics."""

import json
import os
import re
import signal
import subprocess
import sys
import threading
import time

import httpx
import pytest

from tests.engines import ENGINES

LIMIT = 120.0  # [s], generous: the machine may be busy with other things
SCRIPT = [
    {
        "when": "put the banana in the bowl",
        "text": "    # 1: put the banana in the bowl\n    grab_and_putin('banana', 'bowl')\n",
    },
    {
        "when": "take your time",
        "text": "    # 1: put the banana in the bowl\n    grab_and_putin('banana', 'bowl')\n",
        "delay": 0.05,
    },
    {
        "when": "take twice your time",
        "text": "    # 1: put the banana in the bowl\n    grab_and_putin('banana', 'bowl')\n",
        "delay": 0.5,
    },
    {"when": "go on forever", "text": "    # on and on\n", "endless": True, "delay": 0.05},
]


class Service:
    """A service in a process of its own."""

    def __init__(self, data_dir, database_url, script):
        self.data_dir = data_dir
        self._settings = {
            "PROGPROMPT_SCRIPTED": str(script),
            "PROGPROMPT_DATABASE_URL": database_url,
        }
        self.lines = []
        self._ready = threading.Event()

    def start(self):
        self._ready.clear()
        self.process = subprocess.Popen(
            [
                sys.executable,
                "-m",
                "app.cli",
                "serve",
                "--port=0",
                "--model=scripted",
                f"--data-dir={self.data_dir}",
            ],
            env=os.environ | self._settings | {"PYTHONUNBUFFERED": "1"},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        threading.Thread(target=self._listen, daemon=True).start()
        assert self._ready.wait(LIMIT), "\n".join(self.lines)
        self.http = httpx.Client(base_url=self.url, timeout=LIMIT)
        return self

    def _listen(self):
        assert self.process.stdout is not None
        with self.process.stdout as output:
            for line in output:
                self.lines.append(line.rstrip())
                if found := re.match(r"ready: (\S+)", line):
                    self.url = found[1]
                    self._ready.set()

    def stop(self, number=signal.SIGINT):
        self.http.close()
        self.process.send_signal(number)
        return self.process.wait(LIMIT)

    def worker(self, worker_id):
        """The process id of the worker's present life."""
        started = [line for line in self.lines if line.startswith(f"started {worker_id} ")]
        return int(re.findall(r"process (\d+)", started[-1])[0])

    def get(self, path):
        return self.http.get(path).json()

    def wait(self, path, *statuses):
        """The resource, once its status is one of these."""
        deadline = time.monotonic() + LIMIT
        while (found := self.get(path))["status"] not in statuses:
            assert time.monotonic() < deadline, found
            time.sleep(0.1)
        return found

    def events(self, path, *, after=-1, until=None):
        """The events of a stream after a number, up to its end or up to one of this kind."""
        told = []
        with self.http.stream("GET", path, headers={"Last-Event-ID": str(after)}) as answer:
            for line in answer.iter_lines():
                if line.startswith("data: "):
                    told.append(json.loads(line.removeprefix("data: ")))
                    if told[-1]["kind"] in ("end", until):
                        break
        return told


@pytest.fixture(scope="session")
def script(tmp_path_factory):
    path = tmp_path_factory.mktemp("script") / "script.json"
    path.write_text(json.dumps(SCRIPT))
    return path


@pytest.fixture(scope="module", params=ENGINES)
def service(request, script, tmp_path_factory):
    with request.getfixturevalue(request.param).empty() as url:
        service = Service(tmp_path_factory.mktemp("data"), url, script).start()
        yield service
        if service.process.poll() is None:
            service.stop()
