// What all parts use. Every part is a file; page.py joins them, in its order, into one function that runs at once.

const data = JSON.parse(document.getElementById("data").textContent);
const byId = id => document.getElementById(id);
const all = (selector, inside = document) => [...inside.querySelectorAll(selector)];

/** Three digits, no exponent where a unit follows: as text.py has it. */
const digits = (value, count = 3) => String(Number(value.toPrecision(count)));
const secondsText = seconds => seconds >= 1 ? `${digits(seconds)}\u00a0s` : `${digits(1e3 * seconds)}\u00a0ms`;
function unitText(value, units) {
  const [unit, name] = units.find(([least]) => value >= least);
  return digits(value / unit) + (name && `\u00a0${name}`);
}
const hitsText = hits => unitText(hits, [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""]]);
const bytesText = bytes => unitText(bytes, [[2 ** 40, "TiB"], [2 ** 30, "GiB"], [2 ** 20, "MiB"], [2 ** 10, "KiB"], [1, "B"]]);

/** An element with text or elements in it; attributes that are false or null are left out. */
function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value !== false && value !== null) element.setAttribute(key, value === true ? "" : value);
  }
  element.append(...children);
  return element;
}
