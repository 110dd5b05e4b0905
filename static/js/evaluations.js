// Evaluations: the list, and the one that is open with its progress, tables and attempts.

import { get, post } from "./api.js";
import { Attempts } from "./attempts.js";
import { ago, byId, h } from "./dom.js";
import { MeasureForm } from "./measure.js";
import { drawTables } from "./tables.js";

const WORDS = { queued: "Waiting for its turn", running: "Under way", succeeded: "Finished", failed: "Failed", cancelled: "Cancelled" };
const TONES = { succeeded: "good", failed: "bad", cancelled: "warn" };
const UNDER_WAY = new Set(["queued", "running"]);
const FORMS = [["csv", "CSV", "csv"], ["json", "JSON", "json"], ["markdown", "Markdown", "md"], ["html", "HTML", "html"]];
const EVERY = 2000;

export class Evaluations {
  constructor() {
    this.root = byId("evaluations");
    this.list = byId("evaluation-list");
    this.more = byId("evaluation-more");
    this.more.addEventListener("click", () => this.loadList(this.next));
    this.entries = new Map();
    this.form = new MeasureForm((evaluation) => this.started(evaluation));
    this.attempts = new Attempts(byId("attempts-view"), () => this.refreshTables());
  }

  /** Show the list and, where an id is given, that evaluation. */
  async open(id) {
    const first = !this.visible;
    this.visible = true;
    if (first) await Promise.all([this.planners ? null : this.form.load(), this.loadList()]);
    this.planners = true;
    if (!this.visible) return;
    this.show(id);
    this.draw();
  }

  close() {
    this.visible = false;
    this.id = null;
    clearTimeout(this.timer);
  }

  started(evaluation) {
    this.entries.set(evaluation.id, evaluation);
    location.hash = `#/evaluations/${evaluation.id}`;
    if (matchMedia("(max-width: 899px)").matches) byId("evaluation").scrollIntoView();
  }

  async loadList(cursor = null) {
    try {
      const page = await get(`/evaluations?limit=15${cursor ? `&cursor=${cursor}` : ""}`);
      for (const each of page.items) this.entries.set(each.id, each);
      if (cursor || !this.next) this.next = page.next;
      this.more.hidden = !this.next;
    } catch {
      // The list is left as it is; the head of the page says that the service is away.
    }
    this.draw();
  }

  draw() {
    const sorted = [...this.entries.values()].sort((one, other) => (one.created_at < other.created_at ? 1 : -1));
    if (!sorted.length) {
      this.list.replaceChildren(h("li", { class: "hint" }, "None yet."));
      return;
    }
    const focused = this.list.contains(document.activeElement) ? document.activeElement.getAttribute("href") : null;
    this.list.replaceChildren(...sorted.map((each) => this.entry(each)));
    if (focused) this.list.querySelector(`[href="${CSS.escape(focused)}"]`)?.focus();
  }

  entry(evaluation) {
    const under = UNDER_WAY.has(evaluation.status);
    const told = under ? `${evaluation.done} of ${evaluation.total}` : `${evaluation.total} attempts`;
    return h("li", {}, h("a", { href: `#/evaluations/${evaluation.id}`, "aria-current": evaluation.id === this.id && "page" },
      h("span", { class: `dot ${TONES[evaluation.status] ?? "under-way"}`, "aria-hidden": "true" }),
      h("span", { class: "sentence" }, `${evaluation.suite}: ${methods(evaluation)}`),
      h("span", { class: "when" }, `${evaluation.status}, ${told}, ${ago(evaluation.created_at)}`)));
  }

  show(id) {
    clearTimeout(this.timer);
    this.id = id;
    this.done = -1;
    byId("evaluation-empty").hidden = Boolean(id);
    for (const part of ["evaluation-card", "tables-card", "attempts-card"]) byId(part).hidden = true;
    if (!id) return;
    this.attempts.reset(id);
    byId("evaluation-head").replaceChildren();
    byId("tables-view").replaceChildren();
    this.refresh(id);
  }

  /** Ask how far it is; again and again while it is under way. */
  async refresh(id = this.id) {
    const evaluation = await get(`/evaluations/${encodeURIComponent(id)}`).catch((error) => ({ error }));
    if (this.id !== id) return;
    byId("evaluation-card").hidden = false;
    if (evaluation.error instanceof Error) {
      this.lose(evaluation.error);
      if (evaluation.error.status === 0) this.timer = setTimeout(() => this.refresh(id), EVERY);
      return;
    }
    this.entries.set(id, evaluation);
    this.draw();
    this.drawHead(evaluation);
    if (evaluation.done !== this.done && evaluation.done) {
      this.done = evaluation.done;
      await this.refreshContent(id);
    }
    if (this.id === id && UNDER_WAY.has(evaluation.status)) this.timer = setTimeout(() => this.refresh(id), EVERY);
  }

  async refreshContent(id) {
    byId("tables-card").hidden = byId("attempts-card").hidden = false;
    await Promise.all([this.refreshTables(), this.attempts.refresh()]).catch((error) => this.id === id && this.lose(error));
  }

  async refreshTables() {
    const { id } = this;
    const { tables } = await get(`/evaluations/${id}/tables`);
    if (this.id === id) drawTables(byId("tables-view"), tables);
  }

  drawHead(evaluation) {
    const { status, done, total, seconds_left: left, request } = evaluation;
    const under = UNDER_WAY.has(status);
    const share = `${done} of ${total} attempts`;
    const told = [share, left !== null && `about ${long(left)} left`].filter(Boolean).join(", ");
    const button = (text, act) => h("button", { type: "button", class: "small", onclick: act }, text);
    const forms = done > 0 ? FORMS : [];
    const focused = byId("evaluation-head").contains(document.activeElement) ? document.activeElement.textContent : null;
    byId("evaluation-head").replaceChildren(...[
      h("h2", { id: "evaluation-title" }, "Evaluation"),
      h("p", { class: "sentence" }, `${evaluation.suite}: ${methods(evaluation)}`),
      h("p", { class: `status ${TONES[status] ?? ""}`, role: "status", "data-status": status }, WORDS[status] ?? status, h("span", { class: "clock" }, ` · ${told}`)),
      h("progress", { max: total, value: done, "aria-label": share }),
      h("p", { class: "hint" }, asked(request), ` · started ${ago(evaluation.created_at)}`),
      evaluation.error && h("p", { class: "problem" }, evaluation.error),
      h("div", { class: "row" },
        under && button("Cancel", () => this.cancel()),
        forms.length > 0 && h("span", { class: "hint" }, "Download"),
        ...forms.map(([form, text, ending]) => h("a", { class: "button small quiet", href: `/evaluations/${evaluation.id}/tables?format=${form}`, download: `${evaluation.id}.${ending}` }, text)),
        done > 0 && h("a", { class: "button small quiet", href: `/evaluations/${evaluation.id}/tables?format=html`, target: "_blank", rel: "noopener" }, "Open the report")),
    ].filter(Boolean));
    if (focused) [...byId("evaluation-head").querySelectorAll("button, a")].find((each) => each.textContent === focused)?.focus();
  }

  lose(error) {
    byId("evaluation-head").querySelector(".problem")?.remove();
    if (!byId("evaluation-title")) byId("evaluation-head").append(h("h2", { id: "evaluation-title" }, "Evaluation"));
    byId("evaluation-head").append(h("p", { class: "problem", role: "alert" }, error.message));
  }

  async cancel() {
    clearTimeout(this.timer);
    try {
      await post(`/evaluations/${this.id}/cancel`);
      await this.refresh();
    } catch (error) {
      await this.refresh();
      this.lose(error);
    }
  }
}

/** "situated, progprompt (small)" */
function methods({ request }) {
  return request.methods.map(({ name, model, repair }) => name + (model === "default" ? "" : ` (${model})`) + (repair ? " + repair" : "")).join(", ");
}

function asked({ split, limit, runs, languages, physics, categories, methods: [{ seed }] }) {
  const parts = [
    limit ? `${limit} tasks` : "all tasks",
    split === "all" ? null : `of the ${split} half`,
    categories.length ? `only ${categories.join(", ")}` : null,
    runs > 1 ? `${runs} runs` : "one run",
    languages.join() === "en" ? null : `languages: ${languages.join(", ")}`,
    physics ? "with physics" : null,
    seed ? `seed ${seed}` : null,
  ];
  return parts.filter(Boolean).join(", ");
}

const long = (value) => (value < 100 ? `${Math.ceil(value)} s` : value < 5400 ? `${Math.round(value / 60)} min` : `${(value / 3600).toFixed(1)} h`);
