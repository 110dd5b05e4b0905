// The tables of an evaluation.

import { h } from "./dom.js";

/** One card's worth of tables; the first is open, the rest unfold and stay as they were left. */
export function drawTables(root, tables) {
  const open = new Map([...root.querySelectorAll("details")].map((part) => [part.dataset.table, part.open]));
  const focused = root.querySelector("summary:focus")?.parentElement.dataset.table;
  root.replaceChildren(...tables.map((table, index) => draw(table, open.get(table.name) ?? index === 0)));
  if (focused) root.querySelector(`[data-table="${CSS.escape(focused)}"] summary`)?.focus();
}

function draw(table, open) {
  if (!table.rows.length) return h("p", { class: "hint" }, `${table.title}: none.`);
  const head = h("tr", {}, table.columns.map((column) => h("th", { scope: "col" }, column)));
  const rows = table.rows.map((row) => h("tr", {}, row.map((entry, place) =>
    place ? cell(entry) : h("th", { scope: "row" }, String(entry ?? "–")))));
  return h("details", { open, "data-table": table.name },
    h("summary", {}, table.title),
    h("div", { class: "wide", tabindex: "0", role: "region", "aria-label": table.title }, h("table", {}, h("thead", {}, head), h("tbody", {}, rows))),
    table.note && h("p", { class: "hint" }, table.note));
}

function cell(entry) {
  if (entry === null || entry === undefined) return h("td", { class: "number" }, "–");
  if (typeof entry !== "object") return h("td", { class: typeof entry === "number" ? "number" : null }, String(entry));
  if ("printed" in entry) return h("td", { class: "number" }, entry.printed.toFixed(2));
  const [low, high] = entry.interval;
  const spread = entry.std === null ? "" : ` ± ${entry.std.toFixed(2)}`;
  const title = `95 % interval ${low.toFixed(2)} to ${high.toFixed(2)}, of ${entry.count}`;
  return h("td", { class: "number", title }, `${entry.mean.toFixed(2)}${spread}`, h("span", { class: "range" }, `${low.toFixed(2)} – ${high.toFixed(2)}`));
}
