// What comes next in the dialogue: an answer to a question, or another wish about the same scene.

import { post } from "./api.js";
import { byId, h } from "./dom.js";
import { recall, remember } from "./memory.js";

export class FollowUp {
  /** `accepted(plan)` is called when the service has taken the next plan; `settings()` are the form's. */
  constructor({ accepted, settings }) {
    this.accepted = accepted;
    this.settings = settings;
    this.root = byId("followup");
    this.hide();
  }

  hide() {
    this.root.hidden = true;
    this.plan = null;
  }

  /** Offer to go on from a plan that has ended. */
  show(plan) {
    const key = JSON.stringify([plan.id, plan.declined]);
    if (this.plan && this.key === key) return;
    this.key = key;
    this.plan = plan;
    const name = `next-${plan.id}`;
    this.input = h("input", {
      id: "next", maxlength: 1000, autocomplete: "off",
      placeholder: suggestion(plan),
      oninput: () => remember(name, this.input.value),
    });
    this.input.value = recall(name, "");
    this.problem = h("p", { class: "problem", role: "alert", hidden: true });
    this.button = h("button", { type: "submit", class: "small primary" }, "Go on");
    const question = plan.declined?.question;
    const form = h("form", { class: "next", onsubmit: (event) => this.submit(event) },
      h("label", { for: "next" }, question ?? (plan.declined ? "Say it another way" : "And then?")),
      h("div", { class: "row" }, this.input, this.button));
    const choices = (plan.declined?.choices ?? []).map((choice) =>
      h("li", {}, h("button", { type: "button", class: "small choice", onclick: () => this.send(choice) }, choice)));
    this.root.replaceChildren(...[form, choices.length && h("ul", { class: "choices", "aria-label": "Choices" }, choices), this.problem].filter(Boolean));
    this.root.hidden = false;
  }

  submit(event) {
    event.preventDefault();
    if (this.input.value.trim()) this.send(this.input.value);
    else this.input.focus();
  }

  async send(instruction) {
    if (this.busy) return;
    this.busy = true;
    this.button.disabled = true;
    this.problem.hidden = true;
    const parent = this.plan.id;
    try {
      const plan = await post("/plans", { ...this.settings(), parent, instruction });
      remember(`next-${parent}`, "");
      this.accepted(plan);
    } catch (error) {
      this.problem.textContent = error.message;
      this.problem.hidden = false;
    } finally {
      this.busy = false;
      this.button.disabled = false;
    }
  }
}

/** Something that could be said next, and would be understood. */
function suggestion({ declined, scene, status, steps }) {
  if (declined?.choices.length) return declined.choices[0];
  if (declined || status === "failed") return "say it in your own words";
  const used = new Set(steps.flatMap((step) => step.arguments));
  const left = scene.world === "tabletop" && scene.objects.find((thing) => !thing.container && !used.has(thing.name));
  return left ? `now the ${left.name}` : "say what comes next";
}
