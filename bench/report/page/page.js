// Makes the page answer: filters, other axes, targets, pins, pictures. All of it is there without this script, as tables and one chart a scene.
(() => {
"use strict";

const data = JSON.parse(document.getElementById("data").textContent);
const byId = id => document.getElementById(id);
const all = (selector, inside = document) => [...inside.querySelectorAll(selector)];

/** An element with text or elements in it; attributes that are false or null are left out. */
function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value !== false && value !== null) element.setAttribute(key, value === true ? "" : value);
  }
  element.append(...children);
  return element;
}

// ---- state, which lives in the URL

const START = { y: "error", x: "seconds", show: "best", pin: "", need: "5", scene: "", by: "seconds", cases: "all", set: "0", left: "", right: "", view: "slider",
  zoom: "1", sort: "", at: "" };
const state = { ...START };
const filters = {};  // facet -> values that are wanted; none: all
const pages = [];  // what each part does when the state has changed

function readState() {
  const words = new URLSearchParams(location.hash.includes("=") ? location.hash.slice(1) : "");
  for (const key of Object.keys(START)) state[key] = words.get(key) ?? START[key];
  for (const facet of Object.keys(filters)) delete filters[facet];
  for (const facet of Object.keys(data.charts?.facets ?? {})) {
    const wanted = words.getAll("f." + facet);
    if (wanted.length) filters[facet] = wanted;
  }
}

function writeState() {
  const words = new URLSearchParams();
  for (const [key, value] of Object.entries(state)) if (value !== START[key]) words.set(key, value);
  for (const [facet, values] of Object.entries(filters)) values.forEach(value => words.append("f." + facet, value));
  history.replaceState(null, "", words.size ? "#" + words : location.pathname);
}

function change(changes) {
  Object.assign(state, changes);
  writeState();
  pages.forEach(update => update());
}

// ---- the runs

const charts = data.charts;
const rows = charts ? charts.rows.map(values => Object.fromEntries(charts.columns.map((name, i) => [name, values[i]]))) : [];
const methodOf = row => charts.methods[row.method];
const pinned = () => state.pin.split(",").filter(Boolean).map(Number).filter(number => rows[number]);

function isActive(method) {
  if (state.show === "best") return method.best;
  return Object.entries(filters).every(([facet, wanted]) => !(facet in method.facts) || wanted.includes(method.facts[facet]));
}

/** The words that the table has for a run, by column: numbers are put into words once, in Python. */
function wordsOf(row) {
  const heads = all("#rows thead th").map(head => head.textContent);
  return Object.fromEntries(all("td", byId("t" + row.number)).map((cell, i) => [heads[i], cell.textContent]));
}

// ---- charts

const frame = charts?.frame;

function along(key, value) {
  const [low, high] = charts.limits[key].map(Math.log);
  return (Math.log(Math.max(Number.MIN_VALUE, value)) - low) / (high - low);
}
const inside = share => Math.min(1, Math.max(0, share));
const xAt = share => frame.left + share * (frame.right - frame.left);
const yAt = share => frame.bottom - share * (frame.bottom - frame.top);
const xOf = row => xAt(inside(along(state.x, row[state.x])));
const yOf = value => yAt(inside(along(state.y, value)));
const round = number => Math.round(number * 100) / 100;
const path = places => places.map(([x, y], i) => `${i ? "L" : "M"} ${round(x)} ${round(y)}`).join(" ");
const isShown = row => row[state.x] !== null && row[state.y] !== null && row.error !== null;

function placePoint(row) {
  const point = byId("p" + row.number), band = byId("b" + row.number), shown = isShown(row);
  if (!point) return;
  point.classList.toggle("absent", !shown);
  band?.classList.toggle("absent", !shown || !row[state.y + "_band"]);
  if (!shown) return;
  const x = round(xOf(row)), y = round(yOf(row[state.y]));
  for (const shape of point.querySelectorAll("use")) {
    shape.setAttribute("x", x);
    shape.setAttribute("y", y);
  }
  if (band && row[state.y + "_band"]) band.setAttribute("d", path(row[state.y + "_band"].map(end => [x, yOf(end)])));
}

function placeLine(line) {
  const points = all(".point", line.parentNode).map(point => rows[+point.id.slice(1)]).filter(isShown);
  line.setAttribute("d", path(points.map(row => [xOf(row), yOf(row[state.y])])));
}

/** A staircase: an error stays until a dearer run betters it. */
function frontPath(numbers) {
  const places = [];
  for (const row of numbers.map(number => rows[number])) {
    if (places.length) places.push([xOf(row), places.at(-1)[1]]);
    places.push([xOf(row), yOf(row[state.y])]);
  }
  return path(places);
}

function placeGhosts(panel) {
  const group = panel.querySelector(".ghosts"), lines = charts.ghosts[panel.dataset.scene][state.x] ?? [];
  const isNoisy = state.y === "error" || state.y === "noise";
  group.replaceChildren(...(isNoisy ? lines : []).map(ghost => {
    const line = document.createElementNS("http://www.w3.org/2000/svg", "path");
    line.setAttribute("d", path(ghost.line.map(([cost, noise]) => [xAt(along(state.x, cost)), yAt(along(state.y, noise))])));
    return line;
  }));
}

/** Bright series last, so that they lie above the others. */
function brighten(panel) {
  const groups = all(".series", panel);
  for (const group of groups) group.classList.toggle("dim", !isActive(charts.methods[+group.dataset.method]));
  const isDim = group => group.classList.contains("dim"), order = [...groups.filter(isDim), ...groups.filter(group => !isDim(group))];
  if (order.some((group, i) => group !== groups[i])) panel.append(...order);  // what is moved loses the focus
}

function drawPanel(panel) {
  const scene = panel.dataset.scene, pair = state.x + "/" + state.y;
  panel.querySelector(".x-axis").setAttribute("href", "#axis-" + state.x);
  panel.querySelector(".y-axis").setAttribute("href", "#axis-" + state.y);
  panel.querySelector(".front").setAttribute("d", frontPath(charts.fronts[pair][scene]));
  panel.setAttribute("aria-label", `${scene}: ${charts.labels[state.y]} over ${charts.labels[state.x]}`);
  panel.closest("figure").querySelector(".finding").textContent = charts.findings[pair][scene];
  all(".line", panel).forEach(placeLine);
  placeGhosts(panel);
  brighten(panel);
  rove(panel);
}

const panels = all(".panel[data-scene]");

function drawCharts() {
  rows.forEach(placePoint);
  panels.forEach(drawPanel);
  const chosen = pinned();
  all(".pinned").forEach(element => element.classList.remove("pinned"));
  for (const number of chosen) for (const id of ["p", "t"]) byId(id + number)?.classList.add("pinned");
  for (const item of all(".legend li")) item.hidden = !isActive(charts.methods[+item.dataset.method]);
  for (const row of rows) byId("t" + row.number).classList.toggle("dim", !isActive(methodOf(row)));
}

// ---- one run at a time: hover, focus, pins

const tip = byId("tip");

function describe(row, x, y) {
  const words = wordsOf(row);
  tip.replaceChildren(make("b", {}, words.method), ...["scene", "hits", "error", "95 % band", "bias", "noise", "FLIP", "time", "finished bytes", "working bytes"]
    .map(name => make("div", {}, `${name}: ${words[name]}`)));
  tip.hidden = false;
  const box = tip.getBoundingClientRect();
  tip.style.left = Math.max(4, Math.min(x + 14, innerWidth - box.width - 8)) + "px";
  tip.style.top = Math.max(4, y + 14 + box.height > innerHeight ? y - 14 - box.height : y + 14) + "px";
}

function forget() {
  tip.hidden = true;
  all(".point.near").forEach(point => point.classList.remove("near"));
}

/** The runs of a panel that keys and pointer reach. */
const reachable = panel => all(".series:not(.dim) .point:not(.absent)", panel).map(point => rows[+point.id.slice(1)]);

const byCost = (a, b) => xOf(a) - xOf(b) || a.number - b.number;
const byError = (a, b) => yOf(b[state.y]) - yOf(a[state.y]) || a.number - b.number;

/** One point of each panel takes part in the tab order. */
function rove(panel, wanted) {
  const there = reachable(panel).sort(byCost);
  const row = wanted ?? there.find(r => byId("p" + r.number).tabIndex === 0) ?? there[0];
  all(".point[tabindex='0']", panel).forEach(point => point.setAttribute("tabindex", -1));
  if (row) byId("p" + row.number).setAttribute("tabindex", 0);
}

function step(panel, row, key) {
  const order = reachable(panel).sort(key === "ArrowUp" || key === "ArrowDown" ? byError : byCost), at = order.indexOf(row);
  if (key === "Home") return order[0];
  if (key === "End") return order.at(-1);
  return order[(at + (key === "ArrowRight" || key === "ArrowUp" ? 1 : order.length - 1)) % order.length];
}

function togglePin(number) {
  const chosen = pinned();
  const next = chosen.includes(number) ? chosen.filter(n => n !== number) : [...chosen, number].slice(-2);
  change({ pin: next.join(",") });
}

function onKey(event) {
  const point = event.target.closest(".point"), panel = event.currentTarget;
  if (!point) return;
  const row = rows[+point.id.slice(1)];
  if (["ArrowRight", "ArrowLeft", "ArrowUp", "ArrowDown", "Home", "End"].includes(event.key)) {
    const next = step(panel, row, event.key);
    rove(panel, next);
    byId("p" + next.number).focus();
  } else if (event.key === "Enter" || event.key === " ") {
    togglePin(row.number);
    byId("p" + row.number).focus();
  } else if (event.key === "Escape") {
    change({ pin: "" });
  } else return;
  event.preventDefault();
}

const REACH = 16;  // of the pointer, in units of the chart

function nearest(panel, event) {
  const box = panel.getBoundingClientRect(), scale = panel.viewBox.baseVal.width / box.width;
  const x = (event.clientX - box.left) * scale, y = (event.clientY - box.top) * scale;
  let found = null, least = REACH;
  for (const row of reachable(panel)) {
    const distance = Math.hypot(xOf(row) - x, yOf(row[state.y]) - y);
    if (distance < least) [found, least] = [row, distance];
  }
  return found;
}

function onMove(event) {
  const row = nearest(event.currentTarget, event);
  forget();
  if (!row) return;
  byId("p" + row.number).classList.add("near");
  describe(row, event.clientX, event.clientY);
}

function onClick(event) {
  const row = nearest(event.currentTarget, event);
  if (row) togglePin(row.number);
}

function listenToPanel(panel) {
  for (const title of all(".point > title", panel)) {  // the tip says more, and sooner
    title.parentNode.setAttribute("aria-label", title.textContent);
    title.remove();
  }
  panel.addEventListener("keydown", onKey);
  panel.addEventListener("pointermove", onMove);
  panel.addEventListener("pointerleave", forget);
  panel.addEventListener("click", onClick);
  panel.addEventListener("focusin", event => {
    const point = event.target.closest(".point");
    if (!point) return;
    const box = point.getBoundingClientRect();
    describe(rows[+point.id.slice(1)], box.right, box.bottom);
  });
  panel.addEventListener("focusout", forget);
}

/** What the pinned runs have, and where two of them differ. */
function drawPins() {
  const chosen = pinned().map(number => rows[number]), place = byId("pins");
  if (!chosen.length) return place.replaceChildren();
  const words = chosen.map(row => ({ ...methodOf(row).facts, ...wordsOf(row) }));
  const names = [...new Set(words.flatMap(Object.keys))];
  const differs = name => new Set(words.map(word => word[name])).size > 1 && "differs";
  const heads = names.map(name => make("th", { scope: "col" }, charts.facets[name] ?? name));
  const lines = words.map(word => make("tr", {}, ...names.map(name => make("td", { class: differs(name) }, word[name] ?? "-"))));
  const clear = make("button", { type: "button" }, "unpin");
  clear.addEventListener("click", () => change({ pin: "" }));
  const head = chosen.length > 1 ? "Two pinned runs; bold: where they differ. " : "One pinned run; pin another one to compare. ";
  place.replaceChildren(make("p", {}, head, clear), make("div", { class: "scroll" }, make("table", {}, make("thead", {}, make("tr", {}, ...heads)), make("tbody", {}, ...lines))));
}

// ---- filters, axes, table

function listenToFilters() {
  for (const key of ["x", "y"]) byId(key).addEventListener("change", event => change({ [key]: event.target.value }));
  byId("best").addEventListener("click", () => change({ show: "best" }));
  byId("all").addEventListener("click", () => {
    Object.keys(filters).forEach(facet => delete filters[facet]);
    change({ show: "all" });
  });
  for (const chip of all(".chip[data-facet]")) chip.addEventListener("click", () => {
    const { facet, value } = chip.dataset, wanted = filters[facet] ?? [];
    filters[facet] = wanted.includes(value) ? wanted.filter(v => v !== value) : [...wanted, value];
    if (!filters[facet].length) delete filters[facet];
    change({ show: "all" });
  });
  byId("csv").addEventListener("click", download);
}

function drawFilters() {
  byId("x").value = state.x;
  byId("y").value = state.y;
  const best = state.show === "best", none = !Object.keys(filters).length;
  byId("best").setAttribute("aria-pressed", best);
  byId("all").setAttribute("aria-pressed", !best && none);
  for (const chip of all(".chip[data-facet]")) chip.setAttribute("aria-pressed", !best && (filters[chip.dataset.facet] ?? []).includes(chip.dataset.value));
}

/** The runs that are not grey, as they are in the charts' data: per cent, seconds, bytes. */
function csvText() {
  const cell = value => Array.isArray(value) ? value.join(" ") : /[",\n]/.test(value ?? "") ? `"${value.replaceAll('"', '""')}"` : value ?? "";
  const lines = rows.filter(row => isActive(methodOf(row))).map(row => charts.columns.map(name => cell(name === "method" ? methodOf(row).name : row[name])).join(","));
  return [charts.columns.join(","), ...lines].join("\n") + "\n";
}

function download() {
  const address = URL.createObjectURL(new Blob([csvText()], { type: "text/csv" }));
  make("a", { href: address, download: "runs.csv" }).click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}

const SORTED = ["scene", "method", "hits", "seeds", "error", "error", "bias", "noise", "flip", "seconds", "bytes", "working"];  // what each column of the table sorts by

function sortTable() {
  const [column, direction] = state.sort.split(".").map(Number), body = byId("rows").tBodies[0];
  all("#rows th").forEach((head, i) => head.setAttribute("aria-sort", state.sort && i === column ? (direction > 0 ? "ascending" : "descending") : "none"));
  const key = state.sort ? SORTED[column] : "number", sign = direction || 1;
  const value = row => key === "method" ? methodOf(row).name : row[key] ?? Infinity;
  const compare = (a, b) => { const [p, q] = [value(a), value(b)]; return p < q ? -sign : p > q ? sign : a.number - b.number; };
  const order = [...rows].sort(compare).map(row => byId("t" + row.number));
  if (order.some((line, i) => body.rows[i] !== line)) body.append(...order);
}

function listenToTable() {
  all("#rows th").forEach((head, column) => {
    const button = make("button", { type: "button" }, head.textContent);
    button.addEventListener("click", () => change({ sort: `${column}.${state.sort === `${column}.1` ? -1 : 1}` }));
    head.replaceChildren(button);
  });
}

// ---- "I need 5 %"

/** One a family: the cheapest run within the target, else the most accurate one. As chooser.py has it. */
function offers(scene, target, cost) {
  const { families, familyOf } = data.chooser, made = [];
  for (const family of Object.keys(families)) {
    const there = rows.filter(row => row.scene === scene && row.error > 0 && familyOf[methodOf(row).name] === family);
    if (!there.length) continue;
    const within = there.filter(row => row.error <= target);
    const least = (list, key) => list.reduce((a, b) => key(b) < key(a) || (key(b) === key(a) && b.error < a.error) ? b : a);
    const row = within.length ? least(within, r => r[cost]) : least(there, r => r.error);
    made.push({ family, row, reached: within.length > 0, most: there.reduce((a, b) => b.hits_asked > a.hits_asked ? b : a) });
  }
  return made.sort((a, b) => b.reached - a.reached || (a.reached ? a.row[cost] - b.row[cost] : a.row.error - b.row.error));
}

function commandOf(row) {
  return data.chooser.commands[methodOf(row).name].replace("SCENE", row.scene).replace("HITS", data.chooser.hitsWords[row.hits_asked]);
}

function copyButton(text) {
  const button = make("button", { type: "button" }, "copy");
  button.addEventListener("click", () => navigator.clipboard.writeText(text).then(() => { button.textContent = "copied"; }, () => { button.textContent = "select it, then copy"; }));
  return button;
}

function offerLine(offer, found, cost) {
  const words = wordsOf(offer.row), family = data.chooser.families[offer.family], name = make("b", {}, methodOf(offer.row).name);
  if (!offer.reached) {
    const said = `not reached up to ${wordsOf(offer.most).hits} hits: best is ${words.error}`;
    return [offer.row.scene, family, said, "", "", "", name];
  }
  const several = found.filter(other => other.reached).length > 1;
  const ratio = several ? `${Number((offer.row[cost] / found[0].row[cost]).toPrecision(2))} ×` : "";
  const command = make("code", { class: "command" }, commandOf(offer.row));
  return [offer.row.scene, family, words.error, words.time, words["finished bytes"], ratio, make("span", {}, name, " ", command, " ", copyButton(commandOf(offer.row)))];
}

function drawOffers() {
  if (document.activeElement !== byId("target")) byId("target").value = state.need;  // half a number is not taken away from who types it
  byId("target-scene").value = state.scene;
  byId("target-cost").value = state.by;
  const target = Number(state.need);
  const scenes = charts.scenes.includes(state.scene) ? [state.scene] : charts.scenes;
  const lines = !(target > 0) ? [] : scenes.flatMap(scene => {
    const found = offers(scene, target, state.by);
    return found.map(offer => make("tr", { "data-row": offer.row.number, "data-reached": String(offer.reached) }, ...offerLine(offer, found, state.by).map(cell => make("td", {}, cell))));
  });
  const head = make("thead", {}, make("tr", {}, ...data.chooser.heads.map(word => make("th", { scope: "col" }, word))));
  const table = make("table", { class: "offers" }, head, make("tbody", {}, ...lines));
  byId("offers").replaceChildren(lines.length ? make("div", { class: "scroll" }, table) : make("p", {}, "A target is a number of per cent above zero."));
}

function listenToTarget() {
  byId("target").addEventListener("input", event => change({ need: event.target.value }));
  byId("target-scene").addEventListener("change", event => change({ scene: event.target.value }));
  byId("target-cost").addEventListener("change", event => change({ by: event.target.value }));
}

// ---- pictures

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

// ---- stability

function drawCases() {
  all(".case").forEach(block => { block.hidden = state.cases !== "all" && block.dataset.state !== state.cases; });
  all("#case-filter .chip").forEach(chip => chip.setAttribute("aria-pressed", chip.dataset.show === state.cases));
}

// ---- start

function start() {
  readState();
  if (charts) {
    panels.forEach(listenToPanel);
    listenToFilters();
    listenToTable();
    listenToTarget();
    pages.push(drawFilters, drawCharts, drawPins, sortTable, drawOffers);
  }
  if (sets.length) pages.push(drawViewer);
  all("#case-filter .chip").forEach(chip => chip.addEventListener("click", () => change({ cases: chip.dataset.show })));
  pages.push(drawCases);
  pages.forEach(update => update());
  addEventListener("hashchange", () => { readState(); pages.forEach(update => update()); });
  addEventListener("beforeprint", () => all("details.printed").forEach(block => { block.open = true; }));
  for (const anchor of all("nav a")) anchor.addEventListener("click", event => {  // an anchor of its own would take the state's place
    event.preventDefault();
    change({ at: anchor.hash.slice(1) });
    byId(state.at).scrollIntoView();
  });
  if (state.at) byId(state.at)?.scrollIntoView();
}

start();
})();
