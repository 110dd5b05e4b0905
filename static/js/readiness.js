// Whether a plan can be made right now.

import { byId } from "./dom.js";

const WAITING = 2000;
const READY = 20000;

async function look() {
  const told = byId("readiness");
  const [state, text] = await fetch("/readyz").then(
    async (answer) => (answer.ok ? ["ready", "Ready"] : ["waiting", (await answer.json().catch(() => ({}))).detail ?? "Getting ready"]),
    () => ["gone", "The service cannot be reached"],
  );
  if (told.textContent !== text) told.textContent = text;
  told.dataset.state = state;
  setTimeout(look, state === "ready" ? READY : WAITING);
}

export const watchReadiness = look;
