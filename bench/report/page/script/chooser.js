// "I need 5 %": the cheapest run of each family.

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
