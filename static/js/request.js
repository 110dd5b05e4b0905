// The request: what is asked for, from the form to POST /plans, and errors at their fields.

import { post, Problem } from "./api.js";
import { byId, h } from "./dom.js";
import { recall, remember } from "./memory.js";
import { SceneEditor } from "./scene.js";
import { Settings } from "./settings.js";

export class RequestForm {
  /** `accepted(plan)` is called when the service has taken the request. */
  constructor(accepted) {
    this.accepted = accepted;
    this.form = byId("request");
    this.settings = new Settings();
    this.scene = new SceneEditor((ready) => this.takeTask(ready));
    // The goal that came with an instruction counts for that instruction only.
    this.task = recall("task", null);
    this.text = { instruction: byId("instruction"), program: byId("program"), goal: byId("goal") };
    for (const [name, area] of Object.entries(this.text)) {
      area.value = recall(name, "");
      area.addEventListener("input", () => this.typed(name));
    }
    this.form.addEventListener("submit", (event) => this.submit(event));
    this.form.addEventListener("change", (event) => event.target.name === "way" && this.showWay());
    document.addEventListener("keydown", (event) => {
      if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) this.form.requestSubmit();
    });
    byId("copy-curl").addEventListener("click", () => this.copyCurl());
    this.form.elements.way.value = recall("way", "instruction");
    this.showWay();
    this.countGoal();
  }

  async load() {
    await this.scene.load();
  }

  takeTask(ready) {
    this.task = { instruction: ready.instruction, goal: ready.goal.join("\n") };
    remember("task", this.task);
    this.set("instruction", ready.instruction);
    this.set("goal", this.task.goal);
  }

  /** Fill the form with what an earlier plan was asked. */
  take(plan) {
    this.scene.take(plan.scene);
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
    this.clear();
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
    this.clear();
    this.busy = true;
    const run = byId("run");
    run.disabled = true;
    run.textContent = "Sending …";
    try {
      // The key makes a request that was sent twice one plan.
      this.accepted(await post("/plans", this.request(), { "Idempotency-Key": crypto.randomUUID?.() ?? String(Math.random()) }));
    } catch (error) {
      this.fail(error);
    } finally {
      this.busy = false;
      run.disabled = false;
      run.textContent = "Run";
    }
  }

  /** Show an error where it belongs; what belongs nowhere is shown above the button. */
  fail(error) {
    const faults = error instanceof Problem ? error.errors : [];
    const homeless = faults.filter((fault) => !this.mark(fault));
    const told = homeless.length ? homeless.map((fault) => `${fault.field}: ${fault.message}`).join("\n") : error.message;
    const problem = byId("problem");
    problem.hidden = false;
    problem.textContent = faults.length && !homeless.length ? "Something has to be mended; see the marked fields." : told;
    this.form.querySelector('[aria-invalid="true"]')?.focus();
  }

  mark({ field, message }) {
    const path = field.split(".");
    while (path.length) {
      const place = this.form.querySelector(`[data-field="${CSS.escape(path.join("."))}"]`);
      if (place) return this.markAt(place, field, message);
      path.pop();
    }
    return false;
  }

  markAt(place, field, message) {
    for (let part = place; part; part = part.parentElement.closest("details")) part.open = true;
    const control = place.matches("input, textarea") ? place : place.querySelector("textarea:not([hidden]), input, select");
    const id = `fault-${field}`;
    const goalLine = /^goal\.(\d+)/.exec(field);
    const text = goalLine ? `Line ${Number(goalLine[1]) + 1} ${message}` : message;
    (place.matches("input") ? place.closest("li") : place).append(h("p", { class: "fault", id }, text));
    if (place.dataset.field !== "scene") {
      control?.setAttribute("aria-invalid", "true");
      control?.setAttribute("aria-describedby", id);
    }
    return true;
  }

  clear() {
    byId("problem").hidden = true;
    this.form.querySelectorAll(".fault").forEach((fault) => fault.remove());
    this.form.querySelectorAll("[aria-invalid]").forEach((control) => {
      control.removeAttribute("aria-invalid");
      control.removeAttribute("aria-describedby");
    });
  }

  async copyCurl() {
    const button = byId("copy-curl");
    try {
      const body = JSON.stringify(this.request(), null, 1).replaceAll("'", "'\\''");
      await copy(`curl -X POST ${location.origin}/plans -H 'Content-Type: application/json' -d '${body}'`);
      button.textContent = "Copied";
      setTimeout(() => (button.textContent = "Copy as curl"), 1500);
    } catch (error) {
      this.fail(error);
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
