import os
import time

import pytest

from app.evaluation.processes import processes
from tests.processes import runs


def test_whoever_leaves_early_leaves_nothing_running():
    started = []

    def leave():
        with processes(1) as pool:
            started.append(pool.submit(os.getpid).result())
            pool.submit(time.sleep, 1000)
            raise LookupError

    with pytest.raises(LookupError):
        leave()
    assert not runs(*started)
