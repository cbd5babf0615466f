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

/**
 * `reach.changed(isThere, message)` is called when the server is lost or found again, `reach.forgot(doc)` when it
 * knows a text no more.
 */
export const reach = {isThere: true, changed: () => {}, forgot: () => {}};

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

async function post(path, body, signal) {
  try {
    return await send(path, {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify(body), signal});
  } catch (error) {
    error.isForgotten = body.doc !== undefined && /not known any more/.test(error.message);
    if (error.isForgotten) reach.forgot(body.doc);
    throw error;
  }
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
