import subprocess
import sys

import pytest
from click.testing import CliRunner

from app.cli import main


def test_every_command_is_listed_with_what_it_does_and_none_is_imported():
    told = "import sys, app.cli; app.cli.main(['--help'], standalone_mode=False);"
    told += "print([name for name in ('mujoco', 'fastapi', 'sqlalchemy') if name in sys.modules])"
    done = subprocess.run([sys.executable, "-c", told], capture_output=True, text=True, check=True)
    *listed, imported = done.stdout.strip().splitlines()
    for name in ("bench", "demo", "eval", "models", "plan", "robot", "serve", "train", "worker"):
        (line,) = [line for line in listed if line.split()[:1] == [name]]
        assert len(line.split()) > 3
    assert imported == "[]"


@pytest.mark.parametrize("command", [["models"], ["eval", "tabletop", "--limit=1"]])
def test_a_setting_of_the_wrong_form_is_named_without_a_traceback(command, monkeypatch):
    monkeypatch.setenv("PROGPROMPT_THREADS", "two")
    done = CliRunner().invoke(main, command)
    assert done.exit_code == 1
    assert done.output.endswith("Error: PROGPROMPT_THREADS is 'two'; a whole number is wanted\n")


def test_an_unknown_model_is_named_without_a_traceback():
    done = CliRunner().invoke(main, ["bench", "model", "--model", "huge"])
    assert done.exit_code == 1
    assert done.output.startswith("Error: ")
    assert "huge" in done.output
