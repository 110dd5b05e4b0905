"""Dialogue, replanning and what-if: plans with parents and tries, executions with their own program."""

import sqlalchemy as sa
from alembic import op

revision = "0002"
down_revision = "0001"
branch_labels = None
depends_on = None


def upgrade():
    with op.batch_alter_table("plans", schema=None) as batch_op:
        batch_op.add_column(sa.Column("options", sa.JSON(), nullable=False, server_default="{}"))
        batch_op.add_column(sa.Column("parent", sa.String(length=32), nullable=True))
        batch_op.add_column(sa.Column("confidence", sa.Double(), nullable=True))
        batch_op.add_column(sa.Column("declined", sa.JSON(), nullable=True))
        batch_op.add_column(sa.Column("tries", sa.JSON(), nullable=False, server_default="[]"))

    with op.batch_alter_table("executions", schema=None) as batch_op:
        batch_op.add_column(sa.Column("program", sa.Text(), nullable=False, server_default=""))
        batch_op.add_column(sa.Column("options", sa.JSON(), nullable=False, server_default="{}"))
        batch_op.add_column(sa.Column("begins_after", sa.String(length=32), nullable=True))
        batch_op.add_column(sa.Column("begins_at_line", sa.Integer(), nullable=True))
        batch_op.add_column(sa.Column("rerun_of", sa.String(length=32), nullable=True))
        batch_op.add_column(sa.Column("identical", sa.Boolean(), nullable=True))
        batch_op.drop_column("checkpoint")

    op.execute(
        "UPDATE executions SET program ="
        " COALESCE((SELECT program FROM plans WHERE plans.id = executions.plan_id), '')"
    )
    op.create_table(
        "checkpoints",
        sa.Column("serial", sa.Integer(), nullable=False),
        sa.Column("execution_id", sa.String(length=32), nullable=False),
        sa.Column("step", sa.Integer(), nullable=False),
        sa.Column("state", sa.LargeBinary(), nullable=False),
        sa.ForeignKeyConstraint(
            ["execution_id"], ["executions.id"], name=op.f("fk_checkpoints_execution_id")
        ),
        sa.PrimaryKeyConstraint("serial", name=op.f("pk_checkpoints")),
        sa.UniqueConstraint("execution_id", "step", name=op.f("uq_checkpoints_execution_id")),
    )


def downgrade():
    op.drop_table("checkpoints")
    with op.batch_alter_table("executions", schema=None) as batch_op:
        batch_op.add_column(sa.Column("checkpoint", sa.LargeBinary(), nullable=True))
        for name in (
            "identical",
            "rerun_of",
            "begins_at_line",
            "begins_after",
            "options",
            "program",
        ):
            batch_op.drop_column(name)

    with op.batch_alter_table("plans", schema=None) as batch_op:
        for name in ("tries", "declined", "confidence", "parent", "options"):
            batch_op.drop_column(name)
