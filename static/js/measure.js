// A new evaluation, from the form to POST /evaluations.

import { get, post } from "./api.js";
import { byId, h, submitOnCtrlEnter } from "./dom.js";
import { Faults } from "./faults.js";
import { recall, remember } from "./memory.js";

const METHOD = { name: "", model: "default", repair: false };
const STANDARD = { suite: "", methods: [METHOD], runs: "1", limit: "", split: "all", language: "en", seed: "0", physics: false, categories: [] };
const NUMBERS = ["runs", "limit", "seed"];

export class MeasureForm {
  /** `accepted(evaluation)` is called when the service has taken the request. */
  constructor(accepted) {
    this.accepted = accepted;
    this.form = byId("measure");
    this.faults = new Faults(this.form, byId("measure-problem"));
    this.values = { ...STANDARD, ...recall("measure", {}) };
    this.suites = [];
    this.planners = [];
    this.models = [];
    for (const name of ["suite", "split", "language", ...NUMBERS]) this.bind(name);
    const physics = byId("measure-physics");
    physics.checked = this.values.physics;
    physics.addEventListener("change", () => this.keep("physics", physics.checked));
    byId("add-method").addEventListener("click", () => this.addMethod());
    submitOnCtrlEnter(this.form);
    this.form.addEventListener("submit", (event) => this.submit(event));
  }

  bind(name) {
    const control = byId(`measure-${name}`);
    control.value = this.values[name];
    control.addEventListener("input", () => this.keep(name, control.value));
  }

  keep(name, value) {
    this.values[name] = value;
    if (name === "suite") this.offerParts();
    remember("measure", this.values);
    this.count();
  }

  async load() {
    try {
      const answers = await Promise.all(["/evaluations/suites", "/catalog/planners", "/catalog/models"].map(get));
      [this.suites, this.planners, this.models] = answers.map((answer) => answer.items);
    } catch (error) {
      this.faults.show(error);
      return;
    }
    const select = byId("measure-suite");
    select.replaceChildren(...this.suites.map((suite) => h("option", { value: suite.name }, `${suite.name} (${suite.tasks} tasks)`)));
    if (!this.suite()) this.values.suite = this.suites.at(-1)?.name ?? "";
    select.value = this.values.suite;
    this.offerParts();
    this.drawMethods();
  }

  suite() {
    return this.suites.find((suite) => suite.name === this.values.suite);
  }

  /** The languages and categories of the suite. */
  offerParts() {
    const suite = this.suite();
    const language = byId("measure-language");
    const known = ["en", ...suite.languages.filter((code) => code !== "en")];
    const names = new Intl.DisplayNames(["en"], { type: "language" });
    language.replaceChildren(
      ...known.map((code) => h("option", { value: code }, names.of(code))),
      known.length > 1 && h("option", { value: "all" }, "every one it has"),
    );
    if (![...language.options].some((option) => option.value === this.values.language)) this.values.language = "en";
    language.value = this.values.language;
    this.values.categories = this.values.categories.filter((name) => suite.categories.includes(name));
    byId("measure-categories").replaceChildren(...suite.categories.map((name) => this.category(name)));
    this.count();
  }

  category(name) {
    const change = (event) => {
      const rest = this.values.categories.filter((each) => each !== name);
      this.keep("categories", event.target.checked ? [...rest, name] : rest);
    };
    return h("label", { class: "tick" }, h("input", { type: "checkbox", checked: this.values.categories.includes(name), onchange: change }), name);
  }

  drawMethods() {
    byId("methods").replaceChildren(...this.values.methods.map((method, index) => this.method(method, index)));
    this.count();
  }

  method(method, index) {
    const change = (name, value) => {
      method[name] = value;
      this.keep("methods", this.values.methods);
    };
    const select = (name, label, options) => {
      const known = options.some(([value]) => value === method[name]);
      return h("select", { "aria-label": `${label} of method ${index + 1}`, "data-field": `planners.${index}.${name}`, onchange: (event) => change(name, event.target.value) },
        (known ? options : [[method[name], `${method[name]}, not there`], ...options]).map(([value, text, title]) => h("option", { value, title, selected: value === method[name] }, text)));
    };
    const planners = [["", "the best", "The one that does best in the suite's world"], ...this.planners.map((one) => [one.name, one.name, one.meaning])];
    const models = [["default", "its own model"], ...this.models.map((one) => [one.name, one.name, one.title])];
    const repair = h("input", { type: "checkbox", checked: method.repair, onchange: (event) => change("repair", event.target.checked) });
    const remove = h("button", { type: "button", class: "quiet remove", "aria-label": `Remove method ${index + 1}`, disabled: this.values.methods.length === 1, onclick: () => this.removeMethod(index) }, "×");
    return h("li", { "data-field": `planners.${index}` }, select("name", "Planner", planners), select("model", "Model", models), remove,
      h("label", { class: "tick" }, repair, "add missing steps"));
  }

  addMethod() {
    this.keep("methods", [...this.values.methods, { ...METHOD }]);
    this.drawMethods();
    byId("methods").lastElementChild.querySelector("select").focus();
  }

  removeMethod(index) {
    this.keep("methods", this.values.methods.filter((_, other) => other !== index));
    this.drawMethods();
    byId("methods").querySelectorAll("select")[0].focus();
  }

  /** About how many attempts it will come to, where that can be told from here. */
  count() {
    const suite = this.suite();
    const told = byId("measure-count");
    const { split, limit, categories, language, methods, runs } = this.values;
    if (!suite || categories.length || language !== "en") {
      told.textContent = "";
      return;
    }
    const half = { all: suite.tasks, test: suite.test, train: suite.tasks - suite.test }[split];
    const tasks = limit === "" ? half : Math.min(half, Number(limit));
    const attempts = tasks * methods.length * Number(runs);
    told.textContent = attempts > 0 ? `${tasks} tasks, ${attempts} attempts` : "";
  }

  request() {
    const { suite, methods, split, language, physics, categories } = this.values;
    const request = { suite, split, physics, categories, languages: [language] };
    request.planners = methods.map(({ name, model, repair }) => ({ ...(name && { name }), model, repair }));
    for (const name of NUMBERS) {
      const value = this.values[name];
      if (value !== "") request[name] = Number.isNaN(Number(value)) ? value : Number(value);
    }
    return request;
  }

  async submit(event) {
    event.preventDefault();
    if (this.busy) return;
    this.faults.clear();
    this.busy = true;
    const start = byId("measure-start");
    start.disabled = true;
    try {
      this.accepted(await post("/evaluations", this.request()));
    } catch (error) {
      this.faults.show(error);
    } finally {
      this.busy = false;
      start.disabled = false;
    }
  }
}
