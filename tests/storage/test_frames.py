import struct

from app.domain.trace import Frame
from app.storage import frames


def some(first, count):
    return [
        Frame(time=n / 10, positions=(float(n), -float(n))) for n in range(first, first + count)
    ]


def indices(data):
    return [round(row[1]) for row in struct.iter_unpack("<3f", data)]


def test_frames_come_back_as_packed_rows_of_time_and_positions(database, execution):
    with database.transaction() as session:
        frames.append(session, execution.id, 0, some(0, 3))
    with database.reading() as session:
        data, width = frames.read(session, execution.id)
    assert width == 3
    assert struct.unpack_from("<3f", data, 12) == (
        struct.unpack("<f", struct.pack("<f", 0.1))[0],
        1,
        -1,
    )


def test_a_repeated_run_adds_only_the_frames_that_are_new_wherever_its_parts_begin(
    database, execution
):
    for first, count in ((0, 5), (5, 4), (3, 4), (7, 6)):
        with database.transaction() as session:
            frames.append(session, execution.id, first, some(first, count))
    with database.reading() as session:
        assert indices(frames.read(session, execution.id)[0]) == list(range(13))
        assert frames.count(session, execution.id) == 13


def test_reading_may_start_in_the_middle_of_a_part(database, execution):
    with database.transaction() as session:
        frames.append(session, execution.id, 0, some(0, 5))
        frames.append(session, execution.id, 5, some(5, 5))
    with database.reading() as session:
        assert indices(frames.read(session, execution.id, 3)[0]) == [3, 4, 5, 6, 7, 8, 9]
        assert frames.read(session, execution.id, 10) == (b"", 0)
