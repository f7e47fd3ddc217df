// Positions of beads, and quantities that follow from them. A frame position is a time, given as the index of a frame; between
// two frames it has a fractional part, and bead positions are interpolated linearly.

import type { Scene } from "./scene";

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
  for (let i = 0; i < positions.length; ++i) {
    const steps = now[i] + fraction * (next[i] - now[i]);
    positions[i] = scene.start[i] + steps * scene.step[(i / 9) | 0];
  }
}

/** Shifts each swimmer by multiples of the box lengths along periodic axes, so that its middle bead lies in the box. */
export function wrap(scene: Scene, positions: Float32Array): void {
  const { box, periodic } = scene;
  if (!box) return;
  for (let swimmer = 0; swimmer < positions.length; swimmer += 9) {
    for (let a = 0; a < 3; ++a) {
      if (!periodic[a]) continue;
      const shift = box[a] * Math.floor(positions[swimmer + 3 + a] / box[a]);
      if (shift !== 0) for (let b = 0; b < 9; b += 3) positions[swimmer + b + a] -= shift;
    }
  }
}

/** Returns the unwrapped positions of the three beads of a swimmer in a frame. */
export function beadsAt(scene: Scene, swimmer: number, frame: number): [Point, Point, Point] {
  const coordinate = (i: number) => scene.start[i] + scene.frames[frame][i] * scene.step[swimmer];
  const bead = (b: number): Point => {
    const i = 9 * swimmer + 3 * b;
    return [coordinate(i), coordinate(i + 1), coordinate(i + 2)];
  };
  return [bead(0), bead(1), bead(2)];
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

/** Returns the angle between the axis of a swimmer, from bead 1 to bead 3, and the x axis [degrees]. */
export function axisAngle(scene: Scene, swimmer: number, frame: number): number {
  const [first, , last] = beadsAt(scene, swimmer, frame);
  return angle(minus(last, first), [1, 0, 0]);
}

/** Motion of one swimmer; each array has one value per frame. */
export interface Series {
  along: number[]; // displacement of the mean bead position along the axis of the first frame [length]
  across: number[]; // displacement of the mean bead position perpendicular to that axis [length]
  arms: [number[], number[]]; // arm lengths [length]
  turning: number[]; // angle between the axis and the axis of the first frame [degrees]
  bend: number[]; // angle between the two arms [degrees]
}

export function makeSeries(scene: Scene, swimmer: number): Series {
  const series: Series = { along: [], across: [], arms: [[], []], turning: [], bend: [] };
  const mean = (beads: Point[]): Point => [0, 1, 2].map((a) => (beads[0][a] + beads[1][a] + beads[2][a]) / 3) as Point;
  const atStart = beadsAt(scene, swimmer, 0);
  const axis = unit(minus(atStart[2], atStart[0])), origin = mean(atStart);
  for (let frame = 0; frame < scene.frames.length; ++frame) {
    const beads = beadsAt(scene, swimmer, frame);
    const moved = minus(mean(beads), origin), along = dot(moved, axis);
    const arm1 = minus(beads[1], beads[0]), arm2 = minus(beads[2], beads[1]);
    series.along.push(along);
    series.across.push(length(minus(moved, [along * axis[0], along * axis[1], along * axis[2]])));
    series.arms[0].push(length(arm1));
    series.arms[1].push(length(arm2));
    series.turning.push(angle(minus(beads[2], beads[0]), axis));
    series.bend.push(angle(arm1, arm2));
  }
  return series;
}

/** Returns the index of the base cycle that contains a time [periods]; after the last complete cycle, its index; null without any. */
export function cycleAt(scene: Scene, time: number): number | null {
  if (scene.cycleTimes.length === 0) return null;
  const ended = scene.cycleTimes.findIndex((end) => time <= end + 1e-9);
  return ended < 0 ? scene.cycleTimes.length - 1 : ended;
}
