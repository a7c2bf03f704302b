// What a fragment's light costs on the reader's own graphics card. Never part of the results: see renderer.

const ROUNDS = 9, BATCH = 8, TIMED_WIDTH = 960, TIMED_HEIGHT = 540;

const median = values => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

/** Seconds of one batch: by the card's own clock where there is one, else by the wall. NaN where the card was disturbed. */
async function batchSeconds(renderer, query, draw) {
  const { gl } = renderer, pixel = new Uint8Array(4);
  const finish = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  if (!query) {
    const start = performance.now();
    for (let i = 0; i < BATCH; ++i) draw();
    finish();
    return (performance.now() - start) / 1e3;
  }
  const timer = gl.createQuery();
  gl.beginQuery(query.TIME_ELAPSED_EXT, timer);
  for (let i = 0; i < BATCH; ++i) draw();
  gl.endQuery(query.TIME_ELAPSED_EXT);
  finish();
  while (!gl.getQueryParameter(timer, gl.QUERY_RESULT_AVAILABLE)) await new Promise(done => setTimeout(done, 5));
  const seconds = gl.getQueryParameter(timer, gl.QUERY_RESULT) / 1e9, disturbed = gl.getParameter(query.GPU_DISJOINT_EXT);
  gl.deleteQuery(timer);
  return disturbed ? NaN : seconds;
}

/** All maps in both filters, interleaved. Nanoseconds a pixel of the stored view. */
async function timeAll(renderer, camera, rounds = ROUNDS, width = TIMED_WIDTH, height = TIMED_HEIGHT) {
  const { gl } = renderer, query = gl.getExtension("EXT_disjoint_timer_query_webgl2");
  const target = gl.createFramebuffer(), buffers = [];
  gl.bindFramebuffer(gl.FRAMEBUFFER, target);
  for (const [place, format] of [[gl.COLOR_ATTACHMENT0, gl.RGBA8], [gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24]]) {
    const buffer = gl.createRenderbuffer();
    buffers.push(buffer);
    gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
    gl.renderbufferStorage(gl.RENDERBUFFER, format, width, height);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, buffer);
  }
  const looks = renderer.choices.flatMap(choice => [true, false].map(exact => ({ choice, exact }))), times = looks.map(() => []);
  for (let round = 0; round <= rounds; ++round) {
    for (const [i, look] of looks.entries()) {
      gl.bindFramebuffer(gl.FRAMEBUFFER, target);
      const seconds = await batchSeconds(renderer, query, () => renderer.draw(camera, look, [0, 0, width, height]));
      if (round > 0 && Number.isFinite(seconds)) times[i].push(seconds); // the first round compiles
    }
  }
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.deleteFramebuffer(target);
  buffers.forEach(buffer => gl.deleteRenderbuffer(buffer));
  const name = rendererName(gl);
  return {
    renderer: name, software: /swiftshader|llvmpipe|software/i.test(name), clock: query ? "timer query" : "wall clock, read-back included",
    width, height, draws_a_batch: BATCH, rounds,
    rows: looks.map((look, i) => ({ choice: look.choice.label, filter: look.exact ? "exact" : "hardware", ...costOf(look.choice, look.exact),
      ns_a_pixel: times[i].length ? median(times[i]) / BATCH / (width * height) * 1e9 : null })),
  };
}
