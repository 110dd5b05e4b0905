// The planner's switches and the run's, each with its default; only what differs is sent.

import { get } from "./api.js";
import { byId, h } from "./dom.js";
import { recall, remember } from "./memory.js";

const SWITCHES = [
  { name: "planner", label: "Planner", field: "planner.name", standard: "", options: [["", "the world's best"]] },
  { name: "model", label: "Model", field: "planner.model", standard: "default", options: [["default", "default"]] },
  { name: "cue", label: "Functions named after their instructions", field: "planner.cue", standard: true },
  { name: "comments", label: "Comments in the examples", field: "planner.comments", standard: true },
  { name: "feedback", label: "Assertions with recoveries", field: "planner.feedback", standard: "", options: [["", "as the world has it"], ["yes", "yes"], ["no", "no"]] },
  { name: "objects", label: "Objects in the prompt", field: "planner.objects", standard: "", options: [["", "as the world has it"], ["local", "inside the function"], ["global", "before the examples"], ["properties", "with their properties"]] },
  { name: "choice", label: "Which examples", field: "planner.choice", standard: "fixed", options: [["fixed", "the first ones"], ["random", "drawn by the seed"], ["similar", "nearest to the instruction"]] },
  { name: "state_check", label: "Assertions are decided by", field: "planner.state_check", standard: "world", options: [["world", "the world"], ["model", "the model"], ["both", "both, side by side"]] },
  { name: "examples", label: "Example programs", field: "planner.examples", standard: 3, min: 0, max: 7, step: 1 },
  { name: "max_replans", label: "Plan anew, at most", field: "planner.max_replans", standard: 0, min: 0, max: 5, step: 1 },
  { name: "constrained", label: "Only names of this scene (grammar)", field: "planner.constrained", standard: true },
  { name: "affordances", label: "Only what can be done with them (grammar)", field: "planner.affordances", standard: true },
  { name: "repair", label: "Add steps that a precondition calls for", field: "planner.repair", standard: "", options: [["", "as the planner has it"], ["yes", "yes"], ["no", "no"]] },
  { name: "temperature", label: "Temperature", field: "planner.temperature", standard: 0, min: 0, max: 2, step: 0.1 },
  { name: "detector", label: "Objects in the cameras' pictures are told by", field: "perception.detector", standard: "segmentation", options: [["segmentation", "the simulator"], ["vision", "a vision model"]] },
  { name: "confusion", label: "Share of objects taken for another", field: "perception.confusion", standard: 0, min: 0, max: 1, step: 0.1 },
  { name: "seed", label: "Seed", field: "seed", standard: 0, min: 0, max: 4294967295, step: 1 },
  { name: "execute", label: "Carry it out", field: "execute", standard: true },
  { name: "approval", label: "Ask me before it is carried out", field: "approval", standard: false },
];

export class Settings {
  constructor() {
    this.values = { ...Object.fromEntries(SWITCHES.map((one) => [one.name, one.standard])), ...recall("settings", {}) };
    byId("settings").replaceChildren(...SWITCHES.map((one) => this.entry(one)));
    this.count();
    this.offerModels();
    this.offerPlanners();
  }

  entry(one) {
    const id = `setting-${one.name}`;
    const change = (event) => {
      this.values[one.name] = typeof one.standard === "boolean" ? event.target.checked : event.target.value;
      remember("settings", this.values);
      this.count();
    };
    if (typeof one.standard === "boolean") {
      const box = h("input", { type: "checkbox", id, checked: Boolean(this.values[one.name]), onchange: change });
      return h("div", { class: "check", "data-field": one.field }, box, h("label", { for: id }, one.label));
    }
    const control = one.options
      ? h("select", { id, onchange: change }, one.options.map(([value, text]) => h("option", { value }, text)))
      : h("input", { id, type: "number", min: one.min, max: one.max, step: one.step, oninput: change });
    control.value = this.values[one.name];
    return h("div", { class: "field", "data-field": one.field }, h("label", { for: id }, one.label), control);
  }

  async offerPlanners() {
    const planners = (await get("/catalog/planners").catch(() => ({ items: [] }))).items;
    const select = byId("setting-planner");
    select.append(...planners.map((planner) => h("option", { value: planner.name, title: planner.meaning ?? "" }, planner.name)));
    if (![...select.options].some((option) => option.value === this.values.planner)) this.values.planner = "";
    select.value = this.values.planner;
    this.count();
  }

  async offerModels() {
    const models = (await get("/catalog/models").catch(() => ({ items: [] }))).items;
    const select = byId("setting-model");
    const standard = models.find((model) => model.default);
    select.replaceChildren(
      h("option", { value: "default" }, standard ? `default (${standard.name})` : "default"),
      ...models.filter((model) => !model.default).map((model) => h("option", { value: model.name, title: model.title }, model.name)),
    );
    if (![...select.options].some((option) => option.value === this.values.model)) this.values.model = "default";
    select.value = this.values.model;
    this.count();
  }

  count() {
    const changed = SWITCHES.filter((one) => String(this.values[one.name]) !== String(one.standard));
    byId("settings-count").textContent = changed.length ? `${changed.length} changed` : "";
  }

  /** The parts of the request that differ from the defaults. */
  request() {
    const request = {};
    for (const one of SWITCHES) {
      const value = this.sent(one);
      if (value === undefined) continue;
      const [part, name] = one.field.split(".");
      if (name) request[part] = { ...request[part], [name]: value };
      else request[part] = value;
    }
    return request;
  }

  sent(one) {
    const value = this.values[one.name];
    if (String(value) === String(one.standard)) return undefined;
    if (one.name === "approval") return "manual";
    if (value === "yes" || value === "no") return value === "yes";
    if (typeof one.standard !== "number") return value;
    return value === "" || Number.isNaN(Number(value)) ? value : Number(value);
  }
}
