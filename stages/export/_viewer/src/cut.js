// Walls are cut away where floor of the home lies behind them, and are whole where they hide nothing.
import { BackSide, ClampToEdgeWrapping, DataTexture, Mesh, MeshBasicMaterial, NearestFilter, RedFormat, Vector2,
  Vector4 } from "three";

const KINDS = ["wall", "lining", "trim", "door", "window"];
const CLOTHS = ["curtain", "blind"];
const LEFT = 0.5; // m that are left of a wall
const CAP = 0x8b9096; // colour of what is cut through

export class Cut {
  constructor(home) {
    this.home = home;
    this.cells = home.facts.floor;
    this.data = new Uint8Array(this.cells.columns * this.cells.rows);
    this.mask = new DataTexture(this.data, this.cells.columns, this.cells.rows, RedFormat);
    this.mask.magFilter = this.mask.minFilter = NearestFilter;
    this.mask.wrapS = this.mask.wrapT = ClampToEdgeWrapping;
    this.mask.unpackAlignment = 1;
    const { x, y, cell, columns, rows } = this.cells;
    this.uniforms = {
      cutMask: { value: this.mask }, cutBox: { value: new Vector4(x, y, columns * cell, rows * cell) },
      cutAt: { value: new Vector2(LEFT, 0) },
    };
    this.caps = [];
    this.cut = new Set(home.bodies.filter(isCut));
    this.room("");
  }

  // Floor of one room, or of all, is what walls must not hide.
  room(name) {
    const index = this.cells.rooms.indexOf(name);
    let at = 0;
    for (const [room, length] of this.cells.runs) {
      const seen = room >= 0 && (index < 0 || room === index);
      this.data.fill(seen ? 255 : 0, at, at + length);
      at += length;
    }
    this.mask.needsUpdate = true;
  }

  set on(value) {
    this.uniforms.cutAt.value.y = value ? 1 : 0;
    for (const cap of this.caps) cap.visible = value;
  }

  get on() {
    return this.uniforms.cutAt.value.y === 1;
  }

  // Materials of what is cut, taught to leave out what hides floor.
  teach(mesh) {
    if (!this.cut.has(ownerOf(mesh))) return;
    mesh.material = this.taught(mesh.material);
  }

  taught(material) {
    const own = (this.known ??= new Map());
    if (own.has(material)) return own.get(material);
    const copy = material.clone();
    copy.onBeforeCompile = (shader) => this.#write(shader);
    copy.customProgramCacheKey = () => "cut";
    own.set(material, copy);
    own.set(copy, copy);
    return copy;
  }

  #write(shader) {
    Object.assign(shader.uniforms, this.uniforms);
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", "#include <common>\nvarying vec3 vCut;")
      .replace("#include <project_vertex>",
        "#include <project_vertex>\nvCut = (modelMatrix * vec4(transformed, 1.0)).xyz;");
    shader.fragmentShader = shader.fragmentShader
      .replace("#include <common>", `#include <common>
        varying vec3 vCut; uniform sampler2D cutMask; uniform vec4 cutBox; uniform vec2 cutAt;`)
      .replace("#include <clipping_planes_fragment>", `#include <clipping_planes_fragment>
        if (cutAt.y > 0.0 && vCut.y > cutAt.x && cameraPosition.y > vCut.y) {
          vec3 down = vCut - cameraPosition;
          vec3 floorAt = cameraPosition + down * cameraPosition.y / (cameraPosition.y - vCut.y);
          vec2 uv = (vec2(floorAt.x, -floorAt.z) - cutBox.xy) / cutBox.zw;
          bool inside = uv.x > 0.0 && uv.y > 0.0 && uv.x < 1.0 && uv.y < 1.0;
          if (inside && texture2D(cutMask, uv).r > 0.5) discard;
        }`);
  }

  // What one sees where a wall is cut through: its own back faces in one colour.
  addCaps() {
    const material = this.taught(new MeshBasicMaterial({
      color: CAP, side: BackSide, polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2 }));
    for (const body of this.cut) {
      if (body.userData.kind !== "wall") continue;
      body.traverse((node) => {
        if (!node.isMesh || node.userData.cap) return;
        const cap = new Mesh(node.geometry, material);
        cap.userData.cap = true;
        cap.raycast = () => {};
        this.caps.push(cap);
      });
    }
    for (const cap of this.caps) this.home.scene.getObjectByName("walls")?.add(cap);
    this.caps.forEach((cap) => cap.updateMatrixWorld());
  }

  // Whether a point of a wall is not there to be met by a ray from the eye.
  away(body, point, eye) {
    if (!this.on || !this.cut.has(body) || point.y <= LEFT || eye.y <= point.y) return false;
    const t = eye.y / (eye.y - point.y);
    return this.floorAt(eye.x + (point.x - eye.x) * t, -(eye.z + (point.z - eye.z) * t));
  }

  floorAt(x, y) {
    const { columns, rows, cell } = this.cells;
    const [column, row] = [Math.floor((x - this.cells.x) / cell), Math.floor((y - this.cells.y) / cell)];
    return column >= 0 && row >= 0 && column < columns && row < rows && this.data[row * columns + column] > 0;
  }
}

function isCut(body) {
  return KINDS.includes(body.userData.kind) || CLOTHS.includes(body.userData.category);
}

function ownerOf(mesh) {
  let node = mesh;
  while (node && !node.userData.kind) node = node.parent;
  return node;
}
