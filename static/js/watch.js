// One plan being watched: its events led to the program, the 3D view, the words and the scores.

import { all, follow, get, post } from "./api.js";
import { Banner } from "./banner.js";
import { byId, reveal, save } from "./dom.js";
import { EventList } from "./events.js";
import { FollowUp } from "./followup.js";
import { ProgramView } from "./program.js";
import { RolloutView } from "./rollout.js";
import { ScoreBoard } from "./scores.js";
import { isOver, stateOf } from "./state.js";
import { WhatIf } from "./whatif.js";

const LIT_BY = new Set(["comment_reached", "action_started", "assertion_checked", "call_skipped", "recovery_taken", "branch_decided"]);
const NO_FAILURE = new Set(["asked", "declined"]);

export class Watch {
  /**
   * `reuse(plan)` puts a plan's task back into the form; `changed(plan)` is told every new state;
   * `followed(plan)` of a plan that follows this one, asked for with the form's `settings()`.
   */
  constructor({ reuse, changed, followed, settings }) {
    this.changed = changed;
    this.followUp = new FollowUp({ accepted: followed, settings });
    this.whatIf = new WhatIf((execution) => this.open(this.plan.id, execution.id));
    const seek = (time) => this.rollout.seek(time);
    this.program = new ProgramView(seek);
    this.events = new EventList(seek);
    this.scores = new ScoreBoard();
    this.rollout = new RolloutView((time) => this.playedTo(time));
    this.banner = new Banner({
      reuse: () => reuse(this.plan),
      cancel: () => this.cancel(),
      approve: () => this.approve(),
      again: () => this.runAgain(),
      trace: (execution) => this.saveTrace(execution),
      choose: (execution) => this.open(this.plan.id, execution),
    });
    this.close();
  }

  close() {
    this.stop?.();
    this.stop = null;
    this.id = null;
    this.plan = null;
    this.execution = null;
    this.known = -1;
    this.unplanned = null;
    this.banner.hide();
    this.followUp.hide();
    this.whatIf.hide();
    this.program.reset();
    this.clearRun();
    this.rollout.reset();
    this.events.reset();
  }

  clearRun() {
    this.moments = [];
    this.running = null;
    this.latest = null;
    this.scores.reset();
  }

  /** Watch a plan, and of its executions the one named or the newest. */
  async open(id, execution = null) {
    this.close();
    this.id = id;
    this.wanted = execution;
    const plan = await this.refresh(id);
    if (!plan) return;
    this.program.reset(plan.program || isOver(plan) ? "There is no program." : "The program appears here as it is written …");
    this.events.reset("Nothing has happened yet.");
    if (isOver(plan) && !plan.executions.length) this.rollout.reset("This plan was not carried out.");
    else this.rollout.reset("The rollout begins when the program is there.");
    if (plan.program) this.program.show(plan);
    this.followPlanning(id);
  }

  followPlanning(id) {
    this.stop = follow(`/plans/${id}/events`, {
      told: (event) => this.planned(event),
      ended: () => this.planningOver(id),
      away: (away) => this.banner.away(away),
      after: this.known,
    });
  }

  async refresh(id = this.id) {
    try {
      const plan = await get(`/plans/${id}`);
      if (this.id !== id) return null;
      this.plan = plan;
      this.banner.show(plan, this.execution);
      if (isOver(plan)) this.followUp.show(plan);
      else this.followUp.hide();
      this.changed(plan);
      return plan;
    } catch (error) {
      if (this.id === id) this.banner.fail(error.message);
      return null;
    }
  }

  planned(event) {
    this.known = event.sequence;
    // Whether that is a failure, a refusal or a question, the plan tells when it is over.
    if (event.kind === "planning_failed") this.unplanned = event;
    else this.events.add(event);
    if (event.kind === "planning_started") {
      this.program.begin();
      if (this.plan.status === "queued") {
        this.plan.status = "planning";
        this.banner.show(this.plan, null);
      }
    }
    if (event.kind === "completion_continued") this.program.keep(event.kept);
    if (event.kind === "completion_grew") this.program.grow(event.text);
  }

  async planningOver(id) {
    const plan = await this.refresh(id);
    if (!plan) return;
    this.program.show(plan);
    if (this.unplanned) this.events.add({ ...this.unplanned, kind: NO_FAILURE.has(stateOf(plan)) ? stateOf(plan) : "planning_failed" });
    const execution = this.wanted ?? plan.executions.at(-1);
    if (execution) this.watchExecution(execution);
    else {
      if (plan.status === "awaiting_approval") reveal(byId("result"));
      this.rollout.reset(plan.status === "awaiting_approval" ? "The rollout begins when you approve the plan." : "This plan was not carried out.");
      if (isOver(plan)) this.scores.reset("Nothing was carried out, so there is nothing to score.");
      this.scores.show(plan, null);
    }
  }

  async watchExecution(execution) {
    const id = this.id;
    this.wanted = execution;
    this.rollout.show(execution);
    // Its program comes first: a changed one has other lines than the plan's.
    await this.refreshExecution(id, execution);
    if (this.id !== id || this.wanted !== execution) return;
    this.stop = follow(`/executions/${execution}/events`, {
      told: (event) => this.happened(event),
      ended: () => this.executionOver(id, execution),
      away: (away) => this.banner.away(away),
    });
  }

  async executionOver(id, execution) {
    await this.refreshExecution(id, execution);
    await this.refresh(id);
    if (this.id !== id) return;
    if (this.running) this.program.note(this.running, "stopped", "stopped before it was done");
    this.scores.show(this.plan, this.execution);
    if (!isOver(this.plan) && this.plan.tries.at(-1)?.execution === execution) this.planAnew(id);
    else if (this.execution) this.whatIf.show(this.plan, this.execution);
  }

  /** What is left is planned anew: the next program, and the run that goes on from here. */
  planAnew(id) {
    this.execution = null;
    this.wanted = null;
    this.clearRun();
    this.banner.show(this.plan, null);
    this.followPlanning(id);
  }

  async refreshExecution(id, execution) {
    const shown = await get(`/executions/${execution}`).catch(() => null);
    if (this.id !== id || !shown) return;
    this.execution = shown;
    if (shown.program !== this.program.source) this.program.show({ ...this.plan, program: shown.program, steps: shown.steps, rejected: [], ...(shown.what_if && { usage: null }) });
    this.banner.show(this.plan, shown);
  }

  happened(event) {
    this.events.add(event);
    if (LIT_BY.has(event.kind)) {
      this.moments.push([event.time, event.line]);
      this.program.startsAt(event.line, event.time);
    }
    if (event.kind === "execution_finished") this.moments.push([event.time, null]);
    if (event.kind === "goal_checked") this.scores.check(event);
    this.mark(event);
    if (!this.rollout.moment) this.program.light(this.moments.at(-1)?.[1] ?? null);
  }

  mark(event) {
    const note = (state, text = "") => this.program.note(event.line, state, text);
    if (event.kind === "action_performed" || event.kind === "action_failed") this.running = null;
    switch (event.kind) {
      case "action_started":
        this.running = event.line;
        return note("running");
      case "action_performed":
        return note("performed", event.attempts > 1 ? `at attempt ${event.attempts}` : "");
      case "action_failed":
        return note("failed", `${event.stage}: ${event.reason}`);
      case "call_skipped":
        return note("skipped", event.reason);
      case "assertion_checked":
        return note(event.holds ? "holds" : "broken", event.holds ? "true" : "false");
      case "branch_decided":
        return note(event.holds ? "holds" : "broken", event.holds ? "yes" : "no");
      case "recovery_taken":
        return note("broken", event.calls ? "false, recovering" : "false, no recovery");
    }
  }

  /** The 3D view shows this moment [s]. */
  playedTo(time) {
    let line = null;
    for (const [start, at] of this.moments) {
      if (start > time + 0.001) break;
      line = at;
    }
    this.program.light(line);
    const tenths = Math.round(time * 10);
    if (tenths !== this.latest) {
      this.latest = tenths;
      this.events.at(time);
    }
  }

  approve() {
    return this.act(`/plans/${this.id}/approve`, () => this.open(this.id));
  }

  /** What is under way is stopped: of a plan that is over, a what-if or a repetition. */
  cancel() {
    const running = isOver(this.plan) && this.execution;
    return this.act(`${running ? `/executions/${running.id}` : `/plans/${this.id}`}/cancel`, () => this.refresh());
  }

  async act(path, then) {
    try {
      await post(path);
      await then();
    } catch (error) {
      this.banner.fail(error.message);
    }
  }

  /** A long rollout's trace comes in parts, which are one file. */
  async saveTrace(execution) {
    try {
      save(`${execution}.json`, JSON.stringify({ items: await all(`/executions/${execution}/trace`) }));
    } catch (error) {
      this.banner.fail(error.message);
    }
  }

  async runAgain() {
    try {
      // The first run is the plan's own; with another seed it would be a what-if.
      const changed = this.execution ? { seed: (this.execution.seed + 1) % 4294967296 } : {};
      const execution = await post(`/plans/${this.id}/executions`, changed);
      await this.open(this.id, execution.id);
    } catch (error) {
      this.banner.fail(error.message);
    }
  }
}
