// Filters, axes and the table of the runs.

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
