// The apartment in a browser: looks at the GLB that the page carries, and moves its parts as the nodes' extras say.
import {
  ACESFilmicToneMapping, Box3, Color, DirectionalLight, PCFShadowMap, PerspectiveCamera, PMREMGenerator, Quaternion,
  Raycaster, Scene, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { RoomEnvironment } from "three/examples/jsm/environments/RoomEnvironment.js";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";

const SECONDS = 0.6; // from shut to open
const EYES = 1.6; // m above the floor
const WALL = 0.1; // m, doors and windows so near to a room's floor are shown with it

const byId = (id) => document.getElementById(id);
const renderer = new WebGLRenderer({ antialias: true, canvas: byId("view") });
renderer.shadowMap.enabled = true;
renderer.shadowMap.type = PCFShadowMap;
renderer.toneMapping = ACESFilmicToneMapping;
const scene = new Scene();
scene.background = new Color(0xe9ecef);
scene.environment = new PMREMGenerator(renderer).fromScene(new RoomEnvironment(), 0.04).texture;
scene.environmentIntensity = 0.7;
const camera = new PerspectiveCamera(50, 1, 0.05, 200);
const controls = new OrbitControls(camera, renderer.domElement);

const bodies = []; // nodes of the artifact's objects, doors, walls, ...
const parts = []; // nodes that move: { node, joint, position, turn, share, goal }
let room = ""; // the only one shown, or all
let pending = false;

const bytes = Uint8Array.from(atob(byId("scene").textContent.trim()), (c) => c.charCodeAt(0));
const { scene: apartment, asset } = await new GLTFLoader().parseAsync(bytes.buffer, "");
apartment.traverse((node) => {
  if (node.isLight) node.visible = false; // dozens of lamps without shadows would shine through walls
  if (node.isMesh) {
    const clear = node.material.transparent;
    node.castShadow = !clear;
    node.receiveShadow = !clear;
  }
  if (node.userData.kind) bodies.push(node);
  const { joint } = node.userData;
  if (joint) {
    const [position, turn] = [node.position.clone(), node.quaternion.clone()];
    parts.push({ node, joint, axis: new Vector3(...joint.axis).normalize(), position, turn, share: 0, goal: 0 });
  }
});
scene.add(apartment);
for (const node of bodies) {
  boxOf(node);
  if (node.userData.kind === "ceiling") node.traverse((child) => (child.castShadow = false));
}
const bounds = new Box3().setFromObject(apartment);
const middle = bounds.getCenter(new Vector3());
const reach = bounds.getSize(new Vector3()).length();
scene.add(sun());
byId("credits").textContent = asset.copyright || "";

function sun() {
  const light = new DirectionalLight(0xfff2dd, 2.2);
  light.position.copy(middle).add(new Vector3(-0.4, 1, 0.35).multiplyScalar(reach));
  light.target.position.copy(middle);
  light.target.updateMatrixWorld();
  light.castShadow = true;
  light.shadow.mapSize.set(2048, 2048);
  light.shadow.normalBias = 0.02;
  const half = reach / 2;
  Object.assign(light.shadow.camera, { left: -half, right: half, top: half, bottom: -half, near: 0.1, far: 2 * reach });
  return light;
}

// ---- what moves -----------------------------------------------------------------------------------------------------

function place(part) {
  const { node, joint, axis, position, turn, share } = part;
  const [shut, open] = joint.range;
  const value = shut + (open - shut) * share;
  if (joint.type === "hinge") {
    node.quaternion.copy(turn).multiply(new Quaternion().setFromAxisAngle(axis, value));
  } else {
    node.position.copy(axis).multiplyScalar(value).applyQuaternion(turn).add(position);
  }
}

function send(part, goal) {
  part.goal = goal;
  draw();
}

function partOf(object) {
  for (let node = object; node; node = node.parent) {
    const found = parts.find((part) => part.node === node);
    if (found) return found;
  }
  return null;
}

function bodyOf(object) {
  let node = object;
  while (node && !node.userData.kind) node = node.parent;
  return node;
}

// ---- what shows -----------------------------------------------------------------------------------------------------

function show() {
  const ceilings = byId("ceilings").checked;
  const floor = bodies.find((node) => node.userData.kind === "floor" && node.userData.room === room);
  const within = floor && new Box3().setFromObject(floor).expandByVector(new Vector3(WALL, 3, WALL));
  for (const node of bodies) {
    const { kind, room: own = "" } = node.userData;
    const beside = within && joinery(node) && within.intersectsBox(boxOf(node));
    node.visible = (!room || own === room || beside) && (kind !== "ceiling" || ceilings) && (ceilings || !overhead(node));
  }
  for (const button of byId("rooms").children) button.ariaPressed = String(button.value === room);
  draw();
}

function boxOf(node) {
  return (node.userData.box ??= new Box3().setFromObject(node)); // taken with everything shut
}

function joinery(node) {
  return ["door", "window"].includes(node.userData.kind) || node.userData.category === "opening";
}

function overhead(node) {
  return node.userData.category === "ceiling_lamp";
}

function isolate(name) {
  room = name;
  show();
  const box = new Box3();
  for (const node of bodies) if (node.visible && node.userData.kind !== "ceiling") box.expandByObject(node);
  look(box);
}

function panel() {
  const wide = document.querySelector("aside").getBoundingClientRect().right;
  return wide < innerWidth / 2 ? wide : 0;
}

function free() {
  return (innerWidth - panel()) / innerHeight; // what is looked at stands in the middle of what the panel leaves free
}

function look(box) {
  const size = box.getSize(new Vector3());
  const half = Math.max(size.x / free(), size.z + size.y / 2, 2) / 2;
  const far = (1.1 * half) / Math.tan((camera.fov * Math.PI) / 360) + size.y / 2;
  box.getCenter(controls.target);
  camera.position.copy(controls.target).add(new Vector3(0.05, 1, 0.5).setLength(far));
  controls.update();
  draw();
}

function stand(point) {
  camera.position.set(point.x, point.y + EYES, point.z);
  const towards = new Vector3().subVectors(room ? controls.target : middle, camera.position).setY(0);
  if (towards.length() < 0.1) towards.set(0, 0, -1);
  controls.target.copy(camera.position).add(towards.setLength(0.05));
  controls.update();
  byId("ceilings").checked = true;
  show();
}

// ---- the page -------------------------------------------------------------------------------------------------------

const rooms = [...new Set(bodies.filter((n) => n.userData.kind === "floor").map((n) => n.userData.room || ""))];
for (const name of ["", ...rooms.filter(Boolean)]) {
  const button = document.createElement("button");
  button.value = name;
  button.textContent = name ? name.replaceAll("_", " ") : "all rooms";
  button.onclick = () => isolate(name);
  byId("rooms").append(button);
}
byId("ceilings").onchange = show;
byId("open").onclick = () => parts.forEach((part) => send(part, 1));
byId("shut").onclick = () => parts.forEach((part) => send(part, 0));
addEventListener("keydown", (event) => event.key === "Escape" && isolate(""));

function pick(event) {
  const at = new Vector2((event.clientX / innerWidth) * 2 - 1, 1 - (event.clientY / innerHeight) * 2);
  const ray = new Raycaster();
  camera.updateMatrixWorld();
  ray.setFromCamera(at, camera);
  const shown = (node) => !node || (node.visible && shown(node.parent));
  return ray.intersectObject(apartment, true).find((hit) => shown(hit.object));
}

let pressed = [0, 0];
const canvas = renderer.domElement;
canvas.addEventListener("pointerdown", (event) => (pressed = [event.clientX, event.clientY]));
canvas.addEventListener("click", (event) => {
  if (Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 4) return; // it was a turn of the view
  const part = partOf(pick(event)?.object);
  if (part) send(part, part.goal ? 0 : 1);
});
canvas.addEventListener("dblclick", (event) => {
  const hit = pick(event);
  if (hit && ["floor", "object"].includes(bodyOf(hit.object)?.userData.kind) && hit.point.y < 0.1) stand(hit.point);
});
canvas.addEventListener("pointermove", (event) => {
  if (event.buttons) return;
  const object = pick(event)?.object;
  const [body, part] = [object && bodyOf(object), object && partOf(object)];
  const about = body ? [body.userData.id || body.name, part && `${part.joint.name}: click`] : [];
  byId("about").textContent = about.filter(Boolean).join(" · ").replaceAll("_", " ");
  canvas.style.cursor = part ? "pointer" : "default";
});

function resize() {
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  renderer.setSize(innerWidth, innerHeight);
  camera.aspect = innerWidth / innerHeight;
  camera.setViewOffset(innerWidth, innerHeight, -panel() / 2, 0, innerWidth, innerHeight);
  draw();
}
addEventListener("resize", resize);
controls.addEventListener("change", draw);

let last = 0;
function draw() {
  if (!pending) {
    pending = true;
    last = performance.now();
    requestAnimationFrame(frame);
  }
}

function frame(now) {
  const step = Math.max(now - last, 0) / 1000 / SECONDS;
  last = now;
  let moves = false;
  for (const part of parts) {
    if (part.share === part.goal) continue;
    const left = part.goal - part.share;
    part.share = Math.abs(left) <= step ? part.goal : part.share + Math.sign(left) * step;
    place(part);
    moves ||= part.share !== part.goal;
  }
  renderer.render(scene, camera);
  pending = false;
  if (moves) {
    pending = true;
    requestAnimationFrame(frame);
  }
}

resize();
isolate("");
// For scripts and tests: parts by name, and where on the page one is.
window.apartment = {
  parts,
  bodies,
  isolate,
  at(name) {
    camera.updateMatrixWorld();
    const box = new Box3().setFromObject(apartment.getObjectByName(name));
    const point = box.getCenter(new Vector3()).project(camera);
    return [((point.x + 1) / 2) * innerWidth, ((1 - point.y) / 2) * innerHeight];
  },
  look: (name) => look(new Box3().setFromObject(apartment.getObjectByName(name))),
};
document.body.dataset.ready = "yes";
