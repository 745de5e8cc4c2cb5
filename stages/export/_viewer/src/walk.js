// Standing in the home: drag to look about, W A S D or the stick to walk, round what stands in the way.
import { Vector3 } from "three";

const EYES = 1.6; // m above the floor
const SPEED = 1.4; // m/s
const TURN = 1.6; // rad/s by keys
const KEYS = { KeyW: [1, 0, 0], KeyS: [-1, 0, 0], KeyA: [0, -1, 0], KeyD: [0, 1, 0], ArrowUp: [1, 0, 0],
  ArrowDown: [-1, 0, 0], ArrowLeft: [0, 0, 1], ArrowRight: [0, 0, -1], KeyQ: [0, 0, 1], KeyE: [0, 0, -1] };
const NEAR = 1.3; // m from which doors open by themselves

export class Walk {
  constructor(home, camera, stick) {
    Object.assign(this, { home, camera, stick, on: false, yaw: 0, pitch: -0.1, held: new Set(), push: [0, 0] });
    this.free = new Set(home.facts.free.runs.flatMap(([row, from, to]) =>
      Array.from({ length: to - from }, (_, k) => row * 4096 + from + k)));
    this.#thumb();
  }

  // Begins at a point of the floor, looking along a direction.
  begin(point, towards) {
    this.on = true;
    this.camera.position.set(point.x, EYES, point.z);
    if (towards) this.yaw = Math.atan2(-towards.x, -towards.z);
    this.pitch = -0.1;
    this.#aim();
  }

  end() {
    this.on = false;
    this.held.clear();
    this.push = [0, 0];
  }

  drag(dx, dy) {
    this.yaw += dx * 0.004;
    this.pitch = Math.max(-1.4, Math.min(1.4, this.pitch + dy * 0.004));
    this.#aim();
  }

  press(code, down) {
    if (!this.on || !(code in KEYS)) return false;
    if (down) this.held.add(code);
    else this.held.delete(code);
    return true;
  }

  // One step in time; true while walking.
  advance(seconds) {
    if (!this.on) return false;
    const [ahead, side, turn] = [...this.held].reduce((sum, code) => sum.map((v, k) => v + KEYS[code][k]),
      [this.push[1], this.push[0], 0]);
    if (!ahead && !side && !turn) return false;
    this.yaw += turn * TURN * seconds;
    const [s, c] = [Math.sin(this.yaw), Math.cos(this.yaw)];
    const far = SPEED * seconds * Math.min(1, 1 / Math.hypot(ahead, side || 1e-9));
    this.#step((-s * ahead + c * side) * far, (-c * ahead - s * side) * far);
    this.#aim();
    this.#doors();
    return true;
  }

  #step(dx, dz) {
    const { position } = this.camera;
    const stuck = !this.#clear(position.x, position.z);
    for (const [x, z] of [[dx, dz], [dx, 0], [0, dz]]) {
      if (!stuck && !this.#clear(position.x + x, position.z + z)) continue;
      position.x += x;
      position.z += z;
      return;
    }
  }

  #clear(x, z) {
    const { x: x0, y: y0, cell } = this.home.facts.free;
    return this.free.has(Math.floor((-z - y0) / cell) * 4096 + Math.floor((x - x0) / cell));
  }

  #doors() {
    for (const part of this.home.parts) {
      const body = part.node.parent;
      if (body.userData.category !== "door" || part.goal) continue;
      const at = new Vector3().setFromMatrixPosition(part.node.matrixWorld);
      if (Math.hypot(at.x - this.camera.position.x, at.z - this.camera.position.z) < NEAR) part.goal = 1;
    }
  }

  #aim() {
    this.camera.rotation.set(this.pitch, this.yaw, 0, "YXZ");
    this.camera.updateMatrixWorld();
  }

  // The stick under a thumb: as far as it is moved from its middle.
  #thumb() {
    const set = (event) => {
      const box = this.stick.getBoundingClientRect();
      const half = box.width / 2;
      const x = Math.max(-1, Math.min(1, (event.clientX - box.left - half) / half));
      const y = Math.max(-1, Math.min(1, (event.clientY - box.top - half) / half));
      this.push = [x, -y];
      this.stick.firstElementChild.style.transform = `translate(${x * half * 0.6}px, ${y * half * 0.6}px)`;
      this.stick.dispatchEvent(new Event("push", { bubbles: true }));
    };
    const end = () => {
      this.push = [0, 0];
      this.stick.firstElementChild.style.transform = "";
    };
    this.stick.addEventListener("pointerdown", (event) => {
      this.stick.setPointerCapture(event.pointerId);
      set(event);
    });
    this.stick.addEventListener("pointermove", (event) => event.buttons && set(event));
    for (const name of ["pointerup", "pointercancel"]) this.stick.addEventListener(name, end);
  }
}
