// The home that the page carries: its scene as nodes, what moves in it, and what the artifact tells of it.
import { Box3, Group, Quaternion, Texture, Vector3 } from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";

const SECONDS = 0.6; // from shut to open

export async function load(binary, facts) {
  const loader = new GLTFLoader().register((parser) => {
    if (parser.textureLoader.isImageBitmapLoader) parser.textureLoader = INSIDE;
    return { name: "pictures" };
  });
  const { scene, asset } = await loader.parseAsync(bytesOf(binary).buffer, "");
  return new Home(scene, asset.copyright || "", facts);
}

// Textures straight from the bytes of the scene: the loader's own way asks the browser for each by an address first.
// Such loaders are asked only if they are of that name.
const INSIDE = {
  isKTX2Loader: true,
  parse(bytes, done, failed) {
    const way = { premultiplyAlpha: "none", colorSpaceConversion: "none" };
    createImageBitmap(new Blob([bytes]), way).then((picture) => {
      const texture = new Texture(picture);
      texture.needsUpdate = true;
      done(texture);
    }, failed);
  },
};

function bytesOf(binary) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(binary);
  const text = atob(binary.trim());
  const bytes = new Uint8Array(text.length);
  for (let k = 0; k < text.length; k++) bytes[k] = text.charCodeAt(k);
  return bytes;
}

class Home {
  constructor(scene, credits, facts) {
    this.scene = scene;
    this.credits = credits;
    this.facts = facts;
    this.bodies = []; // nodes of objects, doors, walls, ...
    this.parts = []; // nodes that move: { node, joint, position, turn, share, goal }
    this.plan = new Group(); // what is drawn in the plan's own axes, z up
    this.plan.rotation.x = -Math.PI / 2;
    scene.traverse((node) => this.#meet(node));
    this.byId = new Map(this.bodies.map((body) => [body.userData.id || body.name, body]));
    for (const body of this.bodies) boxOf(body);
    this.bounds = new Box3();
    for (const body of this.bodies) if (body.userData.kind !== "ceiling") this.bounds.union(boxOf(body));
    scene.updateMatrixWorld(true);
    scene.traverse((node) => (node.matrixAutoUpdate = false)); // only parts move
  }

  #meet(node) {
    if (node.isLight) node.visible = false; // dozens of lamps without shadows would shine through walls
    if (node.userData.kind) this.bodies.push(node);
    const { joint } = node.userData;
    if (!joint) return;
    const [position, turn] = [node.position.clone(), node.quaternion.clone()];
    this.parts.push({ node, joint, axis: new Vector3(...joint.axis).normalize(), position, turn, share: 0, goal: 0 });
  }

  // Moves parts towards where they are sent; true while any is on its way.
  advance(seconds) {
    let moves = false;
    for (const part of this.parts) {
      if (part.share === part.goal) continue;
      const left = part.goal - part.share;
      const step = seconds / SECONDS;
      set(part, Math.abs(left) <= step ? part.goal : part.share + Math.sign(left) * step);
      moves ||= part.share !== part.goal;
    }
    return moves;
  }

  partsOf(body) {
    return this.parts.filter((part) => bodyOf(part.node) === body);
  }

  partOf(object) {
    for (let node = object; node; node = node.parent) {
      const found = this.parts.find((part) => part.node === node);
      if (found) return found;
    }
    return null;
  }
}

// Puts a part at a share of its range, at once.
export function set(part, share) {
  const { node, joint, axis, position, turn } = part;
  const [shut, open] = joint.range;
  const value = shut + (open - shut) * share;
  part.share = share;
  if (joint.type === "hinge") node.quaternion.copy(turn).multiply(new Quaternion().setFromAxisAngle(axis, value));
  else node.position.copy(axis).multiplyScalar(value).applyQuaternion(turn).add(position);
  node.updateMatrix();
  node.updateMatrixWorld(true);
}

export function bodyOf(object) {
  let node = object;
  while (node && !node.userData.kind) node = node.parent;
  return node;
}

export function boxOf(node) {
  return (node.userData.box ??= new Box3().setFromObject(node)); // taken with everything shut
}

export function spoken(name) {
  return name.replaceAll("_", " ");
}
