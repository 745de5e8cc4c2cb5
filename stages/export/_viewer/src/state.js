// Where one looks and what is shown, as the part of the address behind #, so that it can be kept and sent.
import { LAYERS } from "./layers.js";

const rounded = (vector) => vector.toArray().map((v) => v.toFixed(2)).join(",");
const numbers = (text) => text.split(",").map(Number);

export function written(view) {
  const found = new URLSearchParams();
  if (view.room) found.set("room", view.room);
  found.set("at", rounded(view.camera.position));
  if (view.walk.on) found.set("walk", `${view.walk.yaw.toFixed(2)},${view.walk.pitch.toFixed(2)}`);
  else found.set("to", rounded(view.controls.target));
  if (view.chosen) found.set("thing", view.chosen.userData.id || view.chosen.name);
  const layers = Object.keys(LAYERS).filter((name) => view.layers.on(name));
  if (layers.length) found.set("layers", layers.join(","));
  if (!view.steps.last) found.set("step", view.steps.at);
  if (view.ceilings) found.set("ceilings", "yes");
  const open = view.home.parts.filter((part) => part.goal > 0);
  if (open.length) found.set("open", open.map((part) => `${part.node.name}:${part.goal.toFixed(2)}`).join(","));
  return `#${found}`;
}

export function read(view, text) {
  const given = new URLSearchParams(text.replace(/^#/, ""));
  if (!given.size) return false;
  view.isolate(given.get("room") || "", false);
  const at = numbers(given.get("at") || "");
  const to = numbers(given.get(given.has("walk") ? "walk" : "to") || "");
  if (at.length === 3 && at.every(Number.isFinite) && to.every(Number.isFinite)) place(view, at, to, given.has("walk"));
  for (const name of Object.keys(LAYERS)) view.layer(name, (given.get("layers") || "").split(",").includes(name));
  if (given.has("step")) view.step(Number(given.get("step")) || 0);
  view.roof(given.has("ceilings"));
  const open = new Map((given.get("open") || "").split(",").filter(Boolean).map((one) => one.split(":")));
  for (const part of view.home.parts) view.move(part, Math.min(1, Math.max(0, Number(open.get(part.node.name)) || 0)));
  const body = view.home.byId.get(given.get("thing"));
  if (body) view.pick(body, false);
  return true;
}

function place(view, at, to, walking) {
  if (walking) {
    view.stand({ x: at[0], z: at[2] });
    Object.assign(view.walk, { yaw: to[0], pitch: to[1] });
    view.walk.drag(0, 0);
    return;
  }
  view.camera.position.set(...at);
  view.controls.target.set(...to);
  view.controls.update();
}
