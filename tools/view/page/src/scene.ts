// Reads the data of the run that beadswim-view has written into the page. tools/view/page_data.hpp describes the format.

/** Error with a message for the user: why the page cannot show the run, and what to do. */
export class PageFault extends Error {}

/** Table with one value per cycle and swimmer, or per cycle and bond; NaN if the swimmer has not completed a cycle yet. */
export interface CycleTable {
  value(cycle: number, column: number): number;
}

/** Shape of a swimmer. Its beads are numbered from 0. */
export interface Shape {
  beads: number; // number of beads
  bonds: [number, number][]; // the two beads of each bond
  angles: [number, number, number][]; // the three beads of each angular spring
  line: [number, number] | null; // the two end beads, along the axis; null if the beads are not in line at rest
}

/** Returns the number of the bead that stands for the position of a swimmer. */
export const middleBead = (shape: Shape) => shape.beads >> 1;

/** Flow of the fluid, as arrows on a regular grid. */
export interface Flow {
  spacing: number; // distance between neighbouring arrows along an axis [length]
  meanCycles: number | null; // cycles of a mean; null for the flow at one time
  places: Float32Array; // x, y, z of the middle of each arrow [length]
  velocities: Float32Array; // velocity at each arrow along x, y, z [length/time]
}

export interface Scene {
  file: string;
  version: string;
  lengthUnit: string;
  velocityUnit: string;
  period: number; // base period [time]
  space: string; // the domain in words
  box: number[] | null; // edges [length]; null in open space or a half-space
  periodic: boolean[];
  walls: { axis: number; at: number }[]; // axis across each wall, and its coordinate [length]
  ids: number[]; // one per swimmer
  shapes: Shape[]; // one per swimmer
  blocks: number[]; // block number of each swimmer
  times: number[]; // time of each frame [periods]
  cycleTimes: number[]; // end of each cycle [periods]
  firstBead: number[]; // index of the first bead of each swimmer, and the number of all beads
  firstBond: number[]; // index of the first bond of each swimmer, and the number of all bonds
  radius: Float32Array; // radius of each bead [length]
  start: Float32Array; // x, y, z of each bead in the first frame, unwrapped [length]
  step: Float32Array; // quantisation step of each swimmer: unit of `frames` [length]
  frames: Int16Array[]; // x, y, z of each bead minus `start`, in steps of its swimmer
  velocity: CycleTable; // velocity along the axis of the swimmer, minus the mean flow
  amplitudes: CycleTable; // arm amplitude d_i of each bond [length]
  phases: CycleTable; // arm phase δ_i of each bond [rad]
  flow: Flow | null;
}

const notANumber = -32768; // represents NaN

function takeText(page: Document, id: string): string {
  const element = page.getElementById(id);
  if (!element) throw new PageFault(`This page lacks its data "${id}": it is not whole. Write it again by beadswim-view.`);
  const text = element.textContent ?? "";
  element.remove(); // saves memory: the page keeps only the decoded arrays
  return text;
}

function decodeBase64(text: string): Uint8Array {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}

function readBytes(page: Document, id: string, expected: number): ArrayBuffer {
  let bytes: Uint8Array;
  try {
    bytes = decodeBase64(takeText(page, id));
  } catch (error) {
    if (error instanceof PageFault) throw error;
    throw new PageFault(`The data "${id}" of this page are broken. Write it again by beadswim-view.`);
  }
  if (bytes.length !== expected)
    throw new PageFault(`The data "${id}" of this page have ${bytes.length} bytes, not ${expected}: it is not whole. Write it again by beadswim-view.`);
  return bytes.buffer as ArrayBuffer;
}

const readFloats = (page: Document, id: string, count: number) => new Float32Array(readBytes(page, id, 4 * count));
const readIntegers = (page: Document, id: string, count: number) => new Int16Array(readBytes(page, id, 2 * count));

function cycleTable(page: Document, name: string, cycles: number, columns: number): CycleTable {
  const steps = readFloats(page, `cycle-${name}-step`, columns);
  const counts = readIntegers(page, `cycle-${name}`, cycles * columns);
  return {
    value(cycle, column) {
      const count = counts[cycle * columns + column];
      return count === notANumber ? NaN : count * steps[column];
    },
  };
}

function readFlow(page: Document, header: { arrows: number; spacing: number; mean_cycles: number | null } | null): Flow | null {
  return header && { spacing: header.spacing, meanCycles: header.mean_cycles,
    places: readFloats(page, "flow-place", 3 * header.arrows), velocities: readFloats(page, "flow-velocity", 3 * header.arrows) };
}

/** Returns the sums of the first 0, 1, 2, ... numbers. */
function partialSums(numbers: number[]): number[] {
  const sums = [0];
  for (const number of numbers) sums.push(sums[sums.length - 1] + number);
  return sums;
}

/** Reads the data of the run and removes the HTML elements that contained them. Throws PageFault if data are missing or invalid. */
export function readScene(page: Document): Scene {
  let header;
  try {
    header = JSON.parse(takeText(page, "scene"));
  } catch (error) {
    if (error instanceof PageFault) throw error;
    throw new PageFault('The data "scene" of this page are broken. Write it again by beadswim-view.');
  }
  const swimmers: number = header.ids.length;
  const cycles: number = header.cycle_times.length;
  const shapes: Shape[] = header.shape.map((shape: number) => header.shapes[shape]);
  const firstBead = partialSums(shapes.map((shape) => shape.beads)), firstBond = partialSums(shapes.map((shape) => shape.bonds.length));
  const beads = firstBead[swimmers], bonds = firstBond[swimmers];
  return {
    file: header.file,
    version: header.version,
    lengthUnit: header.length_unit,
    velocityUnit: header.velocity_unit,
    period: header.period,
    space: header.space,
    box: header.box,
    periodic: header.periodic,
    walls: header.walls,
    ids: header.ids,
    shapes,
    blocks: header.blocks,
    times: header.times,
    cycleTimes: header.cycle_times,
    firstBead,
    firstBond,
    radius: readFloats(page, "radius", beads),
    start: readFloats(page, "start", 3 * beads),
    step: readFloats(page, "step", swimmers),
    frames: header.times.map((_: number, frame: number) => readIntegers(page, `frame-${frame}`, 3 * beads)),
    velocity: cycleTable(page, "velocity", cycles, swimmers),
    amplitudes: cycleTable(page, "amplitude", cycles, bonds),
    phases: cycleTable(page, "phase", cycles, bonds),
    flow: readFlow(page, header.flow),
  };
}
