// Whether a plan can be made right now.

import { byId } from "./dom.js";

const WAITING = 2000;
const READY = 20000;
let again = null;

async function look() {
  clearTimeout(again);
  const told = byId("readiness");
  const [state, text] = await fetch("/readyz").then(
    async (answer) => (answer.ok ? ["ready", "Ready"] : ["waiting", (await answer.json().catch(() => ({}))).detail ?? "Getting ready"]),
    () => ["gone", "The service cannot be reached"],
  );
  if (told.textContent !== text) told.textContent = text;
  told.dataset.state = state;
  clearTimeout(again);
  again = setTimeout(look, state === "ready" ? READY : WAITING);
}

/** Look now and then, and at once when the service does not answer. */
export function watchReadiness() {
  window.addEventListener("unreachable", look);
  look();
}
