// The request: what is asked for, from the form to POST /plans, and errors at their fields.

import { post } from "./api.js";
import { byId, h, submitOnCtrlEnter } from "./dom.js";
import { Faults } from "./faults.js";
import { recall, remember } from "./memory.js";
import { SceneEditor } from "./scene.js";
import { Settings } from "./settings.js";

export class RequestForm {
  /** `accepted(plan)` is called when the service has taken the request. */
  constructor(accepted) {
    this.accepted = accepted;
    this.form = byId("request");
    this.faults = new Faults(this.form, byId("problem"));
    this.settings = new Settings();
    this.scene = new SceneEditor({
      chosen: (ready) => this.takeTask(ready),
      refused: (error) => this.refuse(error),
    });
    // The goal that came with an instruction counts for that instruction only.
    this.task = recall("task", null);
    this.text = { instruction: byId("instruction"), program: byId("program"), goal: byId("goal") };
    for (const [name, area] of Object.entries(this.text)) {
      area.value = recall(name, "");
      area.addEventListener("input", () => this.typed(name));
    }
    this.form.addEventListener("submit", (event) => this.submit(event));
    this.form.addEventListener("change", (event) => event.target.name === "way" && this.showWay());
    submitOnCtrlEnter(this.form);
    byId("copy-curl").addEventListener("click", () => this.copyCurl());
    this.form.elements.way.value = recall("way", "instruction");
    this.showWay();
    this.countGoal();
  }

  async load() {
    await this.scene.load();
  }

  /** Take up the task of a ready scene, unless somebody has typed one of their own. */
  takeTask(ready) {
    this.faults.clear();
    this.task = { instruction: ready.instruction, goal: ready.goal.join("\n") };
    remember("task", this.task);
    this.text.instruction.placeholder = ready.instruction;
    const typed = this.text.instruction.value.trim();
    if (typed && !this.scene.hasInstruction(typed)) return;
    this.set("instruction", ready.instruction);
    this.set("goal", this.task.goal);
  }

  /** Fill the form with what an earlier plan was asked. */
  take(plan) {
    this.scene.take(plan.given_scene);
    this.task = null;
    remember("task", null);
    this.set("instruction", plan.instruction);
    this.set("goal", plan.goal.join("\n"));
    if (!plan.planner) this.set("program", plan.program ?? "");
    this.form.elements.way.value = plan.planner ? "instruction" : "program";
    this.showWay();
    this.text[this.form.elements.way.value].focus();
  }

  set(name, value) {
    this.text[name].value = value;
    this.faults.clear();
    this.typed(name);
  }

  typed(name) {
    remember(name, this.text[name].value);
    if (name === "instruction" && this.task) this.swapGoal();
    this.countGoal();
  }

  swapGoal() {
    const its = this.text.instruction.value.trim() === this.task.instruction;
    const goal = this.text.goal.value;
    if (!its && goal === this.task.goal) this.set("goal", "");
    if (its && goal === "") this.set("goal", this.task.goal);
  }

  countGoal() {
    const number = this.goal().length;
    byId("goal-count").textContent = number ? `${number} condition${number > 1 ? "s" : ""}` : "none";
  }

  goal() {
    return this.text.goal.value.split("\n").map((line) => line.trim()).filter(Boolean);
  }

  showWay() {
    const way = this.form.elements.way.value;
    remember("way", way);
    byId("program-field").hidden = way !== "program";
    byId("instruction-field").hidden = way === "program";
  }

  request() {
    const request = { scene: this.scene.request(), ...this.settings.request() };
    if (this.form.elements.way.value === "program") {
      request.program = this.text.program.value;
      delete request.planner;
    } else {
      request.instruction = this.text.instruction.value;
    }
    if (this.goal().length) request.goal = this.goal();
    return request;
  }

  async submit(event) {
    event.preventDefault();
    if (this.busy) return;
    this.faults.clear();
    this.busy = true;
    const run = byId("run");
    run.disabled = true;
    run.textContent = "Sending …";
    try {
      // The key makes a request that was sent twice one plan.
      this.accepted(await post("/plans", this.request(), { "Idempotency-Key": crypto.randomUUID?.() ?? String(Math.random()) }));
    } catch (error) {
      this.faults.show(error);
    } finally {
      this.busy = false;
      run.disabled = false;
      run.textContent = "Run";
    }
  }

  refuse(error) {
    this.faults.clear();
    this.faults.show(error);
  }

  async copyCurl() {
    const button = byId("copy-curl");
    this.faults.clear();
    try {
      const body = JSON.stringify(this.request(), null, 1).replaceAll("'", "'\\''");
      await copy(`curl -X POST ${location.origin}/plans -H 'Content-Type: application/json' -d '${body}'`);
      button.textContent = "Copied";
      setTimeout(() => (button.textContent = "Copy as curl"), 1500);
    } catch (error) {
      this.faults.show(error);
    }
  }
}

async function copy(text) {
  if (navigator.clipboard && window.isSecureContext) return navigator.clipboard.writeText(text);
  const area = h("textarea", { class: "sr-only", "aria-hidden": "true" });
  area.value = text;
  document.body.append(area);
  area.select();
  document.execCommand("copy");
  area.remove();
}
