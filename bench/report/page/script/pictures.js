// Two pictures of one scene over each other.

const sets = all(".pictures");
let flipped = false, cutAt = 50, drawn = "";

/** role -> {src, words} of what a set can show. */
function itemsOf(set) {
  const found = {};
  let owner = "";
  for (const figure of all("figure", set)) {
    const picture = figure.querySelector("img"), title = figure.querySelector("b")?.textContent;
    if (title === "difference") continue;
    if (figure.dataset.role) owner = figure.dataset.role;
    found[figure.dataset.role ?? owner + "-flip"] = { src: picture.getAttribute("src"), title: figure.dataset.role ? title : `FLIP of the ${owner.replace("-", " ")}`, words: figure.querySelector("figcaption").textContent };
  }
  return found;
}

function choice(key, values, words) {
  const select = make("select", { id: "picture-" + key, "aria-label": key }, ...values.map((value, i) => make("option", { value, selected: value === state[key] }, words[i])));
  select.addEventListener("change", event => change({ [key]: event.target.value }));
  return select;
}

function sideOf(items, wanted, place) {
  const names = Object.keys(items);
  return items[wanted] ? wanted : names[Math.min(place, names.length - 1)];
}

function drawViewer() {
  const wanted = [state.set, state.left, state.right, state.view, state.zoom].join(), focused = document.activeElement.id;
  if (wanted === drawn) return;
  drawn = wanted;
  const number = sets[+state.set] ? +state.set : 0, items = itemsOf(sets[number]), names = Object.keys(items);
  sets.forEach((set, i) => { set.hidden = i !== number; });
  const left = sideOf(items, state.left, items.reference ? 1 : 0), right = sideOf(items, state.right, items.reference ? Math.min(3, names.length - 1) : 1);
  const split = make("input", { type: "range", min: 0, max: 100, value: cutAt, "aria-label": "where the left picture ends" });
  const pictures = [right, left].map(role => make("img", { src: items[role].src, alt: items[role].words }));
  const one = make("div", { class: state.view === "difference" ? "frame difference" : "frame" }, ...pictures);
  one.style.width = 100 * Number(state.zoom) + "%";
  const cut = () => { pictures[1].style.clipPath = flipped ? "inset(0)" : `inset(0 ${100 - cutAt}% 0 0)`; };
  const flip = on => { flipped = on; cut(); };
  split.addEventListener("input", () => { cutAt = +split.value; cut(); });
  const hold = make("button", { type: "button", id: "flip" }, "hold (or hold F): the left one alone");
  for (const name of ["pointerdown", "pointerup", "pointerleave"]) hold.addEventListener(name, () => flip(name === "pointerdown"));
  const viewer = byId("viewer"), labels = names.map(name => items[name].title);
  viewer.onkeydown = event => { if (event.key.toLowerCase() === "f" && !event.target.matches("select")) { flip(true); event.preventDefault(); } };
  viewer.onkeyup = event => { if (event.key.toLowerCase() === "f") flip(false); };
  const controls = make("p", { class: "controls" },
    choice("set", sets.map((_, i) => String(i)), sets.map(set => `${set.dataset.scene}, ${set.dataset.title}`)),
    make("label", {}, "left ", withValue(choice("left", names, labels), left)), make("label", {}, "right ", withValue(choice("right", names, labels), right)),
    choice("view", ["slider", "difference"], ["slider", "difference, four times as bright"]),
    make("label", {}, "zoom ", choice("zoom", ["1", "2", "4", "8"], ["1 ×", "2 ×", "4 ×", "8 ×"])), hold);
  const stage = make("div", { class: "stage", tabindex: 0, role: "group", "aria-label": "pictures; hold F to flip" }, one);
  viewer.replaceChildren(controls, stage, ...(state.view === "slider" ? [split] : []),
    make("div", { class: "sides" }, make("span", {}, "left: " + items[left].words), make("span", {}, "right: " + items[right].words)));
  cut();
  if (focused.startsWith("picture-")) byId(focused)?.focus();
}

function withValue(select, value) {
  select.value = value;
  return select;
}
