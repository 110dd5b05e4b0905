import threading
import time

from app.domain.asset import Asset
from app.storage import assets

CUP = Asset(
    id="as_1",
    name="cup",
    category="cup",
    colour="red",
    density=600.0,
    size=(0.1, 0.1, 0.1),
    shape=b"",
)


def keep(database, found):
    with database.transaction() as session:
        counts = {"faces": 12, "parts": 1, "file_bytes": 100}
        found.append(assets.add(session, CUP, mass=0.1, counts=counts).serial)
        time.sleep(0.3)


def test_an_asset_kept_twice_at_the_same_time_is_one_asset(database):
    found = []
    threads = [threading.Thread(target=keep, args=(database, found)) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [1, 1]
