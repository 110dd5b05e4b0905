// The page: a form on one side, the plan that the address names on the other.

import { Earlier } from "./earlier.js";
import { watchReadiness } from "./readiness.js";
import { RequestForm } from "./request.js";
import { Watch } from "./watch.js";

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
  if (matchMedia("(max-width: 899px)").matches) document.getElementById("result").scrollIntoView();
}

function route() {
  const [, id] = /^#\/plans\/([^/]+)$/.exec(location.hash) ?? [];
  earlier.open(id ?? null);
  if (id) watch.open(decodeURIComponent(id));
  else watch.close();
}

window.addEventListener("hashchange", route);
watchReadiness();
await Promise.all([form.load(), earlier.load()]);
route();
