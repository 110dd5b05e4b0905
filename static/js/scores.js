// The paper's scores and the goal conditions behind them.

import { byId, h } from "./dom.js";

const SCORES = [
  ["sr", "SR", "Success rate: 1 if every goal condition holds at the end"],
  ["plan_sr", "Plan SR", "The same with a perfect robot: would the plan have done it?"],
  ["gcr", "GCR", "Goal condition recall: the share of goal conditions that hold"],
  ["exec", "Exec", "Executability: the share of actions that could be carried out"],
  ["precision", "Precision", "What should not change and did not"],
];

export class ScoreBoard {
  constructor() {
    this.root = byId("scores-view");
    this.reset();
  }

  reset(text = "Scores appear when the rollout is over.") {
    this.conditions = new Map();
    this.root.replaceChildren(h("p", { class: "hint" }, text));
  }

  /** A goal condition was read from the world. */
  check(event) {
    this.conditions.set(event.condition, event.holds);
  }

  show(plan, execution) {
    const scores = { ...execution?.scores, plan_sr: plan.plan_scores?.sr };
    if (!execution?.scores && scores.plan_sr === undefined) return;
    const tiles = SCORES.map(([name, label, meaning]) => {
      const value = scores[name];
      const known = typeof value === "number";
      const tone = !known ? "unknown" : value >= 0.999 ? "good" : value <= 0.001 ? "bad" : "part";
      return h("div", { class: `tile ${tone}`, title: meaning, "data-score": name },
        h("dt", {}, h("abbr", { title: meaning }, label)), h("dd", {}, known ? number(value) : "–"));
    });
    const children = [h("dl", { class: "tiles" }, tiles)];
    if (plan.goal.length) children.push(this.goal(plan.goal));
    else children.push(h("p", { class: "hint" }, "No goal was given, so only executability is scored. Add goal conditions to the task to score success."));
    this.root.replaceChildren(...children);
  }

  goal(conditions) {
    // The service writes conditions its own way; told in order, they are ours.
    const told = [...this.conditions];
    return h("ul", { class: "goal code", "aria-label": "Goal conditions" }, conditions.map((condition, index) => {
      const holds = this.conditions.get(condition) ?? told[index]?.[1];
      const [sign, meaning] = holds === undefined ? ["·", "not read yet"] : holds ? ["✓", "met"] : ["✗", "not met"];
      return h("li", { class: holds === undefined ? "" : holds ? "good" : "bad" },
        h("span", { class: "mark", "aria-hidden": "true" }, sign), ` ${condition} `, h("span", { class: "sr-only" }, meaning));
    }));
  }
}

/** Two digits, or as many as it takes not to look like 1 where it is less. */
function number(value) {
  if (Number.isInteger(value)) return String(value);
  return value < 1 && value >= 0.995 ? String(Math.min(0.9999, Math.floor(value * 10000) / 10000)) : value.toFixed(2);
}
