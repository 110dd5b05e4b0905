import subprocess
import sys

import pytest
from alembic.autogenerate import compare_metadata
from alembic.migration import MigrationContext
from sqlalchemy import inspect

from app.storage.base import Base
from app.storage.database import Database

MIGRATE = "import sys; from app.storage.database import Database; Database(sys.argv[1]).migrate()"


def test_four_processes_may_migrate_the_same_new_database_at_once(engine):
    with engine.empty() as url:
        command = [sys.executable, "-c", MIGRATE, url]
        processes = [subprocess.Popen(command, stderr=subprocess.PIPE, text=True) for _ in range(4)]
        ends = [(process.communicate()[1], process.returncode) for process in processes]
    assert [code for _, code in ends] == [0, 0, 0, 0], ends


def test_the_migrations_build_exactly_the_tables_of_the_code(database):
    ours = set(Base.metadata.tables)
    with database.engine.connect() as connection:
        context = MigrationContext.configure(
            connection,
            opts={"include_name": lambda name, kind, _: kind != "table" or name in ours},
        )
        assert compare_metadata(context, Base.metadata) == []


def test_a_file_database_is_in_wal_mode_with_foreign_keys(sqlite):
    with sqlite.migrated() as url, Database(url).engine.connect() as connection:
        assert connection.exec_driver_sql("PRAGMA journal_mode").scalar() == "wal"
        assert connection.exec_driver_sql("PRAGMA foreign_keys").scalar() == 1


def test_a_failed_transaction_leaves_nothing_behind(database):
    def half():
        with database.transaction() as session:
            session.connection().exec_driver_sql("CREATE TABLE half (done INTEGER)")
            raise RuntimeError

    with pytest.raises(RuntimeError):
        half()
    assert not inspect(database.engine).has_table("half")


def test_a_reader_sees_nothing_of_an_open_transaction_and_does_not_wait(database):
    other = Database(database.url)
    with database.transaction() as session:
        session.connection().exec_driver_sql("CREATE TABLE first (done INTEGER)")
        with other.reading() as reader:
            assert not inspect(reader.connection()).has_table("first")
    with other.transaction() as session:
        session.connection().exec_driver_sql("INSERT INTO first VALUES (1)")
    other.close()
