"""Registry: the modules of one folder by the name they register under."""

import importlib
import pkgutil
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Generic, TypeVar

from app.domain.errors import UnknownName

T = TypeVar("T")
Registered = TypeVar("Registered")


class Registry(Mapping[str, T], Generic[T]):
    """What the modules of a folder register, by name; they are imported at the first look-up.

    A double name or a module that fails to import is an error at once.
    """

    def __init__(self, package: str, noun: str) -> None:
        self._package = package
        self._noun = noun
        self._entries: dict[str, T] = {}
        self._loaded = False

    def register(self, name: str) -> Callable[[type[Registered]], type[Registered]]:
        """Class decorator: one instance of the class is registered under ``name``."""

        def add(cls: type[Registered]) -> type[Registered]:
            self.add(name, cls())  # pyright: ignore[reportArgumentType]
            return cls

        return add

    def add(self, name: str, entry: T) -> T:
        """Register ``entry`` under ``name``."""
        if name in self._entries:
            raise ValueError(f"two entries of {self._package} are called {name!r}")
        self._entries[name] = entry
        return entry

    @contextmanager
    def temporarily(self, name: str, entry: T) -> Iterator[T]:
        """Have ``entry`` under ``name`` for as long as the context lasts."""
        self._load()
        self.add(name, entry)
        try:
            yield entry
        finally:
            del self._entries[name]

    def __getitem__(self, name: str) -> T:
        entries = self._load()
        if name not in entries:
            raise UnknownName(self._noun, name, entries)
        return entries[name]

    def __contains__(self, name: object) -> bool:
        return name in self._load()

    def __iter__(self) -> Iterator[str]:
        return iter(sorted(self._load()))

    def __len__(self) -> int:
        return len(self._load())

    def _load(self) -> dict[str, T]:
        if not self._loaded:
            package = importlib.import_module(self._package)
            for module in pkgutil.iter_modules(package.__path__):
                importlib.import_module(f"{self._package}.{module.name}")
            self._loaded = True
        return self._entries
