// The page's pixels beside the program's answers for the same points: what the self-test and the pictures are made from.

const SAME_PLACE = 1e-4; // of the scene's size
const EXACT_BOUND = 1e-4; // relative RMS, of exact filtering

/** The stored view: positions and answers, three floats a pixel from the top left one. */
class StoredView {
  constructor(about, floats) {
    Object.assign(this, about);
    const values = 3 * this.width * this.height;
    this.position = floats.subarray(0, values);
    this.answer = new Map(this.answers.map((name, i) => [name, floats.subarray(values * (i + 1), values * (i + 2))]));
  }
}

/** {compared, pixels, rms, largest}: relative RMS difference, and the largest over the mean. Pixels that see other places (edges, mirrors) are left out. */
function difference(view, measured, answer, size, got = (p, c) => measured.irradiance[4 * p + c]) {
  let compared = 0, pixels = 0, squares = 0, differences = 0, largest = 0, sum = 0;
  for (let p = 0; p < view.width * view.height; ++p) {
    const there = [0, 1, 2].map(c => view.position[3 * p + c]);
    if (!Number.isFinite(there[0])) continue;
    ++pixels;
    const seen = [0, 1, 2].map(c => measured.position[4 * p + c]);
    if (measured.position[4 * p + 3] === 0 || length(minus(seen, there)) > SAME_PLACE * size) continue;
    ++compared;
    for (let c = 0; c < 3; ++c) {
      const wanted = answer[3 * p + c], off = Math.abs(got(p, c) - wanted);
      squares += wanted * wanted;
      sum += wanted;
      differences += off * off;
      largest = Math.max(largest, off);
    }
  }
  return { compared, pixels, rms: Math.sqrt(differences / squares), largest: largest * 3 * compared / sum };
}

/** Relative RMS error as the study has it: each point's square over its own and a hundredth of the mean square. */
function relativeError(view, measured, truth, size, got) {
  const points = [];
  for (let p = 0; p < view.width * view.height; ++p) {
    const there = [0, 1, 2].map(c => view.position[3 * p + c]), seen = [0, 1, 2].map(c => measured.position[4 * p + c]);
    if (Number.isFinite(there[0]) && measured.position[4 * p + 3] !== 0 && length(minus(seen, there)) <= SAME_PLACE * size) points.push(p);
  }
  const all = points.flatMap(p => [0, 1, 2].map(c => truth[3 * p + c]));
  const mean = all.reduce((a, b) => a + b, 0) / all.length, epsilon = 0.01 * mean * mean;
  const squares = points.flatMap(p => [0, 1, 2].map(c => (got(p, c) - truth[3 * p + c]) ** 2 / (truth[3 * p + c] ** 2 + epsilon)));
  return Math.sqrt(squares.reduce((a, b) => a + b, 0) / squares.length);
}

/** Every map in both filters: what is drawn, beside what the program answers and beside the reference where there is one. */
function selfTest(renderer, view) {
  const rows = [], truth = view.answer.get("reference");
  for (const choice of renderer.choices.filter(one => one.basis === one.map.basis)) {
    const answer = view.answer.get(choice.map.method);
    for (const exact of [true, false]) {
      const measured = renderer.measure(renderer.glb.camera, { choice, exact }, view.width, view.height);
      const drawn = (p, c) => measured.irradiance[4 * p + c], programs = (p, c) => answer[3 * p + c];
      const row = { method: choice.map.method, basis: choice.basis, filter: exact ? "exact" : "hardware", ...difference(view, measured, answer, renderer.size), ...costOf(choice, exact) };
      if (truth) {
        row.error = relativeError(view, measured, truth, renderer.size, drawn);
        row.error_of_program = relativeError(view, measured, truth, renderer.size, programs);
      }
      rows.push({ ...row, passed: !exact || (row.rms <= EXACT_BOUND && row.compared > 0.9 * row.pixels) });
    }
  }
  return { renderer: rendererName(renderer.gl), scene: renderer.glb.lightmap.scene, passed: rows.every(row => row.passed), rows };
}

function rendererName(gl) {
  const names = gl.getExtension("WEBGL_debug_renderer_info");
  return names ? gl.getParameter(names.UNMASKED_RENDERER_WEBGL) : gl.getParameter(gl.RENDERER);
}
