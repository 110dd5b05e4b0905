// The page: a form on one side, the plan or the evaluation that the address names on the other.

import { byId, reveal } from "./dom.js";
import { Earlier } from "./earlier.js";
import { Evaluations } from "./evaluations.js";
import { watchReadiness } from "./readiness.js";
import { RequestForm } from "./request.js";
import { Watch } from "./watch.js";

const evaluations = new Evaluations();
const earlier = new Earlier();
const form = new RequestForm((plan) => show(plan));
const watch = new Watch({
  reuse: (plan) => form.take(plan),
  changed: (plan) => earlier.update(plan),
  followed: (plan) => show(plan),
  settings: () => form.settings.request(),
});

function show(plan) {
  earlier.update(plan);
  location.hash = `#/plans/${plan.id}`;
  reveal(byId("result"));
}

function route() {
  const [, part, id] = /^#\/(plans|evaluations)(?:\/([^/]+))?$/.exec(location.hash) ?? [];
  const measuring = part === "evaluations";
  byId("desk").hidden = measuring;
  byId("evaluations").hidden = !measuring;
  byId("to-evaluations").setAttribute("aria-current", measuring ? "page" : "false");
  const named = id ? decodeURIComponent(id) : null;
  if (measuring) evaluations.open(named);
  else evaluations.close();
  const plan = measuring ? null : named;
  earlier.open(plan);
  if (plan) watch.open(plan);
  else watch.close();
}

byId("skip").addEventListener("click", (event) => {
  // The address names the plan: it must not become the name of a place on the page.
  event.preventDefault();
  const shown = byId(byId("desk").hidden ? "evaluations" : "result");
  shown.scrollIntoView();
  shown.focus();
});
window.addEventListener("hashchange", route);
watchReadiness();
await Promise.all([form.load(), earlier.load()]);
route();
