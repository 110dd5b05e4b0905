// How the state of a plan is told: the same words and tone wherever it is shown.

export const STATES = {
  queued: { words: "Waiting for its turn" },
  planning: { words: "Writing the program" },
  planned: { words: "Planned", tone: "good" },
  awaiting_approval: { words: "Waiting for your approval", tone: "warn" },
  executing: { words: "Carrying it out" },
  succeeded: { words: "Succeeded", tone: "good" },
  failed: { words: "Failed", tone: "bad" },
  asked: { words: "Asked back, nothing was moved", tone: "warn", brief: "asked back" },
  declined: { words: "Declined, nothing was moved", tone: "warn" },
  cancelled: { words: "Cancelled", tone: "warn" },
};

const OVER = new Set(["planned", "succeeded", "failed", "cancelled"]);

export const isOver = (plan) => OVER.has(plan.status);

/** The state of a plan; of several executions the one that is shown counts. */
export function stateOf(plan, execution = null) {
  if (execution) return execution.status;
  if (!plan.declined || plan.executions.length) return plan.status;
  return plan.declined.question ? "asked" : "declined";
}
