// What if: the program with a line changed, or another seed, from the state before a line.

import { post } from "./api.js";
import { byId, h } from "./dom.js";
import { Faults } from "./faults.js";

export class WhatIf {
  /** `started(execution)` is called when the changed run has been taken. */
  constructor(started) {
    this.started = started;
    this.root = byId("whatif");
    this.problem = h("p", { class: "problem", role: "alert", hidden: true });
    this.faults = new Faults(this.root, this.problem);
    this.hide();
  }

  hide() {
    this.root.hidden = true;
    this.execution = null;
  }

  /** Offer to change the execution of a plan that has ended; what is being typed stays. */
  show(plan, execution) {
    if (this.execution?.id === execution.id) return;
    this.plan = plan;
    this.execution = execution;
    const text = execution.program.replace(/\n+$/, "");
    const rows = text.split("\n").length;
    this.text = h("textarea", { id: "whatif-program", class: "code", rows: Math.min(rows + 1, 16), spellcheck: "false" });
    this.text.value = text;
    this.line = h("input", { id: "whatif-line", type: "number", min: 1, max: rows, step: 1, placeholder: "the beginning" });
    this.seed = h("input", { id: "whatif-seed", type: "number", min: 0, max: 4294967295, step: 1 });
    this.seed.value = execution.seed;
    const field = (label, control) => h("div", { class: "field", "data-field": control.id.replace("whatif-", "") }, h("label", { for: control.id }, label), control);
    this.root.replaceChildren(
      h("summary", {}, "What if …"),
      h("p", { class: "hint" }, "Change a line or the seed; the world is taken over as it stood before the line."),
      field("Program", this.text),
      h("div", { class: "settings" }, field("From line", this.line), field("Seed", this.seed)),
      h("div", { class: "row" },
        h("button", { type: "button", class: "small", onclick: () => this.run() }, "Run it so"),
        h("button", { type: "button", class: "small quiet", onclick: () => this.repeat() }, "Repeat unchanged and compare")),
      this.problem);
    this.faults.clear();
    this.root.hidden = false;
  }

  run() {
    const body = { program: `${this.text.value}\n`, seed: Number(this.seed.value) };
    const line = Number(this.line.value || 1);
    if (line !== 1) Object.assign(body, { after: this.execution.id, line });
    return this.start(`/plans/${this.plan.id}/executions`, body);
  }

  repeat() {
    return this.start(`/executions/${this.execution.id}/rerun`);
  }

  async start(path, body) {
    this.faults.clear();
    try {
      this.started(await post(path, body));
    } catch (error) {
      this.faults.show(error);
    }
  }
}
