// The program: token by token while it is written, then line by line with what became of each.

import { byId, h } from "./dom.js";

const TOKEN = /(#.*$)|('(?:\\.|[^'\\])*'|"(?:\\.|[^"\\])*")|\b(def|assert|pass|not|else|for|if|import|from|and|or|return)\b|([A-Za-z_]\w*)(?=\()|([^#'"A-Za-z_]+|[A-Za-z_]\w*|.)/gm;
const CLASSES = ["comment", "string", "keyword", "call"];
const MARKS = {
  pending: ["·", "to come"],
  running: ["▸", "under way"],
  performed: ["✓", "done"],
  failed: ["✗", "failed"],
  skipped: ["–", "skipped"],
  stopped: ["■", "stopped"],
  holds: ["✓", "true"],
  broken: ["✗", "false"],
};

/** The text of a line as coloured pieces. */
export function coloured(text) {
  return [...text.matchAll(TOKEN)].map((match) => {
    const kind = CLASSES[match.slice(1, 5).findIndex(Boolean)];
    return kind ? h("span", { class: `t-${kind}` }, match[0]) : match[0];
  });
}

export class ProgramView {
  /** `seek(time)` moves the rollout there. */
  constructor(seek) {
    this.root = byId("program-view");
    this.seek = seek;
    this.reset();
  }

  reset(text = "Run a task, and the program appears here as it is written.") {
    this.lines = [];
    this.source = null;
    this.text = null;
    this.root.replaceChildren(h("p", { class: "hint" }, text));
  }

  /** A program is about to be written, perhaps in place of one that failed. */
  begin() {
    if (this.lines.length) this.reset("What is left is being planned anew …");
  }

  /** What was cut off is written anew from there on. */
  keep(characters) {
    if (this.text) this.written = this.written.slice(0, characters);
  }

  /** Some more of the program came from the model. */
  grow(piece) {
    if (this.lines.length) return;
    if (this.text === null) {
      this.text = h("pre", { class: "writing code", "aria-busy": "true", "aria-label": "The program being written" });
      this.root.replaceChildren(this.text);
      this.written = "";
    }
    this.written += piece;
    this.text.replaceChildren(...coloured(this.written), h("span", { class: "caret", "aria-hidden": "true" }));
  }

  /** The planning is over: the program as it was understood. */
  show(plan) {
    if (!plan.program) return this.end(plan);
    this.text = null;
    this.source = plan.program;
    this.lines = plan.program.replace(/\n+$/, "").split("\n").map((text, index) => this.line(text, index + 1));
    const list = h("ol", { class: "lines code", "aria-label": "The program" }, this.lines.map((line) => line.element));
    this.root.replaceChildren(list, ...this.usage(plan));
    for (const call of plan.rejected) this.note(call.line, "skipped", `rejected: ${call.reason}`);
    for (const step of plan.steps) this.note(step.line, "pending", "");
  }

  /** The planning is over without a program; what was written of one stays. */
  end(plan) {
    if (plan.declined) return this.reset("Nothing was planned.");
    if (!this.text) return this.reset("There is no program.");
    this.text.removeAttribute("aria-busy");
    return this.text.querySelector(".caret")?.remove();
  }

  usage({ usage, planner, rejected, completion, confidence }) {
    if (!planner) return [h("p", { class: "hint usage" }, "Written by hand.")];
    if (!usage) return [];
    const told = [usage.model];
    if (usage.seconds) told.push(`${usage.seconds.toFixed(1)} s`);
    if (usage.prompt_tokens) told.push(`${usage.prompt_tokens} + ${usage.completion_tokens} tokens`);
    if (rejected.length) told.push(`${rejected.length} rejected`);
    if (typeof confidence === "number") told.push(`${Math.round(100 * confidence)} % sure`);
    return completion ? [h("p", { class: "hint usage" }, `Written by ${told.join(" · ")}`)] : [];
  }

  line(text, number) {
    const note = h("span", { class: "note" });
    const mark = h("span", { class: "mark" });
    const content = h("span", { class: "text" }, coloured(text));
    const element = h("li", { "data-line": number }, h("span", { class: "number", "aria-hidden": "true" }, String(number)), content, mark, note);
    return { element, note, mark, content, text, number, state: null };
  }

  /** Say what became of a line. */
  note(number, state, text) {
    const line = this.lines[number - 1];
    if (!line) return;
    line.state = state;
    line.element.dataset.state = state;
    const [sign, meaning] = MARKS[state];
    line.mark.replaceChildren(h("span", { "aria-hidden": "true" }, sign), h("span", { class: "sr-only" }, meaning));
    line.note.textContent = text;
  }

  /** From now on a click on the line shows the moment it began [s]. */
  startsAt(number, time) {
    const line = this.lines[number - 1];
    if (!line || line.time !== undefined) return;
    line.time = time;
    const button = h("button", {
      type: "button", class: "text", title: `Show this moment (${time.toFixed(1)} s)`, onclick: () => this.seek(line.time),
    }, coloured(line.text));
    line.content.replaceWith(button);
    line.content = button;
  }

  /** Light the line that is being carried out; null for none. */
  light(number) {
    if (this.lit === number) return;
    this.lit = number;
    for (const line of this.lines) {
      line.element.classList.toggle("lit", line.number === number);
      if (line.number === number) line.element.setAttribute("aria-current", "step");
      else line.element.removeAttribute("aria-current");
    }
  }
}
