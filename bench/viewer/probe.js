// A point under the mouse: its texel, hits and irradiance, and what each basis says of all normals above it.

const DISC = 76; // pixels

/** {texel, hits, area, normal, position, irradiance} of a pixel of the canvas; null where no texel is. */
function probed(renderer, camera, look, x, y, width, height) {
  const { irradiance, position, place, normal } = renderer.measure(camera, look, width, height, [x, y, 1, 1]);
  if (position[3] === 0 || normal[3] === 0) return null;
  const texel = [Math.floor(place[0]), Math.floor(place[1])], at = texel[1] * renderer.atlas.width + texel[0];
  const face = [...renderer.facesOfTexels.subarray(4 * at, 4 * at + 4)];
  return { texel, hits: renderer.hitsOfTexels[at], face: face.slice(0, 3), covered: face[3] > 0, normal: [...normal.slice(0, 3)],
    position: [...position.slice(0, 3)], irradiance: [...irradiance.slice(0, 3)] };
}

/** The stored view's pixel nearest to a place, if it is about as near as its own pixels are: {pixel, distance}. */
function nearestPixel(view, place, reach) {
  let best = null;
  for (const p of view.points) {
    const distance = length([0, 1, 2].map(c => view.position[3 * p + c] - place[c]));
    if (distance <= reach && (!best || distance < best.distance)) best = { pixel: p, distance };
  }
  return best;
}

/** Draws the discs of all choices side by side, in a target of its own; gives them as an image for a 2D canvas. */
function hemispheres(renderer, choices, found, exposure) {
  const { gl } = renderer, width = DISC * choices.length, target = gl.createFramebuffer(), buffer = gl.createRenderbuffer();
  const across = normalized(cross(found.face, Math.abs(found.face[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0]));
  gl.bindFramebuffer(gl.FRAMEBUFFER, target);
  gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
  gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA8, width, DISC);
  gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, buffer);
  gl.clearColor(0, 0, 0, 0);
  gl.clear(gl.COLOR_BUFFER_BIT);
  const pixels = new Uint8ClampedArray(4 * DISC * DISC), discs = [];
  choices.forEach(choice => {
    renderer.drawHemisphere(choice, found.texel, across, exposure, 0, DISC);
    gl.readPixels(0, 0, DISC, DISC, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    discs.push(new ImageData(new Uint8ClampedArray(pixels), DISC, DISC));
  });
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.deleteFramebuffer(target);
  gl.deleteRenderbuffer(buffer);
  const along = cross(found.face, across);
  return { discs, placeOf: normal => [dot(normal, across), dot(normal, along)].map(s => DISC * (s + 1) / 2) };
}

/** `truth`: {at, color} of the reference, where it is known. */
function discFigure(image, [x, y], truth, words) {
  const canvas = make("canvas", { width: DISC, height: DISC }), pen = canvas.getContext("2d");
  pen.putImageData(image, 0, 0); // rows from the bottom: v upwards, as drawn
  if (truth) {
    pen.beginPath();
    pen.arc(...truth.at, 6, 0, 2 * Math.PI);
    pen.fillStyle = `rgb(${truth.color.map(Math.round).join(",")})`;
    pen.fill();
    pen.strokeStyle = "#ffffff";
    pen.lineWidth = 1;
    pen.stroke();
  }
  pen.strokeStyle = "#ffffff";
  pen.lineWidth = 3;
  pen.strokeRect(x - 3, y - 3, 6, 6);
  pen.strokeStyle = "#000000";
  pen.lineWidth = 1;
  pen.strokeRect(x - 3, y - 3, 6, 6);
  return make("figure", {}, canvas, make("figcaption", {}, words));
}

const rgbText = rgb => rgb.map(x => digits(x)).join(", ");

function showProbe(viewer, x, y, width, height) {
  const { renderer, view } = viewer, look = viewer.lookOf("a"), found = probed(renderer, viewer.cameraNow(), look, x, y, width, height);
  const box = byId("probe");
  if (!found) {
    box.replaceChildren(make("p", {}, "No texels here: sky, mirror or glass."));
    return;
  }
  const tilt = Math.acos(Math.min(1, dot(found.normal, found.face))) * 180 / Math.PI;
  const lines = [`Texel ${found.texel.join(", ")} of the atlas, ${found.hits} hits. Its normal is bent by ${digits(tilt, 2)}° here.`,
    `${look.choice.label}, ${look.exact ? "exact" : "hardware"} filter: ${rgbText(found.irradiance)} W/m².`];
  const near = view && nearestPixel(view, found.position, 0.01 * renderer.size), truth = view && view.answer.get("reference");
  let known = null;
  if (near && truth) {
    const wanted = [0, 1, 2].map(c => truth[3 * near.pixel + c]);
    known = { normal: view.normalOf(near.pixel, renderer), color: wanted.map(x => displayed(x / Math.PI * viewer.exposure)) };
    const error = length(minus(found.irradiance, wanted)) / Math.max(length(wanted), 1e-9);
    lines.push(`Reference at the nearest of its points, ${digits(near.distance, 2)} m away: ${rgbText(wanted)} W/m², ${digits(100 * error, 2)} % off.`);
  }
  const { discs, placeOf } = hemispheres(renderer, renderer.choices, found, viewer.exposure);
  const mark = known && dot(known.normal, found.face) > 0 ? { at: placeOf(known.normal), color: known.color } : null;
  const figures = renderer.choices.map((choice, i) => discFigure(discs[i], placeOf(found.normal), mark, choice.label));
  const ofReference = mark ? " The round mark has the reference's colour, at the normal that it was made for." : "";
  box.replaceChildren(...lines.map(line => make("p", {}, line)), make("div", { class: "discs" }, ...figures),
    make("p", { class: "small" }, "Discs: irradiance for every normal above the surface, its own in the middle, the fragment's marked by a square." + ofReference + " Red: below zero, cut off."));
}
