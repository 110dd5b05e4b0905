// What the robot can do: the action primitives that a scene offers, of those its world has.

import { get } from "./api.js";
import { byId, h } from "./dom.js";

export class ActionChoice {
  /** `chosen(names)` is called when somebody ticks; null stands for the usual ones. */
  constructor(chosen) {
    this.chosen = chosen;
    this.list = byId("action-list");
    this.list.addEventListener("change", () => this.choose(this.boxes().filter((box) => box.checked).map((box) => box.value)));
    byId("all-actions").addEventListener("click", () => this.choose(this.world.actions));
    byId("usual-actions").addEventListener("click", () => this.choose(this.world.default_actions));
  }

  boxes() {
    return [...this.list.querySelectorAll("input")];
  }

  choose(names) {
    const usual = this.world.default_actions;
    this.chosen(names.length === usual.length && names.every((name) => usual.includes(name)) ? null : names);
  }

  /** Show what a scene of this world offers. */
  async show(scene, world) {
    byId("actions-part").hidden = !world;
    if (!world) return;
    if (this.world !== world) {
      this.world = world;
      this.list.replaceChildren();
      const actions = (await get(`/catalog/actions?world=${encodeURIComponent(world.name)}`).catch(() => ({ items: [] }))).items;
      if (this.world !== world) return;
      this.list.replaceChildren(...actions.map((action) => entry(action)));
    }
    this.names = Array.isArray(scene.actions) ? scene.actions : world.default_actions;
    for (const box of this.boxes()) box.checked = this.names.includes(box.value);
    byId("action-count").textContent = told(this.names, world.actions.length);
  }
}

function entry({ name, parameters, meaning }) {
  const id = `action-${name}`;
  return h("li", {},
    h("input", { type: "checkbox", id, value: name }),
    h("label", { for: id }, h("code", {}, `${name}(${parameters.map((one) => one.name).join(", ")})`), h("span", { class: "hint" }, meaning)));
}

const told = (names, all) => (names.length === 1 ? names[0] : `${names.length || "none"} of ${all} actions`);
