// lit.glb, read: its JSON, its numbers and its pictures. Only what shlmbench export writes is understood.

const COMPONENTS = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
const EXTENSION = "SHLM_lightmap";

class Glb {
  /** Throws Error, one line, where the bytes are no lit.glb. */
  constructor(bytes) {
    const view = new DataView(bytes);
    if (bytes.byteLength < 28 || view.getUint32(0, true) !== 0x46546c67) throw new Error("this is no binary glTF file");
    const length = view.getUint32(12, true);
    this.json = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 20, length)));
    this.bytes = bytes;
    this.start = 20 + length + 8;
    if (!this.json.extensions || !this.json.extensions[EXTENSION]) throw new Error(`this file has no ${EXTENSION}: shlmbench export writes it`);
  }

  get lightmap() { return this.json.extensions[EXTENSION]; }

  /** Bytes of a buffer view, as numbers of the type. */
  view(index, Type) {
    const view = this.json.bufferViews[index];
    return new Type(this.bytes.slice(this.start + (view.byteOffset || 0), this.start + (view.byteOffset || 0) + view.byteLength));
  }

  /** {values, components}; floats, or indices. */
  accessor(index) {
    const accessor = this.json.accessors[index];
    return { values: this.view(accessor.bufferView, accessor.componentType === 5126 ? Float32Array : Uint32Array), components: COMPONENTS[accessor.type] };
  }

  /** The picture of a texture, as it is in the file. */
  async picture(texture) {
    const image = this.json.images[this.json.textures[texture].source];
    const blob = image.uri ? await (await fetch(image.uri)).blob() : new Blob([this.view(image.bufferView, Uint8Array)], { type: image.mimeType });
    return createImageBitmap(blob, { colorSpaceConversion: "none", premultiplyAlpha: "none" });
  }

  sampler(texture) { return this.json.samplers[this.json.textures[texture].sampler]; }

  /** {eye, forward, up, fov} of the stored camera. */
  get camera() {
    const node = this.json.nodes.find(candidate => candidate.camera !== undefined), m = node.matrix;
    return { eye: m.slice(12, 15), forward: scaled(m.slice(8, 11), -1), up: m.slice(4, 7), fov: this.json.cameras[node.camera].perspective.yfov };
  }
}
