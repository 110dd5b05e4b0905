"""Robot models that Python packages bring along; the packages themselves are not imported."""

from importlib.util import find_spec
from pathlib import Path


def packaged_file(package: str, path: str) -> str:
    """Where a file of an installed package is.

    Args:
        package: as it would be imported.
        path: of the file, from the package's folder.

    Raises:
        ModuleNotFoundError: the package is not installed.
    """
    found = find_spec(package)
    if found is None or found.origin is None:
        raise ModuleNotFoundError(f"{package}, which brings {Path(path).name}, is not installed")
    return str(Path(found.origin).parent / path)
