// What colours of swimmers say. Scales that colour-blind eyes can tell: Okabe and Ito's colours, viridis, and for phases a
// circle whose lightness goes up and down.

import { cycleAt, tilt } from "./motion";
import type { CycleTable, Scene } from "./scene";

export type Colour = [number, number, number]; // red, green, blue from 0 to 1

const fromHex = (hex: string): Colour => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255) as Colour;
export const toCss = (colour: Colour) => `rgb(${colour.map((part) => Math.round(255 * part)).join(" ")})`;

export const categories = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#f0e442"].map(fromHex);
const sequential = ["#440154", "#482878", "#3e4989", "#31688e", "#26828e", "#1f9e89", "#35b779", "#6ece58", "#b5de2b", "#fde725"].map(fromHex);
const diverging = ["#0072b2", "#7fb6d8", "#c8c8c8", "#e9ab7c", "#d55e00"].map(fromHex);
const cyclic = ["#2d1e6b", "#2f6db0", "#8fc3cf", "#f2ead8", "#dfa16b", "#a63c46", "#2d1e6b"].map(fromHex);
const unknown: Colour = [0.55, 0.55, 0.55];

/** The colour at a place from 0 to 1 along the stops. */
export function along(stops: Colour[], place: number): Colour {
  if (!Number.isFinite(place)) return unknown;
  const at = Math.min(Math.max(place, 0), 1) * (stops.length - 1);
  const left = Math.min(Math.floor(at), stops.length - 2), share = at - left;
  return stops[left].map((part, i) => part + share * (stops[left + 1][i] - part)) as Colour;
}

export interface Colouring {
  title: string;
  keys: { name: string; colour: Colour }[]; // of categories
  stops: Colour[]; // of a scale; empty for categories
  ends: [string, string]; // what a scale's ends stand for
  /** Of each swimmer at a frame. */
  colours(frame: number): Colour[];
}

export const colourings = ["block", "velocity", "orientation", "phase"] as const;
export type ColouringName = (typeof colourings)[number];

/** Why these colours cannot be had of this run; empty if they can. */
export function reasonAgainst(scene: Scene, name: ColouringName): string {
  const needsCycle = name === "velocity" || name === "phase";
  return needsCycle && scene.cycleTimes.length === 0 ? "the run ended no cycle" : "";
}

function byBlock(scene: Scene): Colouring {
  const colour = (block: number) => categories[block % categories.length];
  const colours = scene.blocks.map(colour);
  const numbers = [...new Set(scene.blocks)].sort((a, b) => a - b).slice(0, categories.length);
  const keys = numbers.length > 1 ? numbers.map((block) => ({ name: `block ${block}`, colour: colour(block) })) : [];
  return { title: "Blocks", keys, stops: [], ends: ["", ""], colours: () => colours };
}

function extent(numbers: Iterable<number>): [number, number] {
  let low = Infinity, high = -Infinity;
  for (const number of numbers) {
    if (number < low) low = number;
    if (number > high) high = number;
  }
  return low <= high ? [low, high] : [0, 0];
}

function* cycleNumbers(scene: Scene, table: CycleTable): Generator<number> {
  for (let cycle = 0; cycle < scene.cycleTimes.length; ++cycle) {
    for (let s = 0; s < scene.ids.length; ++s) yield table.at(cycle, s);
  }
}

/** A number of the cycle that a frame is in, on a scale. */
function byCycle(scene: Scene, table: CycleTable, place: (number: number) => number, stops: Colour[]): Colouring["colours"] {
  return (frame) => {
    const cycle = cycleAt(scene, scene.times[frame]) ?? 0;
    return scene.ids.map((_, s) => along(stops, place(table.at(cycle, s))));
  };
}

function byVelocity(scene: Scene): Colouring {
  let [low, high] = extent(cycleNumbers(scene, scene.velocity));
  const signed = low < 0 && high > 0;
  if (signed) [low, high] = [-Math.max(-low, high), Math.max(-low, high)];
  const stops = signed ? diverging : sequential;
  const place = (v: number) => (high > low ? (v - low) / (high - low) : 0.5);
  return { title: `Velocity along the axis, by cycle (${scene.velocityUnit})`, keys: [], stops, ends: [low.toPrecision(3), high.toPrecision(3)],
    colours: byCycle(scene, scene.velocity, place, stops) };
}

function byOrientation(scene: Scene): Colouring {
  const sampled = scene.frames.map((_, f) => f).filter((f) => f % Math.ceil(scene.frames.length / 20) === 0 || f === scene.frames.length - 1);
  const [low, high] = extent(sampled.flatMap((f) => scene.ids.map((_, s) => tilt(scene, s, f))));
  const range = Math.max(high - low, 1e-3); // less is the rounding of positions
  return { title: "Angle from axis to x", keys: [], stops: sequential, ends: [`${low.toPrecision(3)}°`, `${(low + range).toPrecision(3)}°`],
    colours: (frame) => scene.ids.map((_, s) => along(sequential, (tilt(scene, s, frame) - low) / range)) };
}

function byPhase(scene: Scene): Colouring {
  const place = (phase: number) => phase / (2 * Math.PI) + 0.5;
  return { title: "Phase of arm 1, by cycle (radians)", keys: [], stops: cyclic, ends: ["−π", "π"], colours: byCycle(scene, scene.phases[0], place, cyclic) };
}

export function colouring(scene: Scene, name: ColouringName): Colouring {
  switch (name) {
    case "block": return byBlock(scene);
    case "velocity": return byVelocity(scene);
    case "orientation": return byOrientation(scene);
    case "phase": return byPhase(scene);
  }
}
