// Connects the parts, and draws them.

function drawCases() {
  all(".case").forEach(block => { block.hidden = state.cases !== "all" && block.dataset.state !== state.cases; });
  all("#case-filter .chip").forEach(chip => chip.setAttribute("aria-pressed", chip.dataset.show === state.cases));
}

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
