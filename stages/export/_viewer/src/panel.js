// The page about the picture: rooms, search, what a thing is, sliders, layers, the timeline.
import { bodyOf, spoken } from "./home.js";
import { LAYERS } from "./layers.js";

const MOST = 60; // things listed at a time

export const byId = (id) => document.getElementById(id);

export function element(tag, properties = {}, ...children) {
  const found = Object.assign(document.createElement(tag), properties);
  found.append(...children);
  return found;
}

export class Panel {
  constructor(view) {
    this.view = view;
    this.home = view.home;
    this.things = this.home.bodies.filter((body) => ["object", "door", "window"].includes(body.userData.kind));
    this.facts = new Map(this.home.facts.things.map((thing) => [thing.id, thing]));
    this.#rooms();
    this.#layers();
    this.#steps();
    this.list();
    byId("search").oninput = () => this.list();
    byId("search").onkeydown = (event) => event.key === "Enter" && byId("found").querySelector("button")?.click();
    byId("credits").textContent = this.home.credits;
    byId("numbers").append(...this.home.facts.numbers.map(([name, value]) =>
      element("tr", {}, element("th", { scope: "row", textContent: name }), element("td", { textContent: value }))));
  }

  #rooms() {
    const floors = this.home.bodies.filter((body) => body.userData.kind === "floor");
    for (const name of new Set(["", ...floors.map((body) => body.userData.room || "")])) {
      const button = element("button", { type: "button", value: name, textContent: name ? spoken(name) : "all rooms" });
      button.onclick = () => this.view.isolate(name);
      byId("rooms").append(button);
    }
  }

  #layers() {
    for (const [name, [text]] of Object.entries(LAYERS)) {
      const box = element("input", { type: "checkbox", id: `layer_${name}` });
      box.onchange = () => this.view.layer(name, box.checked);
      byId("layers").append(element("label", {}, box, ` ${text}`));
    }
  }

  #steps() {
    const { steps } = this.home.facts;
    byId("timeline").hidden = steps.length === 0;
    const slider = Object.assign(byId("step"), { min: 0, max: steps.length, value: steps.length });
    slider.oninput = () => this.view.step(Number(slider.value));
    byId("back").onclick = () => this.view.step(this.view.steps.at - 1);
    byId("on").onclick = () => this.view.step(this.view.steps.at + 1);
  }

  // Things that have the searched words in their names, of the room shown.
  list() {
    const words = byId("search").value.toLowerCase().split(/\s+/).filter(Boolean);
    const named = (body) => spoken(`${body.userData.id || body.name} ${body.userData.category}`).toLowerCase();
    const found = this.things.filter((body) => words.every((word) => named(body).includes(word)) &&
      (words.length || !this.view.room || body.userData.room === this.view.room));
    byId("found").replaceChildren(...found.slice(0, MOST).map((body) => {
      const id = body.userData.id || body.name;
      const button = element("button", { type: "button", value: id, textContent: spoken(id) });
      button.onclick = () => this.view.pick(body, true);
      return element("li", {}, button);
    }));
    const more = found.length > MOST ? `, the first ${MOST} are listed` : "";
    byId("count").textContent = `${found.length} ${found.length === 1 ? "thing" : "things"}${more}`;
  }

  // What is known of the thing that is chosen, with a slider for each part that moves.
  show(body) {
    byId("card").hidden = !body;
    if (!body) return;
    const { id, category, room, asset } = body.userData;
    const fact = this.facts.get(id) || { about: [], why: [] };
    byId("name").textContent = spoken(id || body.name);
    const size = fact.size ? fact.size.map((v) => (v * 100).toFixed(0)).join(" × ") + " cm (deep, wide, high)" : "";
    const rows = [["kind", spoken(category)], ["room", spoken(room || "")], ["size", size], ["asset", asset || ""],
      ...fact.about];
    byId("facts").replaceChildren(...rows.filter(([, value]) => value).flatMap(([name, value]) =>
      [element("dt", { textContent: name }), element("dd", { textContent: value })]));
    byId("why").replaceChildren(...fact.why.map((text) => element("li", { textContent: text })));
    byId("whyhead").hidden = !fact.why.length;
    this.#sliders(body);
  }

  #sliders(body) {
    this.sliders = this.home.partsOf(body).map((part) => {
      const { name, type, range } = part.joint;
      const unit = (share) => {
        const value = range[0] + (range[1] - range[0]) * share;
        return type === "hinge" ? `${((value * 180) / Math.PI).toFixed(0)}°` : `${(value * 100).toFixed(0)} cm`;
      };
      const slider = element("input", { type: "range", min: 0, max: 1, step: 0.01, value: part.share });
      const told = element("output", { textContent: unit(part.share) });
      slider.oninput = () => this.view.move(part, Number(slider.value));
      const update = () => {
        if (document.activeElement !== slider) slider.value = part.share;
        told.textContent = unit(part.share);
        slider.setAttribute("aria-valuetext", told.textContent);
      };
      update();
      return { node: element("label", {}, element("span", { textContent: spoken(name) }), slider, told), update };
    });
    byId("joints").replaceChildren(...this.sliders.map((slider) => slider.node));
  }

  update() {
    for (const slider of this.sliders || []) slider.update();
    for (const button of byId("rooms").children) button.ariaPressed = String(button.value === this.view.room);
    for (const name of Object.keys(LAYERS)) byId(`layer_${name}`).checked = this.view.layers.on(name);
    byId("walk").ariaPressed = String(this.view.walk.on);
    byId("stick").hidden = !this.view.walk.on;
    const { steps } = this.view;
    byId("step").value = steps.at;
    byId("stepped").textContent = `${steps.at} of ${steps.steps.length}: ${steps.words}`;
    byId("step").setAttribute("aria-valuetext", byId("stepped").textContent);
  }

  // What is under the pointer, told at the foot of the page.
  hover(object) {
    const [body, part] = [object && bodyOf(object), object && this.home.partOf(object)];
    const about = body ? [body.userData.id || body.name, part && `${part.joint.name}: click`] : [];
    byId("about").textContent = spoken(about.filter(Boolean).join(" · "));
    byId("view").style.cursor = part ? "pointer" : "default";
  }

  // Pixels that the panel takes away on the left, and below.
  get taken() {
    const box = byId("panel").getBoundingClientRect();
    if (box.right < innerWidth / 2) return [box.right, 0];
    return box.width > 0.9 * innerWidth && box.bottom > innerHeight - 2 ? [0, box.height] : [0, 0];
  }
}
