// What the service says is wrong with a form, shown at the fields it names.

import { Problem } from "./api.js";
import { h } from "./dom.js";

export class Faults {
  /** Fields of `form` bear `data-field`; what belongs to none of them is told in `problem`. */
  constructor(form, problem) {
    this.form = form;
    this.problem = problem;
  }

  show(error) {
    const faults = error instanceof Problem ? error.errors : [];
    const homeless = faults.filter((fault) => !this.mark(fault));
    const told = homeless.length ? homeless.map((fault) => `${fault.field}: ${fault.message}`).join("\n") : error.message;
    this.problem.hidden = false;
    this.problem.textContent = faults.length && !homeless.length ? "Something has to be mended; see the marked fields." : told;
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
    this.problem.hidden = true;
    this.form.querySelectorAll(".fault").forEach((fault) => fault.remove());
    this.form.querySelectorAll("[aria-invalid]").forEach((control) => {
      control.removeAttribute("aria-invalid");
      control.removeAttribute("aria-describedby");
    });
  }
}
