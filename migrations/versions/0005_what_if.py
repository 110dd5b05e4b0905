"""What if: executions that are changed or begin elsewhere are told from the plan's own."""

import sqlalchemy as sa
from alembic import op

revision = "0005"
down_revision = "0004"
branch_labels = None
depends_on = None


def upgrade():
    with op.batch_alter_table("executions", schema=None) as batch_op:
        batch_op.add_column(
            sa.Column("what_if", sa.Boolean(), nullable=False, server_default=sa.false())
        )
    # Another program may also come of planning anew, so that one alone tells nothing.
    op.execute(
        sa.text(
            "UPDATE executions SET what_if = :yes WHERE begins_at_line IS NOT NULL"
            " OR seed <> (SELECT seed FROM plans WHERE plans.id = executions.plan_id)"
        ).bindparams(sa.bindparam("yes", True, sa.Boolean()))
    )


def downgrade():
    with op.batch_alter_table("executions", schema=None) as batch_op:
        batch_op.drop_column("what_if")
