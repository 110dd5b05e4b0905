// Earlier plans, newest first, to be opened again.

import { get } from "./api.js";
import { ago, byId, h } from "./dom.js";
import { STATES, stateOf } from "./state.js";

export class Earlier {
  constructor() {
    this.root = byId("earlier-list");
    this.more = byId("earlier-more");
    this.more.addEventListener("click", () => this.load(this.next));
    this.entries = new Map();
    this.current = null;
  }

  async load(cursor = null) {
    try {
      const page = await get(`/plans?limit=15${cursor ? `&cursor=${cursor}` : ""}`);
      for (const plan of page.items) this.entries.set(plan.id, plan);
      if (cursor || !this.next) this.next = page.next;
      this.more.hidden = !this.next;
    } catch {
      // The list is left as it is; the head of the page says that the service is away.
    }
    this.draw();
  }

  /** A plan is new or has changed. */
  update(plan) {
    this.entries.set(plan.id, plan);
    this.draw();
  }

  open(id) {
    this.current = id;
    this.draw();
  }

  draw() {
    const plans = [...this.entries.values()].sort((one, other) => (one.created_at < other.created_at ? 1 : -1));
    if (!plans.length) {
      this.root.replaceChildren(h("li", { class: "hint" }, "None yet."));
      return;
    }
    const focused = this.root.contains(document.activeElement) ? document.activeElement.getAttribute("href") : null;
    this.root.replaceChildren(...plans.map((plan) => this.entry(plan)));
    if (focused) this.root.querySelector(`[href="${CSS.escape(focused)}"]`)?.focus();
  }

  entry(plan) {
    const state = stateOf(plan);
    const { tone, brief } = STATES[state];
    const link = h("a", { href: `#/plans/${plan.id}`, "aria-current": plan.id === this.current && "page" },
      h("span", { class: `dot ${tone ?? "under-way"}`, "aria-hidden": "true" }),
      h("span", { class: "sentence" }, plan.instruction || "Program by hand"),
      h("span", { class: "when" }, `${brief ?? state.replace("_", " ")}, ${ago(plan.created_at)}`));
    return h("li", {}, link);
  }
}
