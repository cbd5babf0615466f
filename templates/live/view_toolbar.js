// The view's buttons: from where the face is seen, and what is drawn over it.

const kSides = [["clip", "Clip", "The clip's camera (C)"], ["front", "Front", "From the front (1)"],
                ["three_quarter", "3/4", "Three-quarter view (2)"], ["side", "Side", "From the side (3)"]];
const kToggles = [["wire", "Wire", "The mesh"], ["guides", "Guides", "Loomis' guide lines"],
                  ["landmarks", "Landmarks", "Named places"], ["areas", "Areas", "What each area moves, and its limits"]];

function makeButton(text, title, name, press) {
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = text;
  button.title = title;
  button.dataset.name = name;
  button.setAttribute("aria-pressed", "false");
  button.addEventListener("click", press);
  return button;
}

/** `show()` puts the buttons to what the view does. */
export function createToolbar(view) {
  const element = document.createElement("div");
  element.className = "view_toolbar";
  element.setAttribute("role", "toolbar");
  element.setAttribute("aria-label", "Face");
  const tell = (work) => work.catch((error) => view.tell("error", {message: error.message}));
  const sides = kSides.map(([name, text, title]) => makeButton(text, title, `side_${name}`, () => view.setSide(name)));
  const toggles = kToggles.map(([name, text, title]) =>
    makeButton(text, title, name, () => tell(view.setToggle(name, !view.toggles[name]))));
  const beside = makeButton("Beside", "Keep this face on the left, to compare", "beside",
                            () => tell(view.setToggle("beside", !view.toggles.beside)));
  const ghost = document.createElement("select");
  ghost.dataset.name = "ghost";
  ghost.setAttribute("aria-label", "Ghost");
  ghost.title = "Another face through this one";
  for (const [value, text] of [["", "No ghost"], ["rest", "Ghost: at rest"], ["key", "Ghost: key before"]]) {
    const option = document.createElement("option");
    option.value = value;
    option.textContent = text;
    ghost.append(option);
  }
  ghost.addEventListener("change", () => tell(view.setToggle("ghost", ghost.value)));
  const gap = () => Object.assign(document.createElement("span"), {className: "gap"});
  element.append(...sides, gap(), ...toggles, beside, ghost);

  function findSide() {
    if (!view.orbit) return "clip";
    const {angle, height, distance} = view.orbit;
    if (height !== 0 || distance !== 1) return "";
    return {0: "front", 35: "three_quarter", 90: "side"}[angle] ?? "";
  }
  function show() {
    const side = findSide();
    sides.forEach((button, i) => button.setAttribute("aria-pressed", String(kSides[i][0] === side)));
    toggles.forEach((button, i) => button.setAttribute("aria-pressed", String(view.toggles[kToggles[i][0]])));
    beside.setAttribute("aria-pressed", String(view.toggles.beside));
    ghost.value = view.toggles.ghost;
  }
  return {element, show};
}
