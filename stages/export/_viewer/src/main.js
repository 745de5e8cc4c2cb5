// The page: puts the view, the panel and what people do together.
import { Box3, Vector3 } from "three";
import { bodyOf, load } from "./home.js";
import { byId, element, Panel } from "./panel.js";
import { read, written } from "./state.js";
import { View } from "./view.js";

const STILL = 4; // pixels that a click may wander
const DIM = matchMedia("(prefers-color-scheme: dark)");
const TURNS = { ArrowLeft: [-0.15, 0, 1], ArrowRight: [0.15, 0, 1], ArrowUp: [0, 0.1, 1], ArrowDown: [0, -0.1, 1],
  "+": [0, 0, 0.85], "=": [0, 0, 0.85], "-": [0, 0, 1.18] };

const canvas = byId("view");
const home = await load(byId("scene").textContent, JSON.parse(byId("told").textContent));
const view = new View(home, canvas, byId("stick"));
const panel = new Panel(view);
view.taken = () => panel.taken;
view.changed = () => panel.update();

// ---- the address, kept as it is looked at

let writing = 0;
let own = "";
let leads = false;
view.still = () => {
  panel.update();
  clearTimeout(writing);
  writing = setTimeout(() => {
    own = written(view);
    history.replaceState(null, "", own);
  }, 250);
};
addEventListener("hashchange", () => location.hash !== own && read(view, location.hash));

// Beside another home: both are looked at alike, each about its own middle.
const middle = home.bounds.getCenter(new Vector3());
const sight = () => [view.camera.position, view.controls.target].flatMap((v) => v.clone().sub(middle).toArray());
view.controls.addEventListener("start", () => (leads = true));
view.controls.addEventListener("change", () => {
  if (leads && window.parent !== window && !view.walk.on) window.parent.postMessage({ look: sight() }, "*");
});
addEventListener("message", ({ data }) => {
  if (!Array.isArray(data?.follow) || data.follow.length !== 6 || view.walk.on) return;
  leads = false;
  view.camera.position.fromArray(data.follow).add(middle);
  view.controls.target.fromArray(data.follow, 3).add(middle);
  view.controls.update();
});

// ---- buttons

function theme(dark) {
  document.documentElement.dataset.theme = dark ? "dark" : "light";
  view.looks.theme(dark);
  view.draw();
}
theme(DIM.matches);
DIM.addEventListener("change", () => theme(DIM.matches));
byId("theme").onclick = () => theme(document.documentElement.dataset.theme !== "dark");
byId("ceilings").onchange = () => view.roof(byId("ceilings").checked);
byId("open").onclick = () => home.parts.forEach((part) => view.send(part, 1));
byId("shut").onclick = () => home.parts.forEach((part) => view.send(part, 0));
byId("walk").onclick = () => (view.walk.on ? view.leave() : view.enter());
byId("fold").onclick = () => {
  const folded = byId("panel").classList.toggle("folded");
  byId("fold").ariaExpanded = String(!folded);
  if (view.walk.on) view.resize();
  else view.refit();
};
byId("shoot").onclick = async () => {
  const link = element("a", { href: URL.createObjectURL(await view.picture()), download: "apartment.png" });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
};
byId("close").onclick = () => choose(null);

function choose(body, look = false) {
  view.pick(body, look);
  panel.show(body);
}
const { pick, isolate } = view;
view.pick = (body, look) => {
  pick.call(view, body, look);
  panel.show(body);
};
view.isolate = (name, move) => {
  isolate.call(view, name, move);
  panel.list();
};

// ---- keys and pointers

const typing = (event) => ["INPUT", "SELECT", "TEXTAREA"].includes(event.target.tagName);
addEventListener("keydown", (event) => {
  if (event.key === "Escape") return view.walk.on ? view.leave() : (choose(null), view.isolate(""));
  if (typing(event) || event.ctrlKey || event.metaKey || event.altKey) return;
  if (view.walk.press(event.code, true)) {
    event.preventDefault();
    view.draw();
  } else if (document.activeElement === canvas && event.key in TURNS) {
    event.preventDefault();
    view.turn(...TURNS[event.key]);
  } else if (event.key === "/") {
    event.preventDefault();
    byId("search").focus();
  }
});
addEventListener("keyup", (event) => view.walk.press(event.code, false));
addEventListener("blur", () => view.walk.held.clear());

let pressed = null;
canvas.addEventListener("pointerdown", (event) => {
  pressed = [event.clientX, event.clientY, event.clientX, event.clientY];
  canvas.focus({ preventScroll: true });
});
canvas.addEventListener("click", (event) => {
  if (!pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > STILL) return; // it was a turn
  const object = view.hit(event.clientX, event.clientY)?.object;
  const part = home.partOf(object);
  if (part) view.send(part, part.goal ? 0 : 1);
  const body = object && bodyOf(object);
  choose(["object", "door", "window"].includes(body?.userData.kind) ? body : null);
});
canvas.addEventListener("dblclick", (event) => {
  const hit = view.hit(event.clientX, event.clientY);
  if (hit && ["floor", "object"].includes(bodyOf(hit.object)?.userData.kind) && hit.point.y < 0.1) view.stand(hit.point);
});
canvas.addEventListener("pointermove", (event) => {
  if (!event.buttons) return panel.hover(view.hit(event.clientX, event.clientY)?.object);
  if (!view.walk.on || !pressed) return;
  view.walk.drag(event.clientX - pressed[2], event.clientY - pressed[3]);
  pressed.splice(2, 2, event.clientX, event.clientY);
  view.draw();
});

addEventListener("resize", () => view.resize());
view.resize();
view.isolate("");
read(view, location.hash);
view.looks.prepare(view.camera);
requestAnimationFrame(() => requestAnimationFrame(() => (document.body.dataset.frame = performance.now().toFixed(0))));

// For scripts and tests: parts by name, and where on the page one is.
window.apartment = {
  parts: home.parts,
  bodies: home.bodies,
  view,
  isolate: (name) => view.isolate(name),
  at(name) {
    view.camera.updateMatrixWorld();
    const point = new Box3().setFromObject(home.scene.getObjectByName(name)).getCenter(new Vector3()).project(view.camera);
    return [((point.x + 1) / 2) * innerWidth, ((1 - point.y) / 2) * innerHeight];
  },
  look: (name) => view.look(new Box3().setFromObject(home.scene.getObjectByName(name))),
};
document.body.dataset.ready = "yes";
