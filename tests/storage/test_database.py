import subprocess
import sys
from datetime import datetime

import pytest
from alembic import command
from alembic.autogenerate import compare_metadata
from alembic.config import Config
from alembic.migration import MigrationContext
from sqlalchemy import MetaData, func, inspect, select

from app.storage import executions
from app.storage.base import Base, now
from app.storage.database import MIGRATIONS, Database

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


VALUES = {str: "1", int: 1, bool: True, float: 1.0, datetime: now(), bytes: b"1", object: {}}
"""The same number everywhere, so that rows refer to one another."""


@pytest.fixture
def first_release(engine):
    """A database as 0.1.0 left it, with a row in each of its tables."""
    with engine.empty() as url:
        database = Database(url)
        with database.engine.begin() as connection:
            config = Config()
            config.set_main_option("script_location", str(MIGRATIONS))
            config.attributes["connection"] = connection
            command.upgrade(config, "0001")
            tables = _tables(connection)
            for table in tables:
                row = {column.name: VALUES[column.type.python_type] for column in table.columns}
                connection.execute(table.insert().values(row))
        yield database, [table.name for table in tables]
        database.close()


def _tables(connection):
    found = MetaData()
    found.reflect(connection)
    return [table for table in found.sorted_tables if table.name != "alembic_version"]


def test_an_upgrade_keeps_every_row_of_the_first_release(first_release):
    database, names = first_release
    database.migrate()
    assert {"plans", "executions", "frames"} <= set(names)
    with database.engine.connect() as connection:
        counts = {
            table.name: connection.scalar(select(func.count()).select_from(table))
            for table in _tables(connection)
            if table.name in names
        }
    assert counts == dict.fromkeys(names, 1)
    with database.reading() as session:
        assert executions.get(session, "1").program == "1"


def test_an_upgrade_that_would_lose_a_row_others_refer_to_does_nothing(sqlite):
    with sqlite.empty() as url:
        database = Database(url)
        with database.engine.connect() as connection:
            connection.exec_driver_sql("PRAGMA foreign_keys = OFF")
            connection.exec_driver_sql("CREATE TABLE ours (id INTEGER PRIMARY KEY)")
            connection.exec_driver_sql("CREATE TABLE others (id INTEGER REFERENCES ours)")
            connection.exec_driver_sql("INSERT INTO others VALUES (1)")
            connection.commit()
        database.engine.dispose()
        with pytest.raises(RuntimeError, match="others to ours"):
            database.migrate()
        with database.engine.connect() as connection:
            assert not inspect(connection).has_table("plans")
            assert connection.exec_driver_sql("PRAGMA foreign_keys").scalar() == 1
        database.close()


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
