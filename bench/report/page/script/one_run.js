// One run at a time: hover, focus, pins.

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
