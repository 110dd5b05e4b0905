// A 3D view on its own, at /viewer/{execution}/: the picture and its controls, nothing around them.

import { RolloutView } from "./rollout.js";

new RolloutView(() => {}, { alone: true }).show(location.pathname.split("/")[2]);
