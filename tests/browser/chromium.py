"""Where Chromium is, or how it gets here: the test command installs what it needs."""

import os
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path

from playwright.sync_api import Playwright

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
ARGUMENTS = (
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
)
"""WebGL without a graphics card, and no calls home."""


@cache
def executable(playwright: Playwright) -> str:
    """Path of a Chromium; one is installed if there is none."""
    if found := _on_path() or _of_playwright(playwright):
        return found
    _install()
    if found := _on_path() or _of_playwright(playwright):
        return found
    raise RuntimeError("there is no Chromium and none could be installed; put one on the PATH")


def _on_path() -> str | None:
    return next((found for name in NAMES if (found := shutil.which(name))), None)


def _of_playwright(playwright: Playwright) -> str | None:
    path = Path(playwright.chromium.executable_path)
    return str(path) if path.exists() else None


def _install() -> None:
    """From the system's packages where we may, else Playwright's own build."""
    if os.geteuid() == 0 and shutil.which("apt-get"):
        quiet = os.environ | {"DEBIAN_FRONTEND": "noninteractive"}
        commands = (["apt-get", "update"], ["apt-get", "install", "-y", "chromium"])
        if all(
            subprocess.run(command, env=quiet, check=False).returncode == 0 for command in commands
        ):
            return
    subprocess.run([sys.executable, "-m", "playwright", "install", "chromium"], check=False)
