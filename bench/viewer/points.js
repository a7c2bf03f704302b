// The page's pixels beside the program's answers for the same points: what the self-test and the pictures are made from.

const EXACT_BOUND = 1e-4; // relative RMS, of exact filtering

/**
 * The stored view, by pixels from the top left one: place (primitive of lit.glb, or -1; triangle; u; v), position, radiance towards the camera for an
 * irradiance of 1 (lit) and for 0 (dark), answers, and the FLIP maps of answers.
 */
class StoredView {
  constructor(about, floats) {
    Object.assign(this, about);
    const pixels = this.width * this.height, part = (start, count) => floats.subarray(start * pixels, (start + count) * pixels);
    this.place = part(0, 4);
    this.position = part(4, 3);
    this.lit = part(7, 3);
    this.dark = part(10, 3);
    this.answer = new Map(this.answers.map((name, i) => [name, part(13 + 3 * i, 3)]));
    this.flipOf = new Map(this.flip.map(({ of }, i) => [of, part(13 + 3 * this.answers.length + i, 1)]));
    this.points = [...Array(pixels).keys()].filter(p => this.place[4 * p] >= 0);
  }

  /** The shading normal of a pixel's point, as the scene's own normal maps bend it. */
  normalOf(pixel, renderer) {
    this.normals = this.normals || renderer.measurePoints(this, { choice: renderer.choices[0], exact: true }).normal;
    return [...this.normals.subarray(4 * pixel, 4 * pixel + 3)];
  }

  /** The points' values of an answer, channel by channel. */
  valuesOf(answer, stride = 3) { return this.points.flatMap(p => [0, 1, 2].map(c => answer[stride * p + c])); }
}

const sum = values => values.reduce((a, b) => a + b, 0);

/** {rms, largest}: relative RMS difference, and the largest over the mean. */
function difference(values, wanted) {
  const off = values.map((value, i) => Math.abs(value - wanted[i]));
  return { rms: Math.sqrt(sum(off.map(x => x * x)) / sum(wanted.map(x => x * x))), largest: off.reduce((a, b) => Math.max(a, b), 0) * wanted.length / sum(wanted) };
}

/** Relative RMS error as the study has it: each square over the true value's own and a hundredth of the squared mean. */
function relativeError(values, truth) {
  const epsilon = 0.01 * (sum(truth) / truth.length) ** 2;
  return Math.sqrt(sum(values.map((value, i) => (value - truth[i]) ** 2 / (truth[i] ** 2 + epsilon))) / truth.length);
}

/** Every map in both filters: what is drawn, beside what the program answers and beside the reference where there is one. */
function selfTest(renderer, view) {
  const rows = [], truth = view.answer.has("reference") ? view.valuesOf(view.answer.get("reference")) : null;
  for (const choice of renderer.choices.filter(one => one.basis === one.map.basis)) {
    const answer = view.valuesOf(view.answer.get(choice.map.method));
    for (const exact of [true, false]) {
      const drawn = view.valuesOf(renderer.measurePoints(view, { choice, exact }).irradiance, 4);
      const row = { method: choice.map.method, basis: choice.basis, filter: exact ? "exact" : "hardware", points: view.points.length, ...difference(drawn, answer), ...costOf(choice, exact) };
      if (truth) Object.assign(row, { error: relativeError(drawn, truth), error_of_program: relativeError(answer, truth) });
      rows.push({ ...row, passed: !exact || row.rms <= EXACT_BOUND });
    }
  }
  return { renderer: rendererName(renderer.gl), scene: renderer.glb.lightmap.scene, passed: rows.every(row => row.passed), rows };
}

function rendererName(gl) {
  const names = gl.getExtension("WEBGL_debug_renderer_info");
  return names ? gl.getParameter(names.UNMASKED_RENDERER_WEBGL) : gl.getParameter(gl.RENDERER);
}
