// What was typed, kept in this browser so that nothing is lost by a reload.

const KEY = "progprompt.";

export function recall(name, fallback) {
  try {
    const text = localStorage.getItem(KEY + name);
    return text === null ? fallback : JSON.parse(text);
  } catch {
    return fallback;
  }
}

export function remember(name, value) {
  try {
    localStorage.setItem(KEY + name, JSON.stringify(value));
  } catch {
    // Storage may be full or forbidden; the page works without.
  }
}
