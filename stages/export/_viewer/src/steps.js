// The walkable stage as a timeline: where things stood after each of its steps, as boxes where they are no more.
import { BoxGeometry, Group, Mesh } from "three";
import { outline, placed, veil } from "./layers.js";

const COLOR = 0xc2255c;

export class Steps {
  constructor(home) {
    this.home = home;
    this.steps = home.facts.steps;
    this.at = this.steps.length;
    this.ghosts = new Group();
    home.plan.add(this.ghosts);
  }

  get last() {
    return this.at === this.steps.length;
  }

  // Shows the home after so many steps; at the last it is as it is.
  go(at) {
    this.at = Math.max(0, Math.min(at, this.steps.length));
    this.ghosts.clear();
    this.hidden = new Set();
    if (this.last) return;
    const now = new Map();
    for (const step of this.steps) for (const shift of step.shifts) if (!now.has(shift.id)) now.set(shift.id, shift.before);
    for (const step of this.steps.slice(0, this.at)) for (const shift of step.shifts) now.set(shift.id, shift.after);
    for (const [id, place] of now) {
      const thing = this.home.facts.things.find((one) => one.id === id);
      if (thing && place && same(thing, place)) continue;
      this.hidden.add(id);
      if (place) this.ghosts.add(ghost(place));
    }
    for (const thing of this.home.facts.things) if (thing.small) this.hidden.add(thing.id); // they come afterwards
    this.ghosts.updateMatrixWorld(true);
  }

  hides(id) {
    return !this.last && this.hidden.has(id);
  }

  get words() {
    const step = this.steps[this.at - 1];
    return step ? step.words : "as the rooms were furnished";
  }
}

function same(a, b) {
  const near = (p, q) => p.every((v, k) => Math.abs(v - q[k]) < 1e-6);
  return near(a.center, b.center) && near(a.size, b.size) && Math.abs(a.yaw - b.yaw) < 1e-6;
}

function ghost(place) {
  return placed(place).add(new Mesh(new BoxGeometry(...place.size), veil(COLOR, 0.3)), outline(place.size, COLOR));
}
