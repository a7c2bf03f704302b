// The fragment programs: one for each basis, filter and purpose, compiled when it is first wanted.

const BASES = { L0: "HARMONICS", L2: "HARMONICS", L4: "HARMONICS", AD: "AMBIENT_AND_DIRECTION",
  F0: "HEMISPHERE_FIT", F1: "HEMISPHERE_FIT", F2: "HEMISPHERE_FIT", YF1: "LUMINANCE_FIT", YF2: "LUMINANCE_FIT" };
const HARMONICS_OF = { L0: 1, L2: 9, L4: 18, AD: 1, F0: 1, F1: 4, F2: 9, YF1: 4, YF2: 9 };

/** What can be shown of a scene's maps: each map, and lower orders of what keeps plain harmonics. */
function choicesOf(maps) {
  const choices = maps.map((map, index) => ({ map, index, basis: map.basis, name: map.method, label: `${map.basis} ${map.fields.weight ?? map.fields.basis}` }));
  const has = new Set(maps.filter(map => map.fields.weight === "radiance").map(map => map.basis));
  for (const choice of [...choices]) {
    if (BASES[choice.basis] !== "HARMONICS" || choice.map.fields.weight !== "radiance") continue;
    for (const basis of ["L2", "L0"]) {
      if (HARMONICS_OF[basis] >= HARMONICS_OF[choice.basis] || has.has(basis)) continue;
      has.add(basis);
      choices.push({ ...choice, basis, name: `${basis} of ${choice.name}`, label: `${basis} radiance` });
    }
  }
  return choices;
}

const numbersOf = choice => choice.basis === choice.map.basis ? choice.map.numbers.length : 3 * HARMONICS_OF[choice.basis];

/** What a fragment's light costs, from the program's text: what does not depend on the machine. */
function costOf(choice, exact) {
  const layers = Math.ceil(numbersOf(choice) / 4), texels = exact ? 4 : 1;
  return { layers, fetches: texels * (layers + (exact ? 1 : 0)), bytes: 4 * layers * 8 + (exact ? 4 * 16 : 0), texel_bytes: 2 * numbersOf(choice) };
}

class Shading {
  constructor(gl, constants, faults) {
    this.gl = gl;
    this.constants = faults.has("constant") ? constants.replace(/(C2 = )([\d.]+)/, (_, name, value) => name + (1.01 * value).toFixed(9)) : constants;
    this.faults = faults;
    this.programs = new Map();
  }

  /** `purpose`: "", MEASURE, POINTS or HEMISPHERE. */
  prelude(choice, exact, purpose) {
    let count = HARMONICS_OF[choice.basis];
    if (this.faults.has("order") && count > 1 && BASES[choice.basis] !== "LUMINANCE_FIT") count = { 4: 1, 9: 4, 18: 9 }[count];
    return [
      "#version 300 es", "precision highp float;", "precision highp int;", "precision highp sampler2DArray;",
      `#define ${BASES[choice.basis]}`, `#define COUNT ${count}`, `#define LAYERS ${Math.ceil(numbersOf(choice) / 4)}`,
      ...(exact ? ["#define EXACT"] : []), ...(purpose ? [`#define ${purpose}`] : []), ...(purpose === "POINTS" ? ["#define MEASURE"] : []), this.constants, "",
    ].join("\n");
  }

  /** {program, uniforms}: places of uniforms by name. Throws Error with the compiler's words. */
  get(choice, exact, purpose = "") {
    const key = [choice.basis, numbersOf(choice), exact, purpose].join();
    if (!this.programs.has(key)) this.programs.set(key, this.linked(this.prelude(choice, exact, purpose)));
    return this.programs.get(key);
  }

  linked(prelude) {
    const { gl } = this, program = gl.createProgram();
    for (const [type, id] of [[gl.VERTEX_SHADER, "vertex"], [gl.FRAGMENT_SHADER, "fragment"]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, prelude + byId(id).textContent);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(`${id} program: ${gl.getShaderInfoLog(shader)}`);
      gl.attachShader(program, shader);
    }
    ATTRIBUTES.forEach((name, place) => gl.bindAttribLocation(program, place, name));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    const uniforms = {};
    for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++i) {
      const { name } = gl.getActiveUniform(program, i);
      uniforms[name] = gl.getUniformLocation(program, name);
    }
    return { program, uniforms };
  }
}

const ATTRIBUTES = ["aPosition", "aNormal", "aTangent", "aBaseTexcoord", "aNormalTexcoord", "aEmissiveTexcoord", "aLightTexcoord", "aLightRectangle", "aColor", "aScreen"];
