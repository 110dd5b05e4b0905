// The head of a plan: what was asked, how far it is, and what can be done with it.

import { byId, h } from "./dom.js";
import { STATES, stateOf } from "./state.js";

const UNDER_WAY = new Set(["queued", "planning", "executing"]);

export class Banner {
  constructor(actions) {
    this.actions = actions;
    this.root = byId("banner");
    this.timer = null;
    this.title = h("h2", { id: "banner-title" });
    this.sentence = h("p", { class: "sentence" });
    // The same element all the time: what reads the page aloud follows its text.
    this.status = h("p", { role: "status" });
    this.rest = h("div");
    this.lost = h("p", { class: "problem", role: "alert", hidden: true });
    this.root.append(this.title, this.sentence, this.status, this.lost, this.rest);
  }

  hide() {
    this.root.hidden = true;
    this.away(false);
    clearInterval(this.timer);
    this.since = null;
    this.shown = null;
  }

  show(plan, execution) {
    const state = stateOf(plan, execution);
    const key = JSON.stringify([plan.id, state, execution?.id, execution?.identical, plan.replans, plan.executions, plan.error, execution?.error]);
    if (key === this.shown) return;
    if (state !== this.last || this.shown === null) this.since = performance.now();
    this.shown = key;
    this.last = state;
    clearInterval(this.timer);
    this.root.hidden = false;
    const under = UNDER_WAY.has(state);
    this.clock = h("span", { class: "clock", "aria-hidden": "true" });
    this.title.textContent = plan.planner ? "Instruction" : "Program by hand";
    this.sentence.textContent = plan.instruction;
    this.status.className = `status ${STATES[state].tone ?? ""}`;
    this.status.dataset.status = state;
    this.status.replaceChildren(STATES[state].words, ...(under ? [this.clock] : []));
    const focused = this.rest.contains(document.activeElement) ? document.activeElement.textContent : null;
    this.rest.replaceChildren(...[
      under && h("div", { class: "progress", role: "progressbar", "aria-label": STATES[state].words }),
      this.why(plan, execution),
      state === "awaiting_approval" && h("p", { class: "why" }, "Nothing has been moved. Read the program; it is carried out when you approve it."),
      this.buttons(plan, execution, state),
    ].filter(Boolean));
    // Whoever works by keyboard stays where they were, or at the first button if that one is gone.
    if (focused !== null) ([...this.rest.querySelectorAll("button, a, select")].find((each) => each.textContent === focused) ?? this.rest.querySelector("button"))?.focus();
    if (under) this.timer = setInterval(() => this.tick(), 200);
  }

  /** The service does not answer: nothing is known of what goes on, so no clock counts it. */
  away(away) {
    this.lost.hidden = !away;
    this.lost.textContent = away ? "The service cannot be reached. This goes on by itself when it is back." : "";
    this.root.classList.toggle("away", away);
  }

  tick() {
    const passed = (performance.now() - this.since) / 1000;
    this.clock.textContent = passed >= 1 ? ` · ${passed.toFixed(0)} s` : "";
  }

  why(plan, execution) {
    const failure = execution?.failure;
    const told = failure ? `Line ${failure.line}, at “${failure.stage}”: ${failure.reason}` : (execution?.error ?? plan.error);
    const also = [];
    if (plan.replans) also.push(`Planned anew ${plan.replans === 1 ? "once" : `${plan.replans} times`}.`);
    if (execution?.what_if) also.push(`This run was changed: ${changes(plan, execution)}.`);
    if (typeof execution?.identical === "boolean") also.push(execution.identical ? "The trace is the same, bit for bit." : "The trace differs from the run it repeats.");
    if (!told && !also.length) return null;
    return h("div", { class: "why" }, told && h("p", {}, told), ...also.map((text) => h("p", {}, text)));
  }

  buttons(plan, execution, state) {
    const { actions } = this;
    const button = (text, act, kind = "small") => h("button", { type: "button", class: kind, onclick: act }, text);
    const link = (text, href, name) => h("a", { class: "button small quiet", href, download: name }, text);
    const over = !UNDER_WAY.has(state) && state !== "awaiting_approval";
    return h("div", { class: "row" },
      state === "awaiting_approval" && button("Approve and run", actions.approve, "small primary"),
      !over && button("Cancel", actions.cancel),
      over && plan.program && button(execution ? "Again with another seed" : "Carry it out", actions.again),
      button("Use this task", actions.reuse),
      this.executions(plan, execution),
      execution && over && link("Recording", `/executions/${execution.id}/recording`, `${execution.id}.viser`),
      execution && button("Trace", () => actions.trace(execution.id), "small quiet"),
      plan.parent && h("a", { class: "button small quiet", href: `#/plans/${plan.parent}` }, "The plan before"),
      link("Plan as JSON", `/plans/${plan.id}`, `${plan.id}.json`),
    );
  }

  executions(plan, execution) {
    if (plan.executions.length < 2 || !execution) return null;
    const select = h("select", { class: "runs", "aria-label": "Which execution", onchange: () => this.actions.choose(select.value) },
      plan.executions.map((id, index) => h("option", { value: id, selected: id === execution.id }, `Run ${index + 1} of ${plan.executions.length}`)));
    return select;
  }

  fail(message) {
    if (this.root.hidden) {
      this.title.textContent = "This plan";
      this.sentence.textContent = "";
      this.status.replaceChildren();
      this.rest.replaceChildren();
    }
    this.root.hidden = false;
    this.shown = null;
    this.rest.querySelector(".problem")?.remove();
    this.rest.append(h("p", { class: "problem", role: "alert" }, message));
  }
}

/** In what a run differs from its plan. */
function changes(plan, { program, seed, begins_at_line }) {
  const told = [];
  if (program.trimEnd() !== plan.program.trimEnd()) told.push("another program than planned");
  if (seed !== plan.seed) told.push(`seed ${seed} instead of ${plan.seed}`);
  if (begins_at_line) told.push(`taken up before line ${begins_at_line}`);
  return told.join(", ") || "taken up where another run ended";
}
