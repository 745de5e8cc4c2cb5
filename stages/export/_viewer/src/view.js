// The picture of a home: a camera about it or in it, and what of it shows.
import { Box3, BoxHelper, PerspectiveCamera, Quaternion, Raycaster, Vector2, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Cut } from "./cut.js";
import { bodyOf, boxOf, set } from "./home.js";
import { Layers } from "./layers.js";
import { Looks } from "./looks.js";
import { Steps } from "./steps.js";
import { Walk } from "./walk.js";

const WALL = 0.1; // m, doors and windows so near to a room's floor are shown with it
const STEEP = 0.42; // metres aside a metre of height from where one first looks
const QUICK = 90; // ms a frame may take for fine looks to be tried
const SLOW = 300; // ms between frames from which fine looks are given up

export class View {
  constructor(home, canvas, stick) {
    Object.assign(this, { home, canvas, room: "", chosen: null, ceilings: false, pending: false, frames: 0 });
    this.cut = new Cut(home);
    this.looks = new Looks(canvas, home, this.cut);
    this.cut.addCaps();
    this.camera = new PerspectiveCamera(50, 1, 0.05, 200);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.draw());
    this.layers = new Layers(home);
    this.steps = new Steps(home);
    this.walk = new Walk(home, this.camera, stick);
    stick.addEventListener("push", () => this.draw());
    this.taken = () => [0, 0]; // pixels taken away on the left and below
    this.changed = () => {}; // called when something is shown that was not
    this.still = () => {}; // called when all has come to rest
  }

  // ---- what shows

  isolate(name, move = true) {
    this.room = name;
    this.leave();
    this.cut.room(name);
    this.show();
    if (move) this.refit();
  }

  show() {
    const floor = this.home.bodies.find((body) => body.userData.kind === "floor" && body.userData.room === this.room);
    const within = this.room && floor && boxOf(floor).clone().expandByVector(new Vector3(WALL, 3, WALL));
    const overhead = this.ceilings || this.walk.on;
    for (const body of this.home.bodies) {
      const { kind, room = "", id } = body.userData;
      const beside = within && joinery(body) && within.intersectsBox(boxOf(body));
      const here = !this.room || room === this.room || Boolean(beside);
      body.visible = here && (overhead || !hangs(body)) && !this.steps.hides(id) && kind !== "hidden";
    }
    this.cut.on = !overhead;
    this.looks.cast();
    this.draw();
    this.changed();
  }

  #shown() {
    const box = new Box3();
    for (const body of this.home.bodies) if (body.visible && body.userData.kind !== "ceiling") box.union(boxOf(body));
    return box;
  }

  refit() {
    this.resize();
    this.look(this.#shown());
  }

  roof(on) {
    this.ceilings = on;
    this.show();
  }

  layer(name, on) {
    this.layers.show(name, on);
    this.draw();
    this.changed();
  }

  step(at) {
    this.steps.go(at);
    this.show();
  }

  // ---- where one looks from

  // What is looked at stands in the middle of what is left free.
  look(box) {
    const size = box.getSize(new Vector3());
    const [left, below] = this.taken();
    const [wide, high] = [(innerWidth - left) / innerHeight, (innerHeight - below) / innerHeight];
    const side = this.#side();
    const [across, along] = side.x ? [size.z, size.x] : [size.x, size.z];
    const half = Math.max(across / wide, (along + size.y / 2) / high, 1.2) / 2;
    const far = (1.1 * half) / Math.tan((this.camera.fov * Math.PI) / 360) + size.y / 2;
    box.getCenter(this.controls.target);
    const aside = new Vector3(side.z, 0, -side.x).multiplyScalar(0.05);
    this.camera.position.copy(this.controls.target).add(aside.addScaledVector(side, STEEP).setY(1).setLength(far));
    this.controls.update();
    this.draw();
  }

  // From the side to which most fronts look, as things are hidden by those whose backs one sees, the south before others.
  #side() {
    const fronts = new Vector3();
    for (const body of this.home.bodies) {
      if (!body.visible || body.userData.kind !== "object") continue;
      const box = boxOf(body), size = box.getSize(new Vector3());
      const front = new Vector3(1, 0, 0).applyQuaternion(body.getWorldQuaternion(new Quaternion()));
      fronts.addScaledVector(front, size.y * Math.hypot(size.x * front.z, size.z * front.x));
    }
    const sides = [[0, 1], [0, -1], [1, 0], [-1, 0]].map(([x, z]) => new Vector3(x, 0, z));
    return sides.reduce((best, side) => (side.dot(fronts) > best.dot(fronts) + 1e-6 ? side : best));
  }

  // Stands at a point of the floor, looking to what was looked at.
  stand(point) {
    const towards = new Vector3().subVectors(this.controls.target, point).setY(0);
    this.controls.enabled = false;
    this.walk.begin(point, towards.length() > 0.1 ? towards : null);
    this.show();
  }

  // Goes in, to the nearest free floor of the room shown, or back to the view from above.
  enter() {
    const { way, free } = this.home.facts;
    const { x, z } = this.controls.target;
    const [row, from, to] = free.runs[0] || [0, 0, 0];
    const start = way[0] || [free.x + ((from + to) / 2) * free.cell, free.y + row * free.cell];
    const near = way.reduce((best, p) => (Math.hypot(p[0] - x, -p[1] - z) < Math.hypot(best[0] - x, -best[1] - z) ?
      p : best), start);
    const [px, py] = this.room ? near : start;
    this.stand({ x: px, z: -py });
  }

  leave() {
    if (!this.walk.on) return;
    this.walk.end();
    this.controls.enabled = true;
    this.show();
    this.look(this.#shown());
  }

  turn(across, up, nearer) {
    const arm = new Vector3().subVectors(this.camera.position, this.controls.target);
    const [far, yaw] = [arm.length() * nearer, Math.atan2(arm.x, arm.z) + across];
    const pitch = Math.max(0.05, Math.min(1.5, Math.asin(arm.y / arm.length()) + up));
    arm.set(Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), Math.cos(yaw) * Math.cos(pitch)).multiplyScalar(far);
    this.camera.position.copy(this.controls.target).add(arm);
    this.controls.update();
  }

  // ---- things

  pick(body, look) {
    this.chosen = body;
    this.frame?.removeFromParent();
    this.frame?.dispose();
    this.frame = body && new BoxHelper(body, 0xf08c00);
    if (body) this.looks.scene.add(this.frame);
    if (body && look && !this.walk.on) {
      if (this.room && body.userData.room !== this.room) this.isolate("", false);
      const box = boxOf(body).clone().expandByScalar(0.6);
      this.look(box);
    }
    this.draw();
    this.changed();
  }

  send(part, goal) {
    part.goal = goal;
    this.draw();
  }

  move(part, share) {
    part.goal = share;
    set(part, share);
    this.looks.cast();
    this.draw();
  }

  // What is first met at a place of the page.
  hit(x, y) {
    const ray = new Raycaster();
    this.camera.updateMatrixWorld();
    ray.setFromCamera(new Vector2((x / innerWidth) * 2 - 1, 1 - (y / innerHeight) * 2), this.camera);
    const seen = (node) => !node || (node.visible && seen(node.parent));
    return ray.intersectObject(this.home.scene, true).find(({ object, point }) =>
      seen(object) && !this.cut.away(bodyOf(object), point, this.camera.position));
  }

  // ---- frames

  resize() {
    const ratio = this.looks.fine ? Math.min(devicePixelRatio, 2) : 1;
    this.looks.renderer.setPixelRatio(ratio);
    this.looks.renderer.setSize(innerWidth, innerHeight);
    this.camera.aspect = innerWidth / innerHeight;
    const [left, below] = this.taken();
    this.camera.setViewOffset(innerWidth, innerHeight, -left / 2, below / 2, innerWidth, innerHeight);
    this.draw();
  }

  draw() {
    if (this.pending) return;
    this.pending = true;
    this.last = performance.now();
    requestAnimationFrame((now) => this.#frame(now));
  }

  #frame(now) {
    const seconds = Math.min(Math.max(now - this.last, 0) / 1000, 0.5);
    this.slow = now - this.last > SLOW ? (this.slow || 0) + 1 : 0;
    this.last = now;
    this.pending = false;
    if (this.looks.fine && this.slow > 2) this.looks.coarsen();
    const moved = this.home.advance(seconds);
    const walked = this.walk.advance(seconds);
    if (moved) this.looks.cast();
    const began = performance.now();
    this.looks.renderer.render(this.looks.scene, this.camera);
    this.#judge(began);
    if (moved || walked) {
      this.pending = true;
      requestAnimationFrame((later) => this.#frame(later));
      this.changed();
    } else this.still();
  }

  // Fine looks are tried once a plain frame has been quick, the first with its compiling left out.
  #judge(began) {
    this.frames += 1;
    if (this.looks.fine || this.frames > 3) return;
    const third = this.frames === 3;
    this.looks.drawn().then(() => {
      if (third && performance.now() - began < QUICK) this.refine();
      else if (!third) this.draw();
    });
  }

  refine() {
    this.looks.refine();
    this.resize();
  }

  // The picture as a PNG.
  async picture() {
    this.looks.renderer.render(this.looks.scene, this.camera);
    return new Promise((done) => this.canvas.toBlob(done, "image/png"));
  }
}

function joinery(body) {
  return ["door", "window"].includes(body.userData.kind) || body.userData.category === "opening";
}

function hangs(body) {
  return body.userData.kind === "ceiling" || body.userData.category === "ceiling_lamp";
}
