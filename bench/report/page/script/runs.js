// The runs of the study, as Python has put them into the page.

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
