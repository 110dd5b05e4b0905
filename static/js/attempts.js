// Every attempt of an evaluation: its program, what was done, and what a person makes of it.

import { get, put } from "./api.js";
import { h, seconds } from "./dom.js";
import { recall, remember } from "./memory.js";

const PART = 200;
const CHOICES = [["all", "All"], ["missed", "Goal not met"], ["declined", "Declined"], ["failed", "No program"], ["judged", "Judged by a person"]];

export class Attempts {
  /** `judged()` is called when a person's verdict was stored. */
  constructor(root, judged) {
    this.root = root;
    this.judged = judged;
    this.list = h("ol", { class: "attempts" });
    this.choice = h("select", { class: "runs", "aria-label": "Which attempts", onchange: () => this.sift() }, CHOICES.map(([value, text]) => h("option", { value }, text)));
    this.told = h("span", { class: "hint", role: "status" });
    root.replaceChildren(h("div", { class: "row" }, this.choice, this.told), this.list);
  }

  reset(id) {
    this.id = id;
    this.known = new Map();
    this.list.replaceChildren();
    this.told.textContent = "";
    this.drafts = recall(`verdicts.${id}`, {});
  }

  /** Show what is new: attempts end in any order, so all after the first gap are asked for. */
  async refresh() {
    const { id } = this;
    let first = 0;
    while (this.known.has(first)) first += 1;
    let cursor = first ? `&cursor=${first - 1}` : "";
    do {
      const page = await get(`/evaluations/${id}/results?limit=${PART}${cursor}`);
      if (this.id !== id) return;
      for (const result of page.items) if (result.key && !this.known.has(result.index)) this.add(result);
      cursor = page.next ? `&cursor=${page.next}` : "";
    } while (cursor);
    this.sift();
  }

  add(result) {
    const item = this.entry(result);
    const later = [...this.list.children].find((other) => Number(other.dataset.index) > result.index);
    this.list.insertBefore(item, later ?? null);
    this.known.set(result.index, { result, item });
  }

  sift() {
    let shown = 0;
    for (const { result, item } of this.known.values()) {
      item.hidden = !fits(result, this.choice.value);
      shown += item.hidden ? 0 : 1;
    }
    this.told.textContent = `${shown} of ${this.known.size}`;
  }

  entry(result) {
    const details = h("details", {}, this.summary(result));
    details.addEventListener("toggle", () => {
      if (details.open && details.children.length === 1) details.append(this.content(result));
    });
    return h("li", { "data-index": result.index }, details);
  }

  summary(result) {
    const [tone, sign, text] = outcome(result);
    const run = result.run ? `, run ${result.run + 1}` : "";
    return h("summary", {},
      h("span", { class: `mark ${tone}`, title: text }, h("span", { "aria-hidden": "true" }, sign), h("span", { class: "sr-only" }, text)),
      h("span", { class: "sentence" }, result.instruction),
      h("span", { class: "when" }, `${result.cell}${run} · ${result.task}`));
  }

  content(result) {
    const ended = result.physics ?? result.plan;
    const lists = [["Not met", ended.unmet, "bad"], ["Changed besides", ended.changed, "warn"], ["Steps done", ended.performed, ""], ["Steps that failed", ended.problems, "bad"], ["Mistakes", result.mistakes, ""]];
    return h("div", { class: "attempt" },
      h("p", { class: "why" }, outcome(result)[2], result.reason && `: ${result.reason}`),
      result.program && h("pre", { class: "code writing", tabindex: "0", "aria-label": "Program" }, result.program),
      ...lists.map(([title, entries, tone]) => entries.length > 0 && h("div", { class: "part" }, h("h3", {}, title), h("ul", { class: `code ${tone}` }, entries.map((text) => h("li", {}, text))))),
      h("p", { class: "hint" }, [result.planner, result.model, `seed ${result.seed}`, `written in ${seconds(result.seconds)}`, result.tries > 1 && `${result.tries} tries`].filter(Boolean).join(" · ")),
      this.verdict(result));
  }

  verdict(result) {
    const note = h("input", { "aria-label": "Why, if you like", placeholder: "Why, if you like", maxlength: 2000, oninput: () => this.draft(result.index, note.value) });
    note.value = this.drafts[result.index] ?? result.verdict?.note ?? "";
    const problem = h("p", { class: "fault", role: "alert", hidden: true });
    const button = (success, text) => h("button", {
      type: "button", class: "small", "aria-pressed": String(result.verdict?.success === success),
      onclick: () => this.judge(result, success, note, problem),
    }, text);
    return h("div", { class: "verdict" }, h("span", { class: "said" }, "Was the task done?"), h("div", { class: "row" }, button(true, "Yes, done"), button(false, "No, not done"), note), problem);
  }

  draft(index, text) {
    this.drafts[index] = text;
    remember(`verdicts.${this.id}`, this.drafts);
  }

  async judge(result, success, note, problem) {
    const place = `/evaluations/${this.id}/results/${result.index}/verdict`;
    const { item } = this.known.get(result.index);
    try {
      const told = await put(place, { success, note: note.value });
      delete this.drafts[result.index];
      remember(`verdicts.${this.id}`, this.drafts);
      const fresh = this.entry(told);
      item.replaceWith(fresh);
      this.known.set(result.index, { result: told, item: fresh });
      const details = fresh.querySelector("details");
      details.open = true;
      details.append(this.content(told));
      details.querySelector(".verdict [aria-pressed=true]").focus();
      this.judged();
    } catch (error) {
      problem.textContent = error.message;
      problem.hidden = false;
    }
  }
}

/** [tone, sign, words] */
function outcome(result) {
  if (result.verdict) return [result.verdict.success ? "good" : "bad", result.verdict.success ? "✓" : "✗", `A person says: ${result.verdict.success ? "done" : "not done"}`];
  const ended = result.physics ?? result.plan;
  if (result.status === "failed") return ["bad", "✗", "No program came of it"];
  if (result.status === "declined") return [ended.success ? "good" : "bad", ended.success ? "✓" : "✗", ended.success ? "Rightly declined" : "Declined, though it could be done"];
  if (!ended.success) return ["bad", "✗", result.impossible ? "Planned, though it cannot be done" : "The goal is not met"];
  return ended.strict ? ["good", "✓", "The goal is met"] : ["warn", "✓", "The goal is met, but something else was changed"];
}

function fits(result, choice) {
  switch (choice) {
    case "missed":
      return !(result.physics ?? result.plan).success;
    case "declined":
      return result.status === "declined";
    case "failed":
      return result.status === "failed";
    case "judged":
      return Boolean(result.verdict);
    default:
      return true;
  }
}
