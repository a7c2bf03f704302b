// What all parts use. Every part is a file; the program joins them into one function that runs at once.

const byId = id => document.getElementById(id);

/** An element with text or elements in it; attributes that are false or null are left out. */
function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value !== false && value !== null) element.setAttribute(key, value === true ? "" : value);
  }
  element.append(...children);
  return element;
}

/** Bytes of base64 text that zlib has packed. */
async function unpacked(text) {
  const packed = await fetch("data:application/octet-stream;base64," + text);
  return new Response(packed.body.pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();
}

const digits = (value, count = 3) => String(Number(value.toPrecision(count)));

// --- vectors and matrices: arrays; matrices by columns, as GLSL has them

const add = (a, b) => a.map((x, i) => x + b[i]);
const scaled = (a, s) => a.map(x => x * s);
const minus = (a, b) => a.map((x, i) => x - b[i]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = a => Math.sqrt(dot(a, a));
const normalized = a => scaled(a, 1 / length(a));

function product(a, b) {
  const made = new Float32Array(16);
  for (let column = 0; column < 4; ++column) {
    for (let row = 0; row < 4; ++row) {
      for (let k = 0; k < 4; ++k) made[4 * column + row] += a[4 * k + row] * b[4 * column + k];
    }
  }
  return made;
}
