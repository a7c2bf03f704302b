// The panel: what people set, and how they move.

const SHOWN = ["lit", "irradiance, white surfaces", "texels and chart borders", "hits per texel", "where light below zero is cut off", "what the filters differ by (white: 20 %)", "normals"];

function options(select, entries, chosen) {
  select.replaceChildren(...entries.map(([value, text]) => make("option", { value, selected: value === chosen }, text)));
}

/** The choices of one side: maps; the program's pictures of the stored camera, and what a viewer sees of their error. */
function fillSelects(viewer) {
  const maps = viewer.renderer.choices.map((choice, i) => [String(i), choice.label]);
  const pictures = viewer.view ? [
    ...viewer.view.answers.map(name => ["=" + name, `picture: ${name}`]),
    ...viewer.view.flip.map(({ of, mean }) => ["!" + of, `FLIP ${digits(mean, 2)}: ${of}`]),
  ] : [];
  for (const side of ["a", "b"]) {
    options(byId(side), [...maps, ...pictures], state[side]);
    options(byId("f" + side), [["exact", "exact filter"], ["hardware", "hardware filter"]], state["f" + side]);
    options(byId("s" + side), SHOWN.map((text, i) => [String(i), text]), state["s" + side]);
  }
  for (const name of ["exposure", "strength", "tilt", "turn"]) byId(name).value = state[name];
  byId("split").checked = state.split !== "0";
}

function listenToPanel(viewer) {
  for (const name of ["a", "b", "fa", "fb", "sa", "sb"]) byId(name).addEventListener("change", event => { remember({ [name]: event.target.value }); viewer.draw(); });
  for (const name of ["exposure", "strength", "tilt", "turn"]) byId(name).addEventListener("input", event => { remember({ [name]: event.target.value }); viewer.draw(); });
  byId("split").addEventListener("change", event => { remember({ split: event.target.checked ? "0.5" : "0" }); viewer.draw(); });
  byId("stored").addEventListener("click", () => { viewer.camera.reset(); viewer.moved(); });
  byId("test").addEventListener("click", () => showTest(viewer));
  byId("time").addEventListener("click", () => showTimes(viewer));
}

function tableOf(heads, rows) {
  const line = (cells, name) => make("tr", {}, ...cells.map(cell => make(name, {}, cell)));
  return make("table", {}, make("thead", {}, line(heads, "th")), make("tbody", {}, ...rows.map(row => line(row, "td"))));
}

function showTest(viewer) {
  const result = selfTest(viewer.renderer, viewer.view), percent = x => x === undefined ? "-" : `${digits(100 * x)} %`;
  const rows = result.rows.map(row => [row.basis, row.filter, digits(row.rms, 2), digits(row.largest, 2), percent(row.error), percent(row.error_of_program)]);
  byId("report").replaceChildren(
    make("p", {}, `${result.passed ? "Passed" : "FAILED"}: this page's pixels beside the program's answers, at the stored camera (${result.rows[0].points} points). Drawn by ${result.renderer}.`),
    tableOf(["basis", "filter", "relative RMS difference", "largest, of the mean", "error against the reference", "the program's own"], rows));
}

async function showTimes(viewer) {
  byId("report").replaceChildren(make("p", {}, "Measuring ..."));
  await new Promise(done => setTimeout(done, 30));
  const result = await timeAll(viewer.renderer, viewer.renderer.glb.camera), copy = make("button", { type: "button" }, "copy as JSON");
  copy.addEventListener("click", () => navigator.clipboard.writeText(JSON.stringify(result, null, 1)));
  const rows = result.rows.map(row => [row.choice, row.filter, row.fetches, row.bytes, row.texel_bytes, row.ns_a_pixel === null ? "-" : digits(row.ns_a_pixel)]);
  byId("report").replaceChildren(
    make("p", {}, `${result.renderer}, ${result.clock}, medians of ${result.rounds}. ${result.software ? "This is a program that stands in for a graphics card: its times say nothing of one. " : ""}`, copy),
    tableOf(["light", "filter", "fetches", "bytes fetched", "bytes a texel", "ns a pixel"], rows));
  viewer.draw();
}

// --- moving

const KEYS = { w: [1, 0, 0], s: [-1, 0, 0], a: [0, -1, 0], d: [0, 1, 0], q: [0, 0, -1], e: [0, 0, 1], ArrowUp: [1, 0, 0], ArrowDown: [-1, 0, 0], ArrowLeft: [0, -1, 0], ArrowRight: [0, 1, 0] };

function listenToCanvas(viewer) {
  const canvas = byId("scene");
  let held = null;
  canvas.addEventListener("pointerdown", event => {
    const line = viewer.split * canvas.clientWidth;
    held = { x: event.offsetX, y: event.offsetY, far: 0, line: viewer.split > 0 && Math.abs(event.offsetX - line) < 8, walk: event.shiftKey || event.button === 2 };
    canvas.setPointerCapture(event.pointerId);
    canvas.focus();
  });
  canvas.addEventListener("pointermove", event => {
    if (!held) return;
    const dx = event.offsetX - held.x, dy = event.offsetY - held.y;
    held = { ...held, x: event.offsetX, y: event.offsetY, far: held.far + Math.abs(dx) + Math.abs(dy) };
    if (held.line) {
      remember({ split: digits(Math.min(0.99, Math.max(0.01, event.offsetX / canvas.clientWidth)), 3) });
      viewer.draw();
    } else {
      viewer.camera[held.walk ? "turn" : "orbit"](0.005 * dx * (held.walk ? -1 : 1), 0.005 * dy * (held.walk ? 1 : -1));
      viewer.moved();
    }
  });
  canvas.addEventListener("pointerup", event => {
    if (held && held.far < 4 && !held.line) viewer.probe(event.offsetX, event.offsetY);
    held = null;
  });
  canvas.addEventListener("contextmenu", event => event.preventDefault());
  canvas.addEventListener("wheel", event => {
    event.preventDefault();
    viewer.camera.approach(event.deltaY < 0 ? 0.1 : -0.1);
    viewer.moved();
  }, { passive: false });
  canvas.addEventListener("keydown", event => {
    const way = KEYS[event.key];
    if (way) {
      viewer.camera.move(...scaled(way, event.shiftKey ? 0.05 : 0.015));
      viewer.moved();
      event.preventDefault();
    } else if (event.key === "f") viewer.flip(true);
    else if (event.key === "r") { viewer.camera.reset(); viewer.moved(); }
  });
  canvas.addEventListener("keyup", event => { if (event.key === "f") viewer.flip(false); });
}

// --- files that are dropped: lit.glb, or a picture that bends all normals

function listenToFiles(viewer) {
  const take = async file => {
    try {
      if (file.name.endsWith(".glb")) await viewer.open(await file.arrayBuffer());
      else await viewer.bendBy(file);
    } catch (error) {
      say(`${file.name}: ${error.message}`);
    }
  };
  byId("file").addEventListener("change", event => { if (event.target.files[0]) take(event.target.files[0]); });
  document.addEventListener("dragover", event => event.preventDefault());
  document.addEventListener("drop", event => {
    event.preventDefault();
    if (event.dataTransfer.files[0]) take(event.dataTransfer.files[0]);
  });
}

function say(words) {
  byId("said").textContent = words;
  byId("said").hidden = !words;
}
