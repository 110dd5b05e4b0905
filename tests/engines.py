"""The kinds of database the tests run on, and where each keeps the queues."""

from app.storage.database import Database

ENGINES = ("sqlite", "postgres")
"""Names of fixtures that make databases."""


def workflows_table(database: Database) -> str:
    """The table that DBOS keeps its workflows in."""
    postgres = database.engine.dialect.name == "postgresql"
    return "dbos.workflow_status" if postgres else "workflow_status"
