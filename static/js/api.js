// The service as this page uses it: the same requests as everybody's.

const PATIENCE = 3000; // [ms] in which a broken connection is taken up unnoticed

/** An error of the service: a problem document (RFC 9457). */
export class Problem extends Error {
  constructor(content, status) {
    super(content.detail || content.title || `The service answered ${status}.`);
    this.status = status;
    this.errors = content.errors || [];
  }
}

async function answer(response) {
  const content = await response.json().catch(() => ({}));
  if (!response.ok) throw new Problem(content, response.status);
  return content;
}

/** What is at `path`. */
export async function get(path) {
  return answer(await reach(path, { headers: { Accept: "application/json" } }));
}

/** All entries of the list at `path`, part after part. */
export async function all(path) {
  const items = [];
  let next = "";
  do {
    const part = await get(`${path}?limit=1000${next && `&cursor=${next}`}`);
    items.push(...part.items);
    next = part.next;
  } while (next);
  return items;
}

/** Sends `body` to `path`. */
export const post = (path, body = {}, headers = {}) => send("POST", path, body, headers);

/** Puts `body` at `path`. */
export const put = (path, body) => send("PUT", path, body);

async function send(method, path, body, headers = {}) {
  return answer(
    await reach(path, {
      method,
      headers: { "Content-Type": "application/json", ...headers },
      body: JSON.stringify(body),
    }),
  );
}

async function reach(path, options) {
  try {
    return await fetch(path, options);
  } catch {
    window.dispatchEvent(new Event("unreachable"));
    throw new Problem({ detail: "The service cannot be reached. It may be restarting; try again." }, 0);
  }
}

/**
 * Follows Server-Sent Events: `told` gets each event once, `ended` the last message.
 * A broken connection is taken up where it broke; `after` leaves out what is known already.
 * `away(true)` is called if that takes long, `away(false)` when it is done.
 * Returns a function that stops it.
 */
export function follow(path, { told, ended, away, after = -1 }) {
  let source = null;
  let timer = null;
  let missed = null;
  let last = after;
  const open = () => {
    source = new EventSource(path);
    source.onopen = () => {
      clearTimeout(missed);
      missed = null;
      away(false);
    };
    source.onmessage = (message) => {
      const event = JSON.parse(message.data);
      if (event.sequence <= last) return;
      last = event.sequence;
      told(event);
    };
    source.addEventListener("end", (message) => {
      stop();
      ended(JSON.parse(message.data));
    });
    source.onerror = () => {
      window.dispatchEvent(new Event("unreachable"));
      missed ??= setTimeout(() => away(true), PATIENCE);
      if (source.readyState === EventSource.CLOSED) timer = setTimeout(open, 1500);
    };
  };
  const stop = () => {
    clearTimeout(timer);
    clearTimeout(missed);
    source.close();
  };
  open();
  return stop;
}
