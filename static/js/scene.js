// The scene editor: ready scenes, a list of objects, and the same as JSON.

import { ActionChoice } from "./actions.js";
import { get, Problem } from "./api.js";
import { byId, h } from "./dom.js";
import { Home } from "./home.js";
import { recall, remember } from "./memory.js";

const OWN = "own";

export class SceneEditor {
  /** `chosen(ready)` is called when somebody picks a ready scene, `refused(error)` where its text is none. */
  constructor({ chosen, refused }) {
    this.chosen = chosen;
    this.refused = refused;
    // Text that is no JSON yet, and why; the scene is the one before it, which nobody means any more.
    this.broken = recall("broken", null);
    this.ready = new Map();
    this.kinds = [];
    this.scene = recall("scene", null);
    this.select = byId("ready-scene");
    this.list = byId("object-list");
    this.json = byId("scene-json");
    this.robot = byId("robot");
    this.actions = new ActionChoice((actions) => this.change({ actions }));
    this.home = new Home((environment) => this.change({ environment, graph: null }));
    // The usual robot need not be named.
    this.robot.addEventListener("change", () => this.change({ robot: this.robot.value === this.usual ? null : this.robot.value }));
    this.select.addEventListener("change", () => this.pick(this.select.value));
    byId("add-object").addEventListener("click", () => this.add());
    byId("toggle-json").addEventListener("click", () => this.toggle());
    this.json.addEventListener("input", () => this.readJson());
  }

  async load() {
    const names = await fetch("/static/scenes/index.json").then((answer) => answer.json());
    const read = (name) => fetch(`/static/scenes/${name}.json`).then((answer) => answer.json());
    const scenes = await Promise.all(names.map(read));
    names.forEach((name, index) => this.ready.set(name, scenes[index]));
    this.select.replaceChildren(
      ...names.map((name) => h("option", { value: name }, this.ready.get(name).title)),
      h("option", { value: OWN }, "My own scene"),
    );
    this.worlds = (await get("/catalog/worlds").catch(() => ({ items: [] }))).items;
    this.kinds = (await get("/catalog/objects").catch(() => ({ items: [] }))).items;
    const robots = (await get("/catalog/robots").catch(() => ({ items: [] }))).items;
    this.usual = robots.find((robot) => robot.default)?.name ?? "";
    this.robot.replaceChildren(...robots.map((robot) => h("option", { value: robot.name }, robot.title)));
    const kept = recall("ready", names[0]);
    if (this.scene === null) this.pick(names[0]);
    else this.show(this.ready.has(kept) ? kept : OWN);
    if (this.broken) this.reveal(true);
  }

  /** Take up a ready scene. */
  pick(name) {
    if (name !== OWN) {
      const ready = this.ready.get(name);
      this.scene = structuredClone(ready.scene);
      this.mend();
      this.chosen(ready);
    }
    this.keep(name);
    this.show(name);
  }

  /** Whether this is the task of a ready scene. */
  hasInstruction(text) {
    return [...this.ready.values()].some((ready) => ready.instruction === text);
  }

  /** Take up the scene of an earlier plan, as it was asked for: nothing of what was drawn at random. */
  take(scene) {
    const home = scene.environment || scene.graph;
    this.scene = present({ ...scene, objects: home ? null : scene.objects.map(present) });
    this.mend();
    this.keep(OWN);
    this.show(OWN);
  }

  /** Give the scene these parts; what is null is left to its world. */
  change(parts) {
    if (this.broken) {
      this.draw();
      return this.refused(this.fault());
    }
    this.scene = Object.fromEntries(Object.entries({ ...this.scene, ...parts }).filter(([, value]) => value !== null));
    this.keep(this.select.value);
    return this.show(this.select.value);
  }

  keep(name) {
    remember("scene", this.scene);
    remember("ready", name);
  }

  changed() {
    this.select.value = OWN;
    byId("scene-about").textContent = "";
    this.keep(OWN);
  }

  show(name) {
    this.select.value = name;
    byId("scene-about").textContent = this.ready.get(name)?.about ?? "";
    this.draw();
    this.json.value = this.broken?.text ?? JSON.stringify(this.scene, null, 1);
    // The rows are new ones; what was said about the old ones goes with them.
    byId("scene-objects").dispatchEvent(new Event("change", { bubbles: true }));
  }

  /** Everything but the text, which may be being typed. */
  draw() {
    const { scene } = this;
    const world = this.worlds.find((one) => one.name === (scene.world ?? "tabletop"));
    const homes = world?.environments ?? [];
    const atHome = homes.length > 0;
    this.home.show(scene, homes);
    this.actions.show(scene, world);
    byId("scene-legend").textContent = atHome ? "In the home" : "On the table";
    byId("add-object").hidden = atHome || !this.json.hidden;
    byId("robot-field").hidden = (scene.world ?? "tabletop") !== "tabletop" || this.robot.options.length < 2;
    this.robot.value = scene.robot ?? this.usual;
    if (atHome) this.list.replaceChildren(h("li", { class: "hint whole" }, scene.objects?.length ? `Of its things the planner is told ${scene.objects.length}; see the JSON.` : "Everything that is there."));
    else this.list.replaceChildren(...this.objects().map((object, index) => this.entry(object, index)));
  }

  objects() {
    if (!Array.isArray(this.scene.objects)) this.scene.objects = [];
    return this.scene.objects;
  }

  entry(object, index) {
    const input = h("input", {
      "aria-label": `Object ${index + 1}`,
      "data-field": `scene.objects.${index}`,
      placeholder: "name, like red mug",
      maxlength: 100,
      autocomplete: "off",
      oninput: () => {
        // A kind or colour was another thing's, unless the JSON says otherwise.
        this.objects()[index] = { name: input.value };
        this.changed();
        this.json.value = JSON.stringify(this.scene, null, 1);
      },
      onkeydown: (event) => {
        if (event.key !== "Enter" || event.ctrlKey || event.metaKey) return;
        event.preventDefault();
        this.add();
      },
    });
    input.value = object.name ?? "";
    const remove = h("button", {
      type: "button", class: "small quiet remove", "aria-label": `Remove ${object.name || "object"}`,
      onclick: () => this.remove(index),
    }, "×");
    return h("li", {}, this.swatch(object), input, remove);
  }

  swatch(object) {
    const swatch = h("span", { class: "swatch", "aria-hidden": "true" });
    const colour = object.colour ?? this.colourOf(String(object.name ?? ""));
    if (colour && CSS.supports("color", colour)) swatch.style.background = colour;
    return swatch;
  }

  /** The colour of the kind whose name the object's name ends with, as the catalogue has it. */
  colourOf(name) {
    const words = name.toLowerCase();
    return this.kinds.find((kind) => [kind.name.replaceAll("_", " "), ...kind.synonyms].some((called) => words.endsWith(called)))?.colour;
  }

  add() {
    this.objects().push({ name: "" });
    this.changed();
    this.show(OWN);
    this.list.lastElementChild.querySelector("input").focus();
  }

  remove(index) {
    this.objects().splice(index, 1);
    this.changed();
    this.show(OWN);
    const next = this.list.children[Math.min(index, this.list.children.length - 1)];
    (next?.querySelector(".remove") ?? byId("add-object")).focus();
  }

  /** Text that is no JSON is not left behind: it stays in sight until it is. */
  toggle() {
    if (this.broken) this.refused(this.fault());
    else this.reveal(this.json.hidden);
    if (!this.json.hidden) this.json.focus();
  }

  /** Show the scene as JSON, or as a list. */
  reveal(asJson) {
    this.json.hidden = !asJson;
    this.list.hidden = asJson;
    byId("toggle-json").setAttribute("aria-pressed", String(asJson));
    byId("toggle-json").textContent = asJson ? "as a list" : "as JSON";
    this.show(this.select.value);
  }

  readJson() {
    const text = this.json.value;
    try {
      const scene = JSON.parse(text);
      if (typeof scene !== "object" || scene === null || Array.isArray(scene)) throw new SyntaxError("it is no object in braces");
      this.scene = scene;
      this.mend();
      this.changed();
    } catch (error) {
      this.broken = { text, why: error.message };
      remember("broken", this.broken);
    }
    this.draw();
  }

  mend() {
    this.broken = null;
    remember("broken", null);
  }

  fault() {
    const message = `The scene is not JSON: ${this.broken.why}`;
    return new Problem({ detail: message, errors: [{ field: "scene.text", message }] });
  }

  /** The scene as it is sent; empty rows are not. Throws where its text is no JSON. */
  request() {
    if (this.broken) throw this.fault();
    const objects = this.scene.objects;
    if (!Array.isArray(objects)) return this.scene;
    return { ...this.scene, objects: objects.filter((object) => String(object?.name ?? "").trim() !== "") };
  }
}

/** What there is of an object, without what is null, false or empty. */
function present(object) {
  const there = ([, value]) => value && (typeof value !== "object" || Object.keys(value).length);
  return Object.fromEntries(Object.entries(object).filter(there));
}
