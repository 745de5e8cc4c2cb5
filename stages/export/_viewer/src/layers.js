// What is drawn over the home on demand: boxes, what parts sweep, free floor, the robot's way, receptacles.
import { BoxGeometry, BufferAttribute, BufferGeometry, DoubleSide, EdgesGeometry, Float32BufferAttribute, Group, Line,
  LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, Shape, ShapeGeometry, Vector3 } from "three";

const ABOVE = 0.012; // m that what lies on the floor is drawn above it
const COLORS = { boxes: 0x1f6fd0, sweeps: 0xd9480f, floor: 0x2b8a3e, way: 0x7048e8, receptacles: 0x0b7285 };

export const LAYERS = {
  boxes: ["Boxes", boxes],
  sweeps: ["What parts sweep", sweeps],
  floor: ["Free floor", floor],
  way: ["A robot's way", way],
  receptacles: ["Where things go", receptacles],
};

export class Layers {
  constructor(home) {
    this.home = home;
    this.made = {};
  }

  show(name, on) {
    if (on && !this.made[name]) {
      this.made[name] = LAYERS[name][1](this.home.facts);
      this.home.plan.add(this.made[name]);
      this.made[name].updateMatrixWorld(true);
    }
    if (this.made[name]) this.made[name].visible = on;
  }

  on(name) {
    return Boolean(this.made[name]?.visible);
  }
}

// A group at an object's place, in its own frame.
export function placed({ center, yaw }) {
  const found = new Group();
  found.position.set(...center);
  found.rotation.z = yaw;
  return found;
}

export function outline(size, color, middle = [0, 0, 0]) {
  const lines = new LineSegments(new EdgesGeometry(new BoxGeometry(...size)), new LineBasicMaterial({ color }));
  lines.position.set(...middle);
  return lines;
}

export function veil(color, opacity) {
  return new MeshBasicMaterial({ color, transparent: true, opacity, depthWrite: false, side: DoubleSide });
}

function boxes({ things }) {
  const found = new Group();
  for (const thing of things) found.add(placed(thing).add(outline(thing.size, COLORS.boxes)));
  return found;
}

function sweeps({ things, leaves }) {
  const found = new Group();
  const material = veil(COLORS.sweeps, 0.25);
  for (const thing of things) {
    for (const [low, high] of thing.sweeps || []) {
      const size = high.map((v, k) => v - low[k]);
      const middle = high.map((v, k) => (v + low[k]) / 2);
      const solid = new Mesh(new BoxGeometry(...size), material);
      solid.position.set(...middle);
      found.add(placed(thing).add(solid, outline(size, COLORS.sweeps, middle)));
    }
  }
  for (const corners of leaves) found.add(flat(corners, ABOVE, material));
  return found;
}

function floor({ free }) {
  const corners = [];
  const { x, y, cell } = free;
  for (const [row, from, to] of free.runs) {
    const [x0, x1, y0, y1] = [x + from * cell, x + to * cell, y + row * cell, y + (row + 1) * cell];
    corners.push(x0, y0, ABOVE, x1, y0, ABOVE, x1, y1, ABOVE, x0, y0, ABOVE, x1, y1, ABOVE, x0, y1, ABOVE);
  }
  const shape = new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array(corners), 3));
  return new Group().add(new Mesh(shape, veil(COLORS.floor, 0.35)));
}

function way({ way: points }) {
  const shape = new BufferGeometry().setFromPoints(points.map(([x, y]) => new Vector3(x, y, 2 * ABOVE)));
  const ends = new BufferGeometry().setAttribute(
    "position", new Float32BufferAttribute(ribbon(points, 0.03), 3));
  return new Group().add(
    new Line(shape, new LineBasicMaterial({ color: COLORS.way })), new Mesh(ends, veil(COLORS.way, 0.9)));
}

// Triangles of a band of this half width along points.
function ribbon(points, half) {
  const found = [];
  for (let k = 1; k < points.length; k++) {
    const [[ax, ay], [bx, by]] = [points[k - 1], points[k]];
    const length = Math.hypot(bx - ax, by - ay) || 1;
    const [nx, ny] = [(-(by - ay) / length) * half, ((bx - ax) / length) * half];
    const corners = [[ax + nx, ay + ny], [ax - nx, ay - ny], [bx - nx, by - ny], [bx + nx, by + ny]];
    for (const i of [0, 1, 2, 0, 2, 3]) found.push(...corners[i], 2 * ABOVE);
  }
  return found;
}

function receptacles({ things }) {
  const found = new Group();
  const material = veil(COLORS.receptacles, 0.5);
  for (const thing of things) {
    for (const { polygon, z } of thing.receptacles || []) found.add(placed(thing).add(flat(polygon, z + 0.004, material)));
  }
  return found;
}

function flat(corners, z, material) {
  const mesh = new Mesh(new ShapeGeometry(new Shape(corners.map(([x, y]) => new Vector3(x, y)))), material);
  mesh.position.z = z;
  return mesh;
}
