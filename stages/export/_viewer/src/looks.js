// Light and materials: plain ones for the first frame and for slow machines, fine ones where frames are quick.
import { ACESFilmicToneMapping, Color, DirectionalLight, HemisphereLight, MeshLambertMaterial, PCFShadowMap,
  PMREMGenerator, Scene, Vector3, WebGLRenderer } from "three";
import { RoomEnvironment } from "three/examples/jsm/environments/RoomEnvironment.js";

const SKY = 2.2; // light from above and below where nothing is mirrored
const ASKED = 4; // ms after which it is asked again whether a frame is drawn
const GROUND = { light: 0xe6eaee, dark: 0x1b1f24 };

export class Looks {
  constructor(canvas, home, cut) {
    this.renderer = new WebGLRenderer({ antialias: true, canvas, preserveDrawingBuffer: true });
    this.renderer.toneMapping = ACESFilmicToneMapping;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.shadowMap.autoUpdate = false;
    this.scene = new Scene();
    this.scene.add(home.scene, home.plan);
    this.fine = false;
    this.meshes = [];
    home.scene.traverse((node) => node.isMesh && this.meshes.push(node));
    const plain = new Map();
    for (const mesh of this.meshes) {
      cut.teach(mesh);
      mesh.userData.fine = mesh.material;
      if (!plain.has(mesh.material)) plain.set(mesh.material, plainOf(mesh.material));
      mesh.userData.plain = plain.get(mesh.material);
      mesh.material = mesh.userData.plain;
      mesh.castShadow = mesh.receiveShadow = !mesh.material.transparent;
    }
    for (const body of home.bodies) {
      if (body.userData.kind === "ceiling") body.traverse((child) => (child.castShadow = false));
    }
    this.sky = new HemisphereLight(0xffffff, 0xd8cdbd, SKY);
    this.sun = sunOver(home.bounds);
    this.scene.add(this.sky, this.sun, this.sun.target);
  }

  // Has all programs of what shows compiled side by side; the first frame would wait for one after another.
  prepare(camera) {
    this.renderer.compile(this.scene, camera);
  }

  refine() {
    this.fine = true;
    this.around ??= new PMREMGenerator(this.renderer).fromScene(new RoomEnvironment(), 0.04).texture;
    this.scene.environment = this.around;
    this.scene.environmentIntensity = 0.7;
    this.sky.intensity = 0;
    this.renderer.shadowMap.enabled = true;
    this.sun.castShadow = true;
    for (const mesh of this.meshes) mesh.material = mesh.userData.fine;
    this.cast();
  }

  coarsen() {
    this.fine = false;
    this.scene.environment = null;
    this.sky.intensity = SKY;
    this.renderer.shadowMap.enabled = this.sun.castShadow = false;
    for (const mesh of this.meshes) mesh.material = mesh.userData.plain;
  }

  // Done once all that was asked for is drawn: it is asked now and then, as waiting for a pixel would stall the page.
  drawn() {
    const gl = this.renderer.getContext();
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    return new Promise((done) => {
      const ask = () => {
        if (gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED) return setTimeout(ask, ASKED);
        gl.deleteSync(fence);
        done();
      };
      setTimeout(ask, 0);
    });
  }

  // Shadows are cast again when something has moved.
  cast() {
    this.renderer.shadowMap.needsUpdate = true;
  }

  theme(dark) {
    this.scene.background = new Color(dark ? GROUND.dark : GROUND.light);
  }
}

function plainOf(material) {
  const { color, map, transparent, opacity, side, alphaTest, depthWrite } = material;
  const found = new MeshLambertMaterial({ color, map, transparent, opacity, side, alphaTest, depthWrite });
  found.onBeforeCompile = material.onBeforeCompile;
  found.customProgramCacheKey = material.customProgramCacheKey;
  return found;
}

function sunOver(bounds) {
  const middle = bounds.getCenter(new Vector3());
  const reach = bounds.getSize(new Vector3()).length();
  const light = new DirectionalLight(0xfff2dd, 2.2);
  light.position.copy(middle).add(new Vector3(-0.35, 1, 0.3).multiplyScalar(reach));
  light.target.position.copy(middle);
  light.shadow.mapSize.set(2048, 2048);
  light.shadow.normalBias = 0.02;
  const half = reach / 2;
  Object.assign(light.shadow.camera, { left: -half, right: half, top: half, bottom: -half, near: 0.1, far: 2 * reach });
  return light;
}
