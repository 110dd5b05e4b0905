// What is wrong with a form, shown at the fields it names until they are changed.

import { Problem } from "./api.js";
import { h } from "./dom.js";

const MARKED = "Something has to be mended; see the marked fields.";
let marks = 0;

export class Faults {
  /** Fields of `form` bear `data-field`; what belongs to none of them is told in `problem`. */
  constructor(form, problem) {
    this.form = form;
    this.problem = problem;
    this.marks = [];
    for (const kind of ["input", "change"]) form.addEventListener(kind, ({ target }) => this.changed(target));
  }

  show(error) {
    const faults = error instanceof Problem ? error.errors : [];
    const homeless = faults.filter((fault) => !this.mark(fault));
    const told = homeless.length ? homeless.map((fault) => `${fault.field}: ${fault.message}`).join("\n") : error.message;
    this.problem.hidden = false;
    this.problem.textContent = faults.length && !homeless.length ? MARKED : told;
    this.form.querySelector('[aria-invalid="true"]')?.focus();
  }

  mark({ field, message }) {
    const path = field.split(".");
    while (path.length) {
      const place = this.form.querySelector(`[data-field="${CSS.escape(path.join("."))}"]`);
      if (place && !place.closest("[hidden]")) return this.markAt(place, field, message);
      path.pop();
    }
    return false;
  }

  markAt(place, field, message) {
    for (let part = place; part; part = part.parentElement.closest("details")) part.open = true;
    const control = place.matches("input, textarea") ? place : place.querySelector("textarea:not([hidden]), input, select");
    const goalLine = /^goal\.(\d+)/.exec(field);
    const within = place.dataset.field === "scene" && field !== "scene" ? `${field.slice("scene.".length)}: ` : "";
    const text = goalLine ? `Line ${Number(goalLine[1]) + 1} ${message}` : within + message;
    const fault = h("p", { class: "fault", id: `fault-${(marks += 1)}` }, text);
    (place.matches("input") ? place.closest("li") : place).append(fault);
    if (place.dataset.field !== "scene") {
      control?.setAttribute("aria-invalid", "true");
      control?.setAttribute("aria-describedby", fault.id);
    }
    this.marks.push({ place, control, fault });
    return true;
  }

  /** What was said about the part that changed, or about a part that is gone, is no longer so. */
  changed(target) {
    if (!this.marks.length) return;
    const whole = target.id === "scene-json"; // written anew, whatever part of the scene was wrong
    const settled = ({ place }) => place.contains(target) || !place.isConnected || (whole && place.dataset.field.startsWith("scene"));
    this.marks.filter(settled).forEach(unmark);
    this.marks = this.marks.filter((mark) => !settled(mark));
    if (!this.marks.length && this.problem.textContent === MARKED) this.problem.hidden = true;
  }

  clear() {
    this.problem.hidden = true;
    this.marks.forEach(unmark);
    this.marks = [];
  }
}

function unmark({ control, fault }) {
  fault.remove();
  control?.removeAttribute("aria-invalid");
  control?.removeAttribute("aria-describedby");
}
