# MuJoCo is a compiled module without stubs: its names are taken as they come.
from typing import Any

def __getattr__(name: str) -> Any: ...
