// The scene on the graphics card, and how it is drawn.

const UNITS = { uLight: 0, uFaces: 1, uHits: 2, uBaseTexture: 3, uNormalMap: 4, uEmissiveTexture: 5 };
const WRAPS = { 10497: 0, 33071: 1, 33648: 2 };

/** From the camera {eye, forward, up, fov} to clip space; distances in units of the scene's size. */
function viewProjection({ eye, forward, up, fov }, aspect, size) {
  const right = normalized(cross(forward, up)), top = cross(right, forward), near = 1e-4 * size, far = 20 * size, f = 1 / Math.tan(fov / 2);
  const view = [right[0], top[0], -forward[0], 0, right[1], top[1], -forward[1], 0, right[2], top[2], -forward[2], 0, -dot(right, eye), -dot(top, eye), dot(forward, eye), 1];
  return product([f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0], view);
}

class Renderer {
  /** `faults`: names of planted mistakes, for the tests. */
  constructor(canvas, constants, faults) {
    const gl = canvas.getContext("webgl2", { antialias: false, alpha: false, preserveDrawingBuffer: true });
    if (!gl) throw new Error("this browser has no WebGL 2");
    this.gl = gl;
    this.faults = faults;
    this.floats = gl.getExtension("EXT_color_buffer_float");
    gl.getExtension("OES_texture_float_linear");
    this.shading = new Shading(gl, constants, faults);
    this.blank = this.texture(gl.TEXTURE_2D, () => gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array([255, 255, 255, 255])));
  }

  texture(target, upload, filter = this.gl.NEAREST, wraps = [this.gl.CLAMP_TO_EDGE, this.gl.CLAMP_TO_EDGE]) {
    const { gl } = this, texture = gl.createTexture();
    gl.bindTexture(target, texture);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    upload();
    gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, filter);
    gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, filter);
    gl.texParameteri(target, gl.TEXTURE_WRAP_S, wraps[0]);
    gl.texParameteri(target, gl.TEXTURE_WRAP_T, wraps[1]);
    return texture;
  }

  /** Puts all of a file on the card, in place of what was there. */
  async load(glb) {
    const { gl } = this, { atlas, maps } = glb.lightmap;
    this.glb = glb;
    this.atlas = atlas;
    this.choices = choicesOf(maps);
    this.light = maps.map(map => {
      const halves = glb.view(map.bufferView, Uint16Array);
      return this.texture(gl.TEXTURE_2D_ARRAY, () =>
        gl.texImage3D(gl.TEXTURE_2D_ARRAY, 0, gl.RGBA16F, atlas.width, atlas.height, map.layers, 0, gl.RGBA, gl.HALF_FLOAT, halves), gl.LINEAR);
    });
    const floats = (view, internal, format) => this.texture(gl.TEXTURE_2D, () =>
      gl.texImage2D(gl.TEXTURE_2D, 0, internal, atlas.width, atlas.height, 0, format, gl.FLOAT, glb.view(view, Float32Array)));
    this.faces = floats(glb.lightmap.faces, gl.RGBA32F, gl.RGBA);
    this.hits = floats(glb.lightmap.hits_of_texels, gl.R32F, gl.RED);
    this.facesOfTexels = glb.view(glb.lightmap.faces, Float32Array);
    this.hitsOfTexels = glb.view(glb.lightmap.hits_of_texels, Float32Array);
    this.mostHits = this.hitsOfTexels.reduce((a, b) => Math.max(a, b), 0);
    this.materials = await Promise.all(glb.json.materials.map(material => this.material(material)));
    const primitives = glb.json.nodes.filter(node => node.mesh !== undefined).flatMap(node => glb.json.meshes[node.mesh].primitives);
    this.primitives = primitives.map(primitive => this.primitive(primitive));
    this.sources = primitives; // of the file
    this.pointsOf = new WeakMap();
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (const primitive of primitives) {
      const { min, max } = glb.json.accessors[primitive.attributes.POSITION];
      for (let i = 0; i < 3; ++i) [low[i], high[i]] = [Math.min(low[i], min[i]), Math.max(high[i], max[i])];
    }
    this.low = low;
    this.high = high;
    this.size = length(minus(high, low));
  }

  async material(material) {
    const { gl, glb } = this, pbr = material.pbrMetallicRoughness || {}, extensions = material.extensions || {};
    const texture = async (use, internal) => {
      if (!use) return null;
      const picture = await glb.picture(use.index), sampler = glb.sampler(use.index);
      return { texture: this.pictureTexture(picture, internal, sampler), wraps: [WRAPS[sampler.wrapS], WRAPS[sampler.wrapT]], nearest: sampler.magFilter === gl.NEAREST };
    };
    const strength = (extensions.KHR_materials_emissive_strength || { emissiveStrength: 1 }).emissiveStrength;
    return {
      name: material.name || "",
      color: pbr.baseColorFactor || [1, 1, 1, 1],
      base: await texture(pbr.baseColorTexture, gl.SRGB8_ALPHA8),
      normal: await texture(material.normalTexture, gl.RGBA8),
      scale: (material.normalTexture || {}).scale ?? 1,
      emissive: await texture(material.emissiveTexture, gl.SRGB8_ALPHA8),
      emitted: scaled(material.emissiveFactor || [0, 0, 0], strength),
      stored: Boolean(extensions.MOZ_lightmap),
      cutoff: material.alphaMode === "MASK" ? material.alphaCutoff ?? 0.5 : material.alphaMode === "BLEND" ? 0.5 : 0,
      doubleSided: Boolean(material.doubleSided),
      sets: { base: set(pbr.baseColorTexture), normal: set(material.normalTexture), emissive: set(material.emissiveTexture) },
    };
    function set(use) { return use ? `TEXCOORD_${use.texCoord || 0}` : null; }
  }

  pictureTexture(picture, internal, sampler) {
    const { gl } = this;
    return this.texture(gl.TEXTURE_2D, () => gl.texImage2D(gl.TEXTURE_2D, 0, internal, picture.width, picture.height, 0, gl.RGBA, gl.UNSIGNED_BYTE, picture),
      sampler.magFilter, [sampler.wrapS, sampler.wrapT]);
  }

  primitive(primitive) {
    const { gl, glb } = this, { attributes } = primitive, material = this.materials[primitive.material];
    const light = this.faults.has("texcoord") ? "TEXCOORD_0" : "TEXCOORD_1";
    const names = ["POSITION", "NORMAL", "TANGENT", material.sets.base, material.sets.normal, material.sets.emissive, light, "_LIGHTMAP_RECT", "COLOR_0"];
    const columns = names.map(name => {
      if (name === null || attributes[name] === undefined) return null;
      const column = glb.accessor(attributes[name]);
      if (name === "TANGENT" && this.faults.has("tangent")) for (let i = 3; i < column.values.length; i += 4) column.values[i] *= -1;
      return column;
    });
    const { values } = glb.accessor(primitive.indices), array = this.vertexArray(columns);
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, values, gl.STATIC_DRAW);
    gl.bindVertexArray(null);
    return { array, count: values.length, material, columns, indices: values };
  }

  /** Of columns {values, components} in the order of ATTRIBUTES; ones where a column is null. */
  vertexArray(columns) {
    const { gl } = this, array = gl.createVertexArray();
    gl.bindVertexArray(array);
    columns.forEach((column, place) => {
      if (!column) return;
      gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ARRAY_BUFFER, column.values, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, column.components, gl.FLOAT, false, 0, 0);
    });
    gl.bindVertexArray(null);
    return array;
  }

  /**
   * The stored view's points as triangles of one pixel each, by primitive. A triangle is a part of the surface around its point, so that the pixel's centre has
   * the point's own values and derivatives tell its plane. A rasterizer moves corners by parts of a pixel; these lie where it has no need to.
   */
  pointPrimitives(view) {
    if (this.pointsOf.has(view)) return this.pointsOf.get(view);
    const AROUND = [[-0.05, -0.05, -0.5, -0.25], [0.1, -0.05, 0.5, -0.25], [-0.05, 0.1, 0, 0.5]]; // u, v, pixels right, pixels up
    const pixelsOf = new Map();
    for (let p = 0; p < view.width * view.height; ++p) {
      const primitive = view.place[4 * p];
      if (primitive < 0) continue;
      if (!pixelsOf.has(primitive)) pixelsOf.set(primitive, []);
      pixelsOf.get(primitive).push(p);
    }
    const made = [...pixelsOf].map(([number, pixels]) => {
      const { material, columns, indices } = this.primitives[number];
      const parts = columns.map(column => column && { components: column.components, values: new Float32Array(3 * pixels.length * column.components) });
      const screen = new Float32Array(6 * pixels.length);
      pixels.forEach((p, i) => AROUND.forEach(([du, dv, right, up], k) => {
        const [, triangle, u, v] = view.place.subarray(4 * p, 4 * p + 4), at = 3 * i + k, shares = [1 - u - v - du - dv, u + du, v + dv];
        columns.forEach((column, c) => {
          if (!column) return;
          const n = column.components;
          for (let x = 0; x < n; ++x) parts[c].values[at * n + x] = shares.reduce((sum, share, corner) => sum + share * column.values[indices[3 * triangle + corner] * n + x], 0);
        });
        screen.set([2 * (p % view.width + 0.5 + right) / view.width - 1, 1 - 2 * (Math.floor(p / view.width) + 0.5 - up) / view.height], 2 * at);
      }));
      return { array: this.vertexArray([...parts, { components: 2, values: screen }]), count: 3 * pixels.length, material };
    });
    this.pointsOf.set(view, made);
    return made;
  }

  bind(unit, target, texture) {
    const { gl } = this;
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(target, texture);
  }

  /** Sets what all primitives share, of the program in use. */
  setLook(uniforms, look) {
    const { gl } = this, { width, height } = this.atlas, off = this.faults.has("atlas") ? 1 : 0;
    for (const [name, unit] of Object.entries(UNITS)) if (uniforms[name] !== undefined) gl.uniform1i(uniforms[name], unit);
    gl.uniform2f(uniforms.uAtlasSize, width + off, height);
    gl.uniform1f(uniforms.uUnit, look.choice.map.unit);
    gl.uniform2f(uniforms.uTilt, look.tilt || 0, look.turn || 0);
    gl.uniform1f(uniforms.uExposure, look.exposure || 1);
    gl.uniform1i(uniforms.uShow, look.show || 0);
    gl.uniform1f(uniforms.uMostHits, this.mostHits);
    for (let place = 0; place < ATTRIBUTES.length; ++place) gl.vertexAttrib4f(place, 1, 1, 1, 1); // of primitives without that column
    this.bindMap(look.choice);
  }

  /**
   * Draws into the bound target. `look`: {choice, exact, show, exposure, strength, tilt, turn}; `camera` as glb.camera.
   * `area`: [left, bottom, width, height] in pixels of the target, of which `part` is drawn (the same form).
   */
  draw(camera, look, area, part = area, measure = false) {
    const { gl } = this, { program, uniforms } = this.shading.get(look.choice, look.exact, measure ? "MEASURE" : "");
    gl.viewport(...area);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(...part);
    gl.enable(gl.DEPTH_TEST);
    gl.depthMask(true);
    gl.clearColor(...(measure ? [0, 0, 0, 0] : [0.05, 0.06, 0.08, 1]));
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.useProgram(program);
    gl.uniformMatrix4fv(uniforms.uViewProjection, false, viewProjection(camera, area[2] / area[3], this.size));
    this.setLook(uniforms, look);
    for (const primitive of this.primitives) this.drawPrimitive(primitive, uniforms, look);
    gl.bindVertexArray(null);
    gl.disable(gl.SCISSOR_TEST);
  }

  /** Draws the stored view's points, each into its pixel. */
  drawPoints(view, look) {
    const { gl } = this, { program, uniforms } = this.shading.get(look.choice, look.exact, "POINTS");
    gl.viewport(0, 0, view.width, view.height);
    gl.disable(gl.DEPTH_TEST);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.useProgram(program);
    this.setLook(uniforms, look);
    for (const primitive of this.pointPrimitives(view)) this.drawPrimitive(primitive, uniforms, look);
    gl.bindVertexArray(null);
  }

  bindMap(choice) {
    const { gl } = this;
    this.bind(UNITS.uLight, gl.TEXTURE_2D_ARRAY, this.light[choice.index]);
    this.bind(UNITS.uFaces, gl.TEXTURE_2D, this.faces);
    this.bind(UNITS.uHits, gl.TEXTURE_2D, this.hits);
  }

  /** Draws what one texel says of all normals above its surface, as a disc into the bound target. */
  drawHemisphere(choice, texel, across, exposure, left, diameter) {
    const { gl } = this, { program, uniforms } = this.shading.get(choice, true, "HEMISPHERE");
    gl.viewport(left, 0, diameter, diameter);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.CULL_FACE);
    gl.useProgram(program);
    for (const [name, unit] of Object.entries(UNITS)) if (uniforms[name] !== undefined) gl.uniform1i(uniforms[name], unit);
    gl.uniform2i(uniforms.uTexel, ...texel);
    gl.uniform3fv(uniforms.uAcross, across);
    gl.uniform1f(uniforms.uDiameter, diameter);
    gl.uniform1f(uniforms.uUnit, choice.map.unit);
    gl.uniform1f(uniforms.uExposure, exposure);
    this.bindMap(choice);
    gl.bindVertexArray(null);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  drawPrimitive({ array, count, material, indices }, uniforms, look) {
    const { gl } = this, normal = look.ownMap || material.normal;
    if (material.doubleSided) gl.disable(gl.CULL_FACE);
    else gl.enable(gl.CULL_FACE);
    gl.uniform4fv(uniforms.uBaseColor, material.color);
    gl.uniform1i(uniforms.uHasBaseTexture, Number(Boolean(material.base)));
    gl.uniform1i(uniforms.uHasNormalMap, Number(Boolean(material.normal && normal)));
    gl.uniform1i(uniforms.uHasEmissiveTexture, Number(Boolean(material.emissive)));
    gl.uniform1i(uniforms.uIsStored, Number(material.stored));
    gl.uniform3fv(uniforms.uEmitted, material.emitted);
    gl.uniform1f(uniforms.uAlphaCutoff, material.cutoff);
    gl.uniform1f(uniforms.uNormalMapScale, material.scale * (look.strength ?? 1));
    gl.uniform2i(uniforms.uNormalMapWrap, ...(normal ? normal.wraps : [0, 0]));
    gl.uniform1i(uniforms.uNormalMapNearest, Number(Boolean(normal && normal.nearest)));
    this.bind(UNITS.uBaseTexture, gl.TEXTURE_2D, (material.base || { texture: this.blank }).texture);
    this.bind(UNITS.uNormalMap, gl.TEXTURE_2D, (normal || { texture: this.blank }).texture);
    this.bind(UNITS.uEmissiveTexture, gl.TEXTURE_2D, (material.emissive || { texture: this.blank }).texture);
    gl.bindVertexArray(array);
    if (indices) gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 0);
    else gl.drawArrays(gl.TRIANGLES, 0, count);
  }

  /**
   * What the fragments of a picture of width x height are, {irradiance, position, place, normal}: four floats a pixel from the top left one, all 0
   * where nothing is. `only`: [x, y, across, down] from the top left pixel of that picture, where not all of it is wanted.
   */
  measure(camera, look, width, height, only = [0, 0, width, height]) {
    const [left, top, across, down] = only;
    return this.read(across, down, () => this.draw(camera, look, [-left, top + down - height, width, height], [0, 0, across, down], true));
  }

  /** The same of the stored view's points. */
  measurePoints(view, look) { return this.read(view.width, view.height, () => this.drawPoints(view, look)); }

  /** What `draw` draws into four targets of floats, in measure's form. */
  read(across, down, draw) {
    const { gl } = this;
    if (!this.floats) throw new Error("this browser draws no floats (EXT_color_buffer_float)");
    const target = gl.createFramebuffer(), buffers = [];
    gl.bindFramebuffer(gl.FRAMEBUFFER, target);
    const places = [gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1, gl.COLOR_ATTACHMENT2, gl.COLOR_ATTACHMENT3];
    for (const [place, format] of [...places.map(color => [color, gl.RGBA32F]), [gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24]]) {
      const buffer = gl.createRenderbuffer();
      buffers.push(buffer);
      gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
      gl.renderbufferStorage(gl.RENDERBUFFER, format, across, down);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, buffer);
    }
    gl.drawBuffers(places);
    draw();
    const read = place => {
      const bottomFirst = new Float32Array(4 * across * down), topFirst = new Float32Array(bottomFirst.length);
      gl.readBuffer(place);
      gl.readPixels(0, 0, across, down, gl.RGBA, gl.FLOAT, bottomFirst);
      for (let y = 0; y < down; ++y) topFirst.set(bottomFirst.subarray(4 * across * y, 4 * across * (y + 1)), 4 * across * (down - 1 - y));
      return topFirst;
    };
    const [irradiance, position, place, normal] = places.map(read);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.deleteFramebuffer(target);
    buffers.forEach(buffer => gl.deleteRenderbuffer(buffer));
    return { irradiance, position, place, normal };
  }
}
