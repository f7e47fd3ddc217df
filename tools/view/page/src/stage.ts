// Draws the swarm in three dimensions, with z upwards, as in the figures of beadswim-plot. Draws only after a change.

import * as three from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { cssVariable, type Colour } from "./colours";
import { flowArrows } from "./flow";
import type { Point } from "./motion";
import { PageFault, type Scene } from "./scene";
import { beadFragment, beadVertex, springFragment, springVertex } from "./shaders";
import { drawTriad, triadSize } from "./triad";

export type View = "all" | "x" | "y" | "z";

const directions: Record<View, Point> = { all: [0.45, -1, 0.42], x: [1, 0, 0], y: [0, -1, 0], z: [0, 0, 1] };

function renderer(canvas: HTMLCanvasElement): three.WebGLRenderer {
  try {
    return new three.WebGLRenderer({ canvas, antialias: true, alpha: true });
  } catch {
    throw new PageFault("This browser gives no WebGL 2, which the picture is drawn with. Switch on hardware acceleration, or try another browser.");
  }
}

/** Returns a square from -1 to 1 that is drawn once per instance. */
function square(): three.InstancedBufferGeometry {
  const geometry = new three.InstancedBufferGeometry();
  const corners = new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]);
  geometry.setAttribute("position", new three.BufferAttribute(corners, 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  return geometry;
}

export class Stage {
  /** Coordinates x, y, z of each bead [length]. After changing them, call updatePositions(). */
  readonly positions: Float32Array;
  onPick: (swimmer: number | null) => void = () => {};

  private readonly renderer: three.WebGLRenderer;
  private readonly world = new three.Scene();
  private readonly camera = new three.PerspectiveCamera(35, 1, 1, 10);
  private readonly controls: OrbitControls;
  private readonly swimmerOf: Float32Array; // index of the swimmer of each bead
  private readonly bonds: Uint32Array; // indices of the two beads of each bond
  private readonly centres: three.InstancedBufferAttribute; // refers to `positions`
  private readonly bondEnds: three.InstancedInterleavedBuffer; // coordinates of the two beads of each bond
  private readonly colours: three.InstancedBufferAttribute; // one per bead
  private readonly picked = { value: -1 };
  private readonly path: three.Line;
  private readonly arrows: three.Mesh | null; // of the flow
  private readonly sceneSize: number; // length of the diagonal of boundary()
  private readonly triad: CanvasRenderingContext2D;
  private drawRequested = false;

  /** `triad`: canvas for the triad of axes. */
  constructor(private readonly canvas: HTMLCanvasElement, private readonly scene: Scene, triad: HTMLCanvasElement) {
    this.renderer = renderer(canvas);
    this.triad = triad.getContext("2d")!;
    triad.style.width = triad.style.height = `${triadSize}px`;
    this.positions = new Float32Array(scene.start);
    this.swimmerOf = Float32Array.from(scene.shapes.flatMap((shape, s) => Array<number>(shape.beads).fill(s)));
    this.bonds = Uint32Array.from(scene.shapes.flatMap((shape, s) => shape.bonds.flat().map((bead) => scene.firstBead[s] + bead)));
    this.centres = new three.InstancedBufferAttribute(this.positions, 3);
    this.centres.setUsage(three.DynamicDrawUsage);
    this.bondEnds = new three.InstancedInterleavedBuffer(new Float32Array(3 * this.bonds.length), 6);
    this.bondEnds.setUsage(three.DynamicDrawUsage);
    this.colours = new three.InstancedBufferAttribute(new Float32Array(this.positions.length), 3);
    this.sceneSize = this.boundary().getSize(new three.Vector3()).length();
    this.addSwimmers();
    this.addBox();
    this.addWalls();
    this.arrows = scene.flow && flowArrows(scene.flow);
    if (this.arrows) this.world.add(this.arrows);
    this.path = new three.Line(new three.BufferGeometry(), new three.LineBasicMaterial({ color: 0xdb0080 }));
    this.path.frustumCulled = false;
    this.world.add(this.path);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.draw());
    this.addListeners();
    this.setView("all");
  }

  /** Draws all beads again, after `positions` has been changed. */
  updatePositions(): void {
    const { bonds, positions, bondEnds } = this;
    for (let end = 0; end < bonds.length; ++end) {
      for (let a = 0; a < 3; ++a) bondEnds.array[3 * end + a] = positions[3 * bonds[end] + a];
    }
    this.centres.needsUpdate = bondEnds.needsUpdate = true;
    this.draw();
  }

  /** Sets the colour of each swimmer. */
  paint(colours: Colour[]): void {
    this.swimmerOf.forEach((swimmer, bead) => this.colours.setXYZ(bead, ...colours[swimmer]));
    this.colours.needsUpdate = true;
    this.draw();
  }

  /** Marks the selected swimmer and draws its path; `swimmer`: index, or null to mark none. */
  mark(swimmer: number | null, path: Point[]): void {
    this.picked.value = swimmer ?? -1;
    this.path.geometry.dispose();
    this.path.geometry = new three.BufferGeometry().setFromPoints(path.map((p) => new three.Vector3(...p)));
    this.draw();
  }

  /** Shifts the path of the selected swimmer, by multiples of the box lengths, to the periodic image of the swimmer in the view. */
  shiftPath(shift: Point): void {
    this.path.position.set(...shift);
  }

  /** Moves the camera such that `position` is in the centre of the view. */
  follow(position: Point): void {
    const shift = new three.Vector3(...position).sub(this.controls.target);
    this.camera.position.add(shift);
    this.controls.target.add(shift);
    this.setClipRange();
    this.draw();
  }

  /** Shows or hides the arrows of the flow. */
  showFlow(isShown: boolean): void {
    if (this.arrows) this.arrows.visible = isShown;
    this.draw();
  }

  setView(view: View): void {
    const boundary = this.boundary(), middle = boundary.getCenter(new three.Vector3());
    const direction = new three.Vector3(...directions[view]).normalize();
    // For a view exactly along z, the upward direction of the picture would be undefined.
    if (view === "z") direction.add(new three.Vector3(0, -1e-4, 0));
    this.controls.target.copy(middle);
    this.camera.position.copy(middle).addScaledVector(direction, 1);
    this.camera.lookAt(middle);
    this.camera.updateMatrixWorld();
    this.camera.position.copy(middle).addScaledVector(direction, this.cameraDistance(boundary));
    this.setClipRange();
    this.controls.update();
    this.draw();
  }

  turn(azimuthChange: number, elevationChange: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const length = offset.length();
    const azimuth = Math.atan2(offset.y, offset.x) + azimuthChange;
    const height = Math.min(Math.max(Math.asin(offset.z / length) + elevationChange, -1.57), 1.57);
    offset.set(Math.cos(height) * Math.cos(azimuth), Math.cos(height) * Math.sin(azimuth), Math.sin(height));
    this.camera.position.copy(this.controls.target).addScaledVector(offset, length);
    this.controls.update();
    this.draw();
  }

  zoom(factor: number): void {
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.controls.update();
    this.draw();
  }

  /** Requests a drawing at the browser's next animation frame. Several calls before this frame result in one drawing. */
  draw(): void {
    if (this.drawRequested) return;
    this.drawRequested = true;
    requestAnimationFrame(() => {
      this.drawRequested = false;
      this.render();
    });
  }

  /** Returns the view as a picture (PNG), with the triad of axes, on the background of the page. */
  picture(): Promise<Blob | null> {
    const paper = cssVariable("--paper");
    this.render(); // the browser keeps the drawing only until the next frame
    const { width, height } = this.canvas, zoom = this.renderer.getPixelRatio();
    const copy = Object.assign(document.createElement("canvas"), { width, height }), context = copy.getContext("2d")!;
    context.fillStyle = paper;
    context.fillRect(0, 0, width, height);
    context.drawImage(this.canvas, 0, 0);
    context.scale(zoom, zoom);
    drawTriad(context, this.axisDirections(), width / zoom - triadSize / 2, height / zoom - triadSize / 2, paper);
    return new Promise((done) => copy.toBlob(done, "image/png"));
  }

  private render(): void {
    this.fitToCanvas();
    this.setClipRange();
    this.renderer.render(this.world, this.camera);
    const { canvas } = this.triad, zoom = this.renderer.getPixelRatio();
    canvas.width = canvas.height = triadSize * zoom; // clears it
    this.triad.scale(zoom, zoom);
    drawTriad(this.triad, this.axisDirections(), triadSize / 2, triadSize / 2, cssVariable("--paper"));
  }

  /** Returns the directions of x, y and z in the frame of the camera: right, up, to the eye. */
  private axisDirections(): Point[] {
    const toCamera = this.camera.quaternion.clone().invert();
    return [0, 1, 2].map((a) => new three.Vector3().setComponent(a, 1).applyQuaternion(toCamera).toArray() as Point);
  }

  private addSwimmers(): void {
    const { radius } = this.scene;
    const material = (vertexShader: string, fragmentShader: string) =>
      new three.RawShaderMaterial({ glslVersion: three.GLSL3, vertexShader, fragmentShader, uniforms: { picked: this.picked }, side: three.DoubleSide });
    const add = (shader: three.RawShaderMaterial, count: number, attributes: Record<string, three.BufferAttribute | three.InterleavedBufferAttribute>) => {
      const geometry = square();
      for (const [name, attribute] of Object.entries(attributes)) geometry.setAttribute(name, attribute);
      geometry.instanceCount = count;
      const mesh = new three.Mesh(geometry, shader);
      mesh.frustumCulled = false;
      this.world.add(mesh);
    };
    const perInstance = (numbers: Float32Array) => new three.InstancedBufferAttribute(numbers, 1);
    add(material(beadVertex, beadFragment), radius.length,
      { centre: this.centres, radius: perInstance(radius), swimmer: perInstance(this.swimmerOf), colour: this.colours });
    const bonds = this.bonds.length / 2, end = (n: number) => new three.InterleavedBufferAttribute(this.bondEnds, 3, 3 * n);
    const bondRadii = Float32Array.from({ length: bonds }, (_, bond) => radius[this.bonds[2 * bond]]); // of the first beads
    if (bonds > 0) add(material(springVertex, springFragment), bonds, { from: end(0), to: end(1), radius: perInstance(bondRadii) });
  }

  private addBox(): void {
    const { box } = this.scene;
    if (!box) return;
    const edges = new three.EdgesGeometry(new three.BoxGeometry(box[0], box[1], box[2]));
    const lines = new three.LineSegments(edges, new three.LineBasicMaterial({ color: 0x8a94a3 }));
    lines.position.set(box[0] / 2, box[1] / 2, box[2] / 2);
    this.world.add(lines);
  }

  /** Draws each wall as a transparent plane, as large as the box; in a half-space, larger than the scene. */
  private addWalls(): void {
    const boundary = this.boundary(), middle = boundary.getCenter(new three.Vector3()), size = boundary.getSize(new three.Vector3());
    if (!this.scene.box) size.multiplyScalar(4);
    for (const { axis, at } of this.scene.walls) {
      const [across, up] = [(axis + 1) % 3, (axis + 2) % 3];
      const wall = new three.Mesh(new three.PlaneGeometry(size.getComponent(across), size.getComponent(up)),
        new three.MeshBasicMaterial({ color: 0x8a94a3, transparent: true, opacity: 0.25, side: three.DoubleSide, depthWrite: false }));
      const axes = [across, up, axis].map((a) => new three.Vector3().setComponent(a, 1));
      wall.quaternion.setFromRotationMatrix(new three.Matrix4().makeBasis(axes[0], axes[1], axes[2]));
      wall.position.copy(middle.clone().setComponent(axis, at));
      this.world.add(wall);
    }
  }

  /** Returns the box, or the bounding box of the beads, the flow and the wall of a half-space. */
  private boundary(): three.Box3 {
    const { box, flow } = this.scene;
    const boundary = new three.Box3();
    if (box) return boundary.set(new three.Vector3(), new three.Vector3(box[0], box[1], box[2]));
    boundary.setFromArray(Array.from(this.positions));
    boundary.expandByScalar(2 * this.scene.radius.reduce((a, b) => Math.max(a, b), 0));
    if (flow) boundary.union(new three.Box3().setFromArray(flow.places));
    for (const { axis, at } of this.scene.walls) boundary.min.setComponent(axis, at);
    return boundary;
  }

  /** Returns the distance from the centre at which the camera, with its present direction, sees all corners of `boundary`. */
  private cameraDistance(boundary: three.Box3): number {
    this.fitToCanvas();
    const middle = boundary.getCenter(new three.Vector3());
    const tangent = 0.94 * Math.tan((this.camera.fov / 2) * (Math.PI / 180));
    let distance = 0;
    for (let corner = 0; corner < 8; ++corner) {
      const cornerPosition = new three.Vector3(
        corner & 1 ? boundary.max.x : boundary.min.x, corner & 2 ? boundary.max.y : boundary.min.y, corner & 4 ? boundary.max.z : boundary.min.z);
      cornerPosition.sub(middle).applyQuaternion(this.camera.quaternion.clone().invert());
      distance = Math.max(distance, cornerPosition.z + Math.abs(cornerPosition.y) / tangent, cornerPosition.z + Math.abs(cornerPosition.x) / (tangent * this.camera.aspect));
    }
    return distance;
  }

  private fitToCanvas(): void {
    const width = this.canvas.clientWidth || 1, height = this.canvas.clientHeight || 1;
    const zoom = Math.min(window.devicePixelRatio, 2);
    const oldSize = this.renderer.getSize(new three.Vector2());
    if (oldSize.x === width && oldSize.y === height && this.renderer.getPixelRatio() === zoom) return;
    this.renderer.setPixelRatio(zoom);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
  }

  private setClipRange(): void {
    const distance = this.camera.position.distanceTo(this.controls.target);
    this.camera.near = Math.max(distance - 2 * this.sceneSize, 1e-3 * distance);
    this.camera.far = distance + 2 * this.sceneSize;
    this.camera.updateProjectionMatrix();
  }

  private addListeners(): void {
    let pressed: [number, number] | null = null;
    this.canvas.addEventListener("pointerdown", (event) => (pressed = [event.clientX, event.clientY]));
    this.canvas.addEventListener("pointerup", (event) => {
      const still = pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) < 5;
      if (still) this.onPick(this.swimmerAt(event.clientX, event.clientY));
    });
    new ResizeObserver(() => this.render()).observe(this.canvas); // before the browser shows the old picture, stretched
  }

  /** Returns the swimmer nearest to the camera with a bead within four pixels of a position in the window; null if there is none. */
  private swimmerAt(x: number, y: number): number | null {
    const frame = this.canvas.getBoundingClientRect();
    const ray = new three.Raycaster();
    ray.setFromCamera(new three.Vector2((2 * (x - frame.left)) / frame.width - 1, 1 - (2 * (y - frame.top)) / frame.height), this.camera);
    const { origin, direction } = ray.ray;
    const pixel = (2 * Math.tan((this.camera.fov / 2) * (Math.PI / 180))) / frame.height; // size of a pixel at distance 1
    let found: number | null = null, nearest = Infinity;
    const centre = new three.Vector3();
    for (let bead = 0; bead < this.scene.radius.length; ++bead) {
      centre.fromArray(this.positions, 3 * bead).sub(origin);
      const distance = centre.dot(direction);
      const pickRadius = Math.max(this.scene.radius[bead], 4 * pixel * distance);
      if (distance > 0 && distance < nearest && centre.addScaledVector(direction, -distance).length() <= pickRadius) {
        nearest = distance;
        found = this.swimmerOf[bead];
      }
    }
    return found;
  }
}
