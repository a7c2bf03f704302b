// What the reader has chosen. It lives in the URL.

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
