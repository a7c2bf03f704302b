// One scene on one canvas.

class Viewer {
  constructor(about) {
    this.about = about;
    this.canvas = byId("scene");
    this.flipped = false;
    this.pictureWords = ""; // what is said of a picture that cannot be shown
    this.faults = new Set((new URLSearchParams(location.hash.slice(1)).get("fault") || "").split(",").filter(Boolean));
    this.renderer = new Renderer(this.canvas, about.glsl_constants, this.faults);
  }

  /** A lit.glb; `view` is of the page's own scene alone. */
  async open(bytes, view = null) {
    const glb = new Glb(bytes);
    await this.renderer.load(glb);
    this.view = view && glb.lightmap.fingerprint === this.about.fingerprint ? view : null;
    this.camera = new Camera(glb.camera, this.renderer.size);
    if (state.camera) this.camera.text = state.camera;
    this.ownMap = null;
    this.grey = 0; // not known yet
    byId("test").disabled = !this.view;
    byId("name").textContent = glb.lightmap.scene;
    fillSelects(this);
    this.draw();
  }

  /** Any picture as the normal map of all surfaces that have one. */
  async bendBy(file) {
    const { gl } = this.renderer, picture = await createImageBitmap(file, { colorSpaceConversion: "none", premultiplyAlpha: "none" });
    const sampler = { magFilter: gl.LINEAR, wrapS: gl.REPEAT, wrapT: gl.REPEAT };
    this.ownMap = { texture: this.renderer.pictureTexture(picture, gl.RGBA8, sampler), wraps: [0, 0], nearest: false };
    const bendable = this.renderer.materials.some(material => material.normal);
    say(bendable ? `Normals are bent by ${file.name}. Open the page again for the scene's own.` : "No surface of this scene has coordinates for a normal map.");
    this.draw();
  }

  get split() { return Number(state.split); }
  get exposure() { return 2 ** Number(state.exposure) * this.middleGrey; }

  /** So that the mean irradiance of what the stored camera sees is shown as a middle grey. */
  get middleGrey() {
    if (this.grey) return this.grey;
    const { irradiance, position } = this.renderer.measure(this.renderer.glb.camera, { choice: this.renderer.choices[0], exact: true }, 64, 36);
    let sum = 0, count = 0;
    for (let i = 0; i < position.length; i += 4) {
      const light = (irradiance[i] + irradiance[i + 1] + irradiance[i + 2]) / 3;
      if (position[i + 3] > 0 && light > 0) { sum += Math.log(light); ++count; }
    }
    return this.grey = count ? 0.6 * Math.PI / Math.exp(sum / count) : 1;
  }

  cameraNow() { return { eye: this.camera.eye, forward: this.camera.forward, up: this.camera.up, fov: this.camera.fov }; }

  lookOf(side) {
    const index = Number(state[side]);
    return { choice: this.renderer.choices[Number.isInteger(index) ? index : 0] || this.renderer.choices[0], exact: state["f" + side] !== "hardware", show: Number(state["s" + side]) || 0,
      exposure: this.exposure, strength: Number(state.strength), tilt: Number(state.tilt) * Math.PI / 180, turn: Number(state.turn) * Math.PI / 180, ownMap: this.ownMap };
  }

  moved() {
    remember({ camera: this.camera.text });
    this.draw();
  }

  flip(down) {
    if (this.flipped === down) return;
    this.flipped = down;
    this.draw();
  }

  probe(x, y) {
    this.fitCanvas();
    const ratio = this.canvas.width / this.canvas.clientWidth;
    showProbe(this, Math.floor(x * ratio), Math.floor(y * ratio), this.canvas.width, this.canvas.height);
    this.draw();
  }

  draw() {
    if (!this.camera || this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => { this.waiting = false; this.drawNow(); });
  }

  /** Gives the canvas the pixels of the place it has on the page, which no frame may have been drawn at yet. */
  fitCanvas() {
    const { canvas } = this, ratio = Math.min(2, window.devicePixelRatio || 1);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map(side => Math.max(1, Math.round(side * ratio)));
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
  }

  drawNow() {
    this.fitCanvas();
    const { canvas, renderer } = this, { width, height } = canvas;
    const line = Math.round(width * this.split), sides = this.flipped ? ["b", "a"] : ["a", "b"], area = [0, 0, width, height];
    const parts = this.split > 0 ? [[sides[0], [0, 0, line, height]], [sides[1], [line, 0, width - line, height]]] : [[sides[0], area]];
    for (const [side, part] of parts) if (part[2] > 0) renderer.draw(this.cameraNow(), this.lookOf(side), area, part);
    byId("line").hidden = this.split === 0;
    byId("line").style.left = `${100 * this.split}%`;
    this.showPicture(sides[0]);
  }

  /** A picture of the stored camera over the canvas: =NAME for an answer of the program's, !NAME for its FLIP map. */
  showPicture(side) {
    const over = byId("picture"), kind = state[side][0], name = state[side].slice(1), { view } = this;
    const values = view && (kind === "=" ? view.answer.get(name) : kind === "!" ? view.flipOf.get(name) : null);
    over.hidden = !values || this.split > 0 || !this.camera.isStored;
    const words = values && over.hidden ? `${name} is a picture of the stored camera alone: press R, and show A alone.` : "";
    if (words !== this.pictureWords) say(words);
    this.pictureWords = words;
    if (over.hidden) return;
    const { width, height } = view, image = new ImageData(width, height), bare = Number(state["s" + side]) === 1;
    for (let p = 0; p < width * height; ++p) {
      const color = kind === "!" ? flipColor(values[p]) : [0, 1, 2].map(c => {
        const at = 3 * p + c, radiance = bare ? values[at] / Math.PI : view.dark[at] + view.lit[at] * values[at];
        return displayed(radiance * this.exposure);
      });
      image.data.set([...color, 255], 4 * p);
    }
    [over.width, over.height] = [width, height];
    over.getContext("2d").putImageData(image, 0, 0);
  }
}

/** A byte, as lit.frag's displayed() has it. */
function displayed(value) {
  let x = Math.max(0, value);
  x = Math.min(1, x * (1 + x / 16) / (1 + x));
  return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);
}

/** From black by violet and orange to white. */
function flipColor(value) {
  const stops = [[0, 0, 4], [81, 18, 124], [183, 55, 121], [252, 137, 97], [252, 253, 191]], at = Math.min(Math.max(value, 0), 0.9999) * 4, i = Math.floor(at);
  return stops[i].map((from, c) => from + (at - i) * (stops[i + 1][c] - from));
}

async function start() {
  const about = JSON.parse(byId("about").textContent), data = JSON.parse(byId("data").textContent);
  const viewer = new Viewer(about);
  const view = new StoredView(about.view, new Float32Array(await unpacked(data.view)));
  listenToPanel(viewer);
  listenToCanvas(viewer);
  listenToFiles(viewer);
  window.addEventListener("resize", () => viewer.draw());
  if (data.glb) await viewer.open(await unpacked(data.glb), view);
  else {
    say("This scene is too large for the page: drop its lit.glb here.");
    const { open } = viewer;
    viewer.open = bytes => open.call(viewer, bytes, view);
  }
  return viewer;
}

window.shlmViewer = start();
window.shlmViewer.catch(error => say(error.message));
window.shlmTest = async () => { const viewer = await window.shlmViewer; return selfTest(viewer.renderer, viewer.view); };
window.shlmTimes = async (...how) => { const viewer = await window.shlmViewer; return timeAll(viewer.renderer, viewer.renderer.glb.camera, ...how); };
