// Positions of beads, and quantities that follow from them. A frame position is a time, given as the index of a frame; between
// two frames it has a fractional part, and bead positions are interpolated linearly.

import { middleBead, type Scene } from "./scene";

export type Point = [number, number, number];

const frameBefore = (scene: Scene, framePosition: number) => Math.min(Math.floor(framePosition), scene.frames.length - 1);

/** Returns the time of a frame position (fractional index of a frame) [periods]. */
export function timeAt(scene: Scene, framePosition: number): number {
  const frame = frameBefore(scene, framePosition);
  const next = Math.min(frame + 1, scene.frames.length - 1);
  return scene.times[frame] + (framePosition - frame) * (scene.times[next] - scene.times[frame]);
}

/** Returns the frame position (fractional index of a frame) of a time [periods]; the first or last frame outside the run. */
export function framePositionAt(scene: Scene, time: number): number {
  const last = scene.times.length - 1;
  if (last === 0 || time <= scene.times[0]) return 0;
  if (time >= scene.times[last]) return last;
  let low = 0, high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (scene.times[middle] <= time) low = middle;
    else high = middle;
  }
  return low + (time - scene.times[low]) / (scene.times[high] - scene.times[low]);
}

/** Returns true if the run has at least eight frames per period. Positions may then be interpolated between frames. */
export function isSmooth(scene: Scene): boolean {
  const last = scene.times.length - 1;
  return last > 0 && (scene.times[last] - scene.times[0]) / last <= 1 / 8 + 1e-9;
}

/** Writes the unwrapped coordinates x, y, z of all beads at a frame position to `positions`. */
export function positionsAt(scene: Scene, framePosition: number, positions: Float32Array): void {
  const frame = frameBefore(scene, framePosition);
  const now = scene.frames[frame], next = scene.frames[Math.min(frame + 1, scene.frames.length - 1)];
  const fraction = framePosition - frame;
  for (let swimmer = 0; swimmer < scene.ids.length; ++swimmer) {
    const step = scene.step[swimmer], end = 3 * scene.firstBead[swimmer + 1];
    for (let i = 3 * scene.firstBead[swimmer]; i < end; ++i) {
      positions[i] = scene.start[i] + (now[i] + fraction * (next[i] - now[i])) * step;
    }
  }
}

/** Shifts each swimmer by multiples of the box lengths along periodic axes, so that its middle bead lies in the box. */
export function wrap(scene: Scene, positions: Float32Array): void {
  const { box, periodic } = scene;
  if (!box) return;
  scene.shapes.forEach((shape, swimmer) => {
    const first = scene.firstBead[swimmer];
    for (let a = 0; a < 3; ++a) {
      if (!periodic[a]) continue;
      const shift = box[a] * Math.floor(positions[3 * (first + middleBead(shape)) + a] / box[a]);
      if (shift !== 0) for (let b = 0; b < shape.beads; ++b) positions[3 * (first + b) + a] -= shift;
    }
  });
}

/** Returns the unwrapped positions of the beads of a swimmer in a frame. */
export function beadsAt(scene: Scene, swimmer: number, frame: number): Point[] {
  const coordinate = (i: number) => scene.start[i] + scene.frames[frame][i] * scene.step[swimmer];
  const beads: Point[] = [];
  for (let b = scene.firstBead[swimmer]; b < scene.firstBead[swimmer + 1]; ++b) {
    beads.push([coordinate(3 * b), coordinate(3 * b + 1), coordinate(3 * b + 2)]);
  }
  return beads;
}

const minus = (p: Point, q: Point): Point => [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
const dot = (p: Point, q: Point) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
const length = (p: Point) => Math.sqrt(dot(p, p));

function unit(p: Point): Point {
  const size = length(p) || 1;
  return [p[0] / size, p[1] / size, p[2] / size];
}

/** Returns the angle between two directions [degrees] by a formula that is accurate also for small angles. */
function angle(p: Point, q: Point): number {
  const across = minus(unit(p), unit(q));
  const along = [p, q].map(unit).reduce((a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]] as Point);
  return (2 * Math.atan2(length(across), length(along)) * 180) / Math.PI;
}

/** Returns the angle between the axis of a swimmer, along its line of beads, and the x axis [degrees]; NaN for other shapes. */
export function axisAngle(scene: Scene, swimmer: number, frame: number): number {
  const { line } = scene.shapes[swimmer];
  if (!line) return NaN;
  const beads = beadsAt(scene, swimmer, frame);
  return angle(minus(beads[line[1]], beads[line[0]]), [1, 0, 0]);
}

/** Motion of one swimmer; each array of numbers has one value per frame. */
export interface Series {
  arms: number[][]; // length of each bond [length]
  angles: number[][]; // angle of each angular spring; 0 for three beads in line [degrees]
  distance: number[]; // displacement of the mean bead position from the first frame [length]
  axis: AxisSeries | null; // null if the beads are not in line at rest
}

/** Motion relative to the axis of a swimmer. */
export interface AxisSeries {
  along: number[]; // displacement of the mean bead position along the axis of the first frame [length]
  across: number[]; // displacement of the mean bead position perpendicular to that axis [length]
  turning: number[]; // angle between the axis and the axis of the first frame [degrees]
}

export function makeSeries(scene: Scene, swimmer: number): Series {
  const { bonds, angles, line } = scene.shapes[swimmer];
  const frames = scene.frames.map((_, frame) => beadsAt(scene, swimmer, frame));
  const mean = (beads: Point[]): Point => [0, 1, 2].map((a) => beads.reduce((sum, bead) => sum + bead[a], 0) / beads.length) as Point;
  const origin = mean(frames[0]), displacements = frames.map((beads) => minus(mean(beads), origin));
  return {
    arms: bonds.map(([i, j]) => frames.map((beads) => length(minus(beads[j], beads[i])))),
    angles: angles.map(([i, j, k]) => frames.map((beads) => angle(minus(beads[j], beads[i]), minus(beads[k], beads[j])))),
    distance: displacements.map(length),
    axis: line && axisSeries(frames.map((beads) => minus(beads[line[1]], beads[line[0]])), displacements),
  };
}

function axisSeries(axes: Point[], displacements: Point[]): AxisSeries {
  const axis = unit(axes[0]);
  const along = displacements.map((moved) => dot(moved, axis));
  return {
    along,
    across: displacements.map((moved, frame) => length(minus(moved, axis.map((x) => along[frame] * x) as Point))),
    turning: axes.map((now) => angle(now, axis)),
  };
}

/** Returns the index of the base cycle that contains a time [periods]; after the last complete cycle, its index; null without any. */
export function cycleAt(scene: Scene, time: number): number | null {
  if (scene.cycleTimes.length === 0) return null;
  const ended = scene.cycleTimes.findIndex((end) => time <= end + 1e-9);
  return ended < 0 ? scene.cycleTimes.length - 1 : ended;
}
