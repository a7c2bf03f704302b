// What is shown, in the address: a link shows the same.

const DEFAULTS = { a: "0", b: "0", fa: "exact", fb: "hardware", sa: "0", sb: "0", split: "0", exposure: "0", strength: "1", tilt: "0", turn: "0", camera: "" };
const state = { ...DEFAULTS, ...Object.fromEntries(new URLSearchParams(location.hash.slice(1))) };
const asked = name => new URLSearchParams(location.hash.slice(1)).has(name);

function remember(changes) {
  Object.assign(state, changes);
  const changed = Object.entries(state).filter(([name, value]) => name in DEFAULTS && value !== DEFAULTS[name]);
  history.replaceState(null, "", "#" + new URLSearchParams(changed));
}
