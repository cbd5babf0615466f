// What the page asks of the server, and whether it answers at all.

/** An answer that is a refusal: `status` (0: no answer), `findings`, and the whole `body`. */
export class ServerError extends Error {
  constructor(message, status, body) {
    super(message);
    this.status = status;
    this.findings = body.findings ?? [];
    this.body = body;
  }
}

/** `reach.changed(isThere, message)` is called when the server is lost or found again. */
export const reach = {isThere: true, changed: () => {}};

function tell(isThere, message) {
  if (reach.isThere === isThere) return;
  reach.isThere = isThere;
  reach.changed(isThere, message);
}

async function send(path, options) {
  let response;
  try {
    response = await fetch(path, options);
  } catch (error) {
    if (error.name === "AbortError") throw error;
    tell(false, "mien live has ended; start it again");
    throw new ServerError("mien live does not answer", 0, {});
  }
  if (response.ok) {
    tell(true, "");
    return response;
  }
  const body = await response.json().catch(() => ({}));
  if (response.status === 403 && /token/.test(body.error ?? ""))
    tell(false, "mien live was started anew; open the address that it prints");
  throw new ServerError(body.error ?? `${path}: ${response.status}`, response.status, body);
}

function post(path, body, signal) {
  return send(path, {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify(body), signal});
}

/** The JSON answer to a POST of `body`. */
export async function ask(path, body, signal) {
  return (await post(path, body, signal)).json();
}

/** The bytes that answer a POST of `body`. */
export async function askBinary(path, body, signal) {
  return (await post(path, body, signal)).arrayBuffer();
}

/** The JSON at `path`. */
export async function get(path, signal) {
  return (await send(path, {signal})).json();
}
