// Building the page's elements.

/** An element; `attributes` become properties if it has them, else attributes; `children` are elements or text. */
export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (name === "on") for (const [event, listener] of Object.entries(value)) element.addEventListener(event, listener);
    else if (name === "data") Object.assign(element.dataset, value);
    else if (name in element && name !== "list" && name !== "form") element[name] = value;
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

/** The element with this id. */
export const find = (id) => document.getElementById(id);

/** A button. */
export function makeButton(text, action, attributes = {}) {
  return make("button", {type: "button", ...attributes, on: {click: action}}, text);
}

/** Something kept between visits; `otherwise` where the browser keeps nothing. */
export function recall(name, otherwise) {
  try {
    return JSON.parse(localStorage.getItem(`mien.${name}`)) ?? otherwise;
  } catch {
    return otherwise;
  }
}

/** Keeps `value` for `recall`. */
export function remember(name, value) {
  try {
    localStorage.setItem(`mien.${name}`, JSON.stringify(value));
  } catch {
    // A private window keeps nothing.
  }
}

/** Whether what is typed now belongs to `target`: no shortcut may take it. */
export function isTyping(target) {
  return target instanceof Element &&
    (target.closest(".CodeMirror, textarea, select, dialog, [role=listbox]") !== null ||
     (target.tagName === "INPUT" && !["checkbox", "button"].includes(target.type)));
}
