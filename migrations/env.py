"""Where Alembic meets our tables.

The service hands over the connection on which it holds the migration lock. On the command line:
``alembic -x url=sqlite:///some.sqlite revision --autogenerate -m "what changes"``.
"""

from alembic import context
from sqlalchemy import Connection, create_engine

from app.storage import assets, evaluations, events, executions, frames, plans, scenes, workers
from app.storage.base import Base

TABLES = (
    assets,
    evaluations,
    events,
    executions,
    frames,
    plans,
    scenes,
    workers,
)  # imported for their side effect


def migrate(connection: Connection) -> None:
    """Run the migrations on this connection."""
    context.configure(
        connection=connection,
        target_metadata=Base.metadata,
        transactional_ddl=True,
        render_as_batch=True,
    )
    with context.begin_transaction():
        context.run_migrations()


given = context.config.attributes.get("connection")
if given is not None:
    migrate(given)
else:
    engine = create_engine(context.get_x_argument(as_dictionary=True)["url"])
    with engine.begin() as opened:
        migrate(opened)
