"""Jobs: durable work on two queues, put there in the same transaction as our own rows."""

from typing import Any, Literal

from dbos import DBOSClient, EnqueueOptions
from dbos import WorkflowSerializationFormat as Format
from sqlalchemy.orm import Session

from app.storage.database import Database

Queue = Literal["planning", "simulation"]
QUEUES: tuple[Queue, ...] = ("planning", "simulation")
APPLICATION = "progprompt"
VERSION = "1"
"""Pinned: work left by an earlier release of ours is taken up by the next one."""
POLLING_INTERVAL = 0.1  # [s]; twice as often costs a tenth of a core for every idle worker
WORKFLOWS: dict[Queue, str] = {"planning": "plan", "simulation": "execution"}
"""The workflow each queue runs; its one argument is the id of the plan or execution."""


class Jobs:
    """The way to have something done by a worker."""

    def __init__(self, database: Database) -> None:
        self._client = DBOSClient(
            system_database_engine=database.engine, application_name=APPLICATION
        )

    def register_queues(self) -> None:
        """Declare the queues; one job at a time for each worker."""
        for queue in QUEUES:
            self._client.register_queue(
                queue, worker_concurrency=1, polling_interval_sec=POLLING_INTERVAL
            )

    def enqueue(self, session: Session, queue: Queue, owner: str, job: str | None = None) -> None:
        """Have a worker of ``queue`` take care of the plan or execution ``owner``.

        The job exists if and only if the session's transaction is committed; ``job`` names it
        where the owner comes to the same queue more than once.
        """
        options: EnqueueOptions = {
            "queue_name": queue,
            "workflow_name": WORKFLOWS[queue],
            "workflow_id": job or owner,
            "app_version": VERSION,
            "serialization_type": Format.PORTABLE,
        }
        self._client.enqueue_in_transaction(session, options, owner)

    def close(self) -> None:
        """Let go of the queues."""
        self._client.destroy()


def worker_config(database: Database, worker_id: str) -> dict[str, Any]:
    """How DBOS is set up in a worker process."""
    return {
        "name": APPLICATION,
        "system_database_engine": database.engine,
        "executor_id": worker_id,
        "application_version": VERSION,
        "log_level": "WARNING",
        "run_migrations": False,
    }
