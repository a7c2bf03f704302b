// "I need 5 %": the cheapest method of each family, as chooser.py has it.

const LEAST_SHARE = Math.sqrt(1e-3); // of the target; errors near zero are taken for no less, as targets.py does

/** Where a method's error first falls to the target: a straight line in log-log between the runs on both sides. Null where it does not. */
function reach(runs, target) {
  const first = runs.findIndex(run => run.error <= target);
  if (first < 0) return null;
  const row = runs[first], before = first > 0 ? runs[first - 1] : null;
  const height = run => Math.log(Math.max(run.error, LEAST_SHARE * target));
  const along = before && (height(before) - Math.log(target)) / (height(before) - height(row));
  const between = key => before ? before[key] * (row[key] / before[key]) ** along : row[key];
  return { reached: true, row, before, hits: between("hits_asked"), seconds: between("seconds"), bytes: between("bytes") };
}

const least = (list, key) => list.reduce((a, b) => key(b) < key(a) ? b : a);

/** One a family: the cheapest that reaches the target, else the most accurate run. */
function offers(scene, target, cost) {
  const { families, familyOf } = data.chooser, made = [];
  for (const family of Object.keys(families)) {
    const there = rows.filter(row => row.scene === scene && row.error !== null && familyOf[methodOf(row).name] === family);
    if (!there.length) continue;
    const names = [...new Set(there.map(row => row.method))];
    const runsOf = name => there.filter(row => row.method === name).sort((a, b) => a.hits_asked - b.hits_asked);
    const reached = names.map(name => reach(runsOf(name), target)).filter(Boolean);
    const best = reached.length ? least(reached, offer => offer[cost]) : { reached: false, row: least(there, row => row.error) };
    made.push({ ...best, family, most: least(there, row => -row.hits_asked) });
  }
  return made.sort((a, b) => b.reached - a.reached || (a.reached ? a[cost] - b[cost] : a.row.error - b.row.error));
}

/** For a command line, two digits, rounded up: 2.4e6 */
function hitsWord(hits) {
  const step = 10 ** (Math.floor(Math.log10(hits)) - 1);
  return Number((Math.ceil(hits / step - 1e-9) * step).toPrecision(2)).toExponential().replace("+", "");
}

function commandOf(offer) {
  return data.chooser.commands[methodOf(offer.row).name].replace("SCENE", offer.row.scene).replace("HITS", hitsWord(offer.hits));
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
    return [offer.row.scene, family, said, "", "", "", "", name];
  }
  const several = found.filter(other => other.reached).length > 1;
  const ratio = several ? `${digits(offer[cost] / found[0][cost], 2)} ×` : "", most = offer.before ? "" : "at most ";
  const measured = [offer.before, offer.row].filter(Boolean).map(row => `${wordsOf(row).error} at ${hitsText(row.hits_asked)}`).join(", ");
  const command = make("code", { class: "command" }, commandOf(offer));
  const method = make("span", {}, name, " ", command, " ", copyButton(commandOf(offer)));
  return [offer.row.scene, family, most + hitsText(offer.hits), most + secondsText(offer.seconds), bytesText(offer.bytes), ratio, measured, method];
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
