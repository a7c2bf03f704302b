// Moving about: orbit around what is in the middle, or walk. Angles are radians.

class Camera {
  /** `stored`: as glb.camera. `size`: of the scene. */
  constructor(stored, size) {
    this.stored = stored;
    this.size = size;
    this.worldUp = [0, 1, 0];
    this.reset();
  }

  reset() {
    this.eye = [...this.stored.eye];
    this.fov = this.stored.fov;
    this.look(this.stored.forward);
    this.reach = 0.4 * this.size; // of the point that orbits go around
  }

  look(forward) {
    const f = normalized(forward);
    this.pitch = Math.asin(Math.max(-1, Math.min(1, f[1])));
    this.yaw = Math.atan2(f[0], -f[2]);
  }

  get forward() { return [Math.cos(this.pitch) * Math.sin(this.yaw), Math.sin(this.pitch), -Math.cos(this.pitch) * Math.cos(this.yaw)]; }
  get up() { return cross(normalized(cross(this.forward, this.worldUp)), this.forward); }
  get isStored() { return length(minus(this.eye, this.stored.eye)) < 1e-6 * this.size && dot(this.forward, normalized(this.stored.forward)) > 1 - 1e-9; }

  turn(yaw, pitch) {
    this.yaw += yaw;
    this.pitch = Math.max(-1.55, Math.min(1.55, this.pitch + pitch));
  }

  orbit(yaw, pitch) {
    const center = add(this.eye, scaled(this.forward, this.reach));
    this.turn(yaw, pitch);
    this.eye = minus(center, scaled(this.forward, this.reach));
  }

  /** Shares of the scene's size. */
  move(ahead, right, up = 0) {
    const across = normalized(cross(this.forward, this.worldUp));
    this.eye = add(this.eye, add(scaled(this.forward, ahead * this.size), add(scaled(across, right * this.size), scaled(this.worldUp, up * this.size))));
  }

  approach(share) {
    this.eye = add(this.eye, scaled(this.forward, share * this.reach));
    this.reach = Math.max(1e-3 * this.size, this.reach * (1 - share));
  }

  get text() { return this.isStored ? "" : [...this.eye, this.yaw, this.pitch].map(x => digits(x, 5)).join(","); }
  set text(words) {
    const numbers = words.split(",").map(Number);
    if (numbers.length !== 5 || !numbers.every(Number.isFinite)) return;
    this.eye = numbers.slice(0, 3);
    [this.yaw, this.pitch] = numbers.slice(3);
  }
}
