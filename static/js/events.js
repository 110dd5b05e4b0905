// What happened, in words people use.

import { byId, h, seconds } from "./dom.js";

const STAGES = {
  look: "looks at it", perceive: "looks at it", see: "looks at it", approach: "moves towards it", reach: "reaches for it",
  grasp: "closes the gripper on it", lift: "lifts it", carry: "carries it over", place: "sets it down", lower: "lowers it",
  check: "looks whether it is there", release: "lets go", retreat: "draws back", home: "goes back to its place", settle: "waits until all is at rest",
};

/** [tone, text, detail] of an event, or null where it has nothing to tell. */
function words(event) {
  switch (event.kind) {
    case "planning_started":
      return ["", event.model ? `Planning with ${event.model}` : "Planning"];
    case "prompt_written":
      return ["soft", `The prompt is written, ${event.characters} characters`];
    case "program_grounded":
      return ["", `Understood: ${count(event.steps, "step")}${event.rejected ? `, ${event.rejected} rejected` : ""}`];
    case "planning_failed":
      return ["bad", "No plan came of it", event.reason];
    case "asked":
      return ["warn", "Asked back", event.reason];
    case "declined":
      return ["warn", "Declined", event.reason];
    case "execution_started":
      return ["", "The scene is set up"];
    case "comment_reached":
      return ["comment", event.text.replace(/^#\s*/, "")];
    case "action_started":
      return ["step", `${event.action}(${event.arguments.join(", ")})`];
    case "stage_reached":
      return ["soft", `${STAGES[event.stage] ?? event.stage}${event.attempt > 1 ? `, attempt ${event.attempt}` : ""}`];
    case "action_performed":
      return ["good", event.attempts > 1 ? `Done at attempt ${event.attempts}` : "Done"];
    case "action_failed":
      return ["bad", `Failed at “${event.stage}”`, event.reason + aim(event.pose)];
    case "call_skipped":
      return ["warn", `Skipped ${event.text}`, event.reason];
    case "assertion_checked":
      return [event.holds ? "good" : "warn", `Asserted ${event.condition}: ${event.holds ? "true" : "false"}${event.agree === false ? ", the model thinks otherwise" : ""}`];
    case "branch_decided":
      return ["", `If ${event.condition}: ${event.holds ? "yes" : "no"}`];
    case "completion_continued":
      return ["soft", "Cut off; the model goes on from the last whole line"];
    case "recovery_taken":
      return ["warn", event.calls ? `Recovering, ${count(event.calls, "call")}` : "There is no recovery for it"];
    case "goal_checked":
      return [event.holds ? "good" : "bad", `Goal ${event.condition}: ${event.holds ? "met" : "not met"}`];
    case "execution_finished":
      return ["", "The plan is through, everything is at rest"];
    default:
      return null;
  }
}

/** Where the gripper should have gone, in the robot's frame. */
const aim = (pose) => (pose ? `; gripper meant for ${pose.position.map((value) => value.toFixed(2)).join(", ")} m` : "");

const count = (number, noun) => `${number} ${noun}${number === 1 ? "" : "s"}`;

export class EventList {
  /** `seek(time)` moves the rollout there. */
  constructor(seek) {
    this.root = byId("events-view");
    this.seek = seek;
    this.reset();
  }

  reset(text = "Every step is told here, with the reason where one fails.") {
    this.timed = [];
    this.list = null;
    this.reached = null;
    this.root.replaceChildren(h("p", { class: "hint" }, text));
  }

  add(event) {
    // In a household an action is its only stage.
    if (event.kind === "stage_reached" && event.stage === this.action && event.attempt <= 1) return;
    if (event.kind === "action_started") this.action = event.action;
    const told = words(event);
    if (!told) return;
    if (!this.list) {
      this.list = h("ol", { class: "told", tabindex: "0", "aria-label": "Events" });
      this.root.replaceChildren(this.list);
    }
    const [tone, text, detail] = told;
    const content = [h("span", { class: "what" }, text), detail && h("span", { class: "why" }, detail)];
    const timed = event.time !== undefined;
    const body = timed
      ? h("button", { type: "button", onclick: () => this.seek(event.time) }, h("span", { class: "when" }, seconds(event.time)), ...content.filter(Boolean))
      : h("span", { class: "untimed" }, h("span", { class: "when" }), ...content.filter(Boolean));
    const item = h("li", { class: tone || null, "data-kind": event.kind }, body);
    if (timed) this.timed.push([event.time, item]);
    this.list.append(item);
  }

  /** Dim what the rollout has not come to yet, and keep in sight where it is [s]. */
  at(time) {
    let reached = null;
    for (const [when, item] of this.timed) {
      const ahead = when > time + 0.05;
      item.classList.toggle("ahead", ahead);
      if (!ahead) reached = item;
    }
    if (reached && reached !== this.reached && !this.list.matches(":hover, :focus-within")) {
      this.list.scrollTop = reached.offsetTop - this.list.clientHeight / 2;
    }
    this.reached = reached;
  }
}
