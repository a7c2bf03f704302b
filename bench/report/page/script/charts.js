// Moves points, lines and axes to what the reader wants to see.

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
