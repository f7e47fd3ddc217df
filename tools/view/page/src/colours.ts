// Colours of swimmers by block, velocity, orientation or phase. People with colour blindness can distinguish them: blocks have
// the colours of Okabe and Ito, scales are viridis or blue to orange, and phases have a cyclic scale whose lightness rises and falls.

import { cycleAt, axisAngle } from "./motion";
import type { CycleTable, Scene } from "./scene";

export type Colour = [number, number, number]; // red, green, blue from 0 to 1

const fromHex = (hex: string): Colour => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255) as Colour;
export const toCss = (colour: Colour) => `rgb(${colour.map((part) => Math.round(255 * part)).join(" ")})`;

export const categories = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#f0e442"].map(fromHex);
export const sequential = ["#440154", "#482878", "#3e4989", "#31688e", "#26828e", "#1f9e89", "#35b779", "#6ece58", "#b5de2b", "#fde725"].map(fromHex);
const diverging = ["#0072b2", "#7fb6d8", "#c8c8c8", "#e9ab7c", "#d55e00"].map(fromHex);
const cyclic = ["#2d1e6b", "#2f6db0", "#8fc3cf", "#f2ead8", "#dfa16b", "#a63c46", "#2d1e6b"].map(fromHex);
const unknown: Colour = [0.55, 0.55, 0.55];

/** Returns the colour at a position from 0 to 1 on the colour scale `stops`; grey if the position is not finite. */
export function interpolate(stops: Colour[], position: number): Colour {
  if (!Number.isFinite(position)) return unknown;
  const scaled = Math.min(Math.max(position, 0), 1) * (stops.length - 1);
  const left = Math.min(Math.floor(scaled), stops.length - 2), fraction = scaled - left;
  return stops[left].map((part, i) => part + fraction * (stops[left + 1][i] - part)) as Colour;
}

export interface Colouring {
  title: string;
  keys: { name: string; colour: Colour }[]; // legend, one entry per category; empty for a scale
  stops: Colour[]; // equally spaced colours of the scale; empty for categories
  ends: [string, string]; // values at the two ends of the scale
  /** Returns the colour of each swimmer in a frame. */
  colours(frame: number): Colour[];
}

export const colourings = ["block", "velocity", "orientation", "phase"] as const;
export type ColouringName = (typeof colourings)[number];

/** Returns the reason why the run has no data for this colouring; an empty text if the run has the data. */
export function unavailableReason(scene: Scene, name: ColouringName): string {
  const needsCycle = name === "velocity" || name === "phase";
  if (needsCycle && scene.cycleTimes.length === 0) return "the run ended no cycle";
  if (name === "phase" && scene.shapes.every(({ bonds }) => bonds.length === 0)) return "no arms";
  if (name === "orientation" && scene.shapes.every(({ line }) => line === null)) return "no beads in line";
  return "";
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
    for (let s = 0; s < scene.ids.length; ++s) yield table.value(cycle, s);
  }
}

/** Colours each swimmer by its position on a scale from 0 to 1 in the cycle that contains the frame. */
function byCycle(scene: Scene, position: (cycle: number, swimmer: number) => number, stops: Colour[]): Colouring["colours"] {
  return (frame) => {
    const cycle = cycleAt(scene, scene.times[frame]) ?? 0;
    return scene.ids.map((_, s) => interpolate(stops, position(cycle, s)));
  };
}

function byVelocity(scene: Scene): Colouring {
  let [low, high] = extent(cycleNumbers(scene, scene.velocity));
  const signed = low < 0 && high > 0;
  if (signed) [low, high] = [-Math.max(-low, high), Math.max(-low, high)];
  const stops = signed ? diverging : sequential;
  const position = (cycle: number, s: number) => (high > low ? (scene.velocity.value(cycle, s) - low) / (high - low) : 0.5);
  return { title: `Velocity along the axis, by cycle (${scene.velocityUnit})`, keys: [], stops, ends: [low.toPrecision(3), high.toPrecision(3)],
    colours: byCycle(scene, position, stops) };
}

function byOrientation(scene: Scene): Colouring {
  const sampled = scene.frames.map((_, f) => f).filter((f) => f % Math.ceil(scene.frames.length / 20) === 0 || f === scene.frames.length - 1);
  const [low, high] = extent(sampled.flatMap((f) => scene.ids.map((_, s) => axisAngle(scene, s, f))));
  const range = Math.max(high - low, 1e-3); // smaller ranges could be rounding errors of positions
  return { title: "Angle from axis to x", keys: [], stops: sequential, ends: [`${low.toPrecision(3)}°`, `${(low + range).toPrecision(3)}°`],
    colours: (frame) => scene.ids.map((_, s) => interpolate(sequential, (axisAngle(scene, s, frame) - low) / range)) };
}

function byPhase(scene: Scene): Colouring {
  const hasArm = scene.shapes.map(({ bonds }) => bonds.length > 0);
  const position = (cycle: number, s: number) => (hasArm[s] ? scene.phases.value(cycle, scene.firstBond[s]) / (2 * Math.PI) + 0.5 : NaN);
  return { title: "Phase of arm 1, by cycle (radians)", keys: [], stops: cyclic, ends: ["−π", "π"], colours: byCycle(scene, position, cyclic) };
}

export function colouring(scene: Scene, name: ColouringName): Colouring {
  switch (name) {
    case "block": return byBlock(scene);
    case "velocity": return byVelocity(scene);
    case "orientation": return byOrientation(scene);
    case "phase": return byPhase(scene);
  }
}

/** Returns the value of a variable of style.css, such as --paper. */
export const cssVariable = (name: string) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
