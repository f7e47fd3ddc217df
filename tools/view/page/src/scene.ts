// Reads the data of the run that beadswim-view has written into the page. tools/view/page_data.hpp describes the format.

/** Error with a message for the user: why the page cannot show the run, and what to do. */
export class PageFault extends Error {}

/** Table with one value per cycle and swimmer; NaN if the swimmer has not completed a cycle yet. */
export interface CycleTable {
  value(cycle: number, swimmer: number): number;
}

export interface Scene {
  file: string;
  version: string;
  lengthUnit: string;
  velocityUnit: string;
  period: number; // base period [time]
  box: number[] | null; // edges [length]; null in open space
  periodic: boolean[];
  ids: number[]; // one per swimmer
  blocks: number[]; // block number of each swimmer
  times: number[]; // time of each frame [periods]
  cycleTimes: number[]; // end of each cycle [periods]
  radius: Float32Array; // radius of each bead [length]; three beads per swimmer
  start: Float32Array; // x, y, z of each bead in the first frame, unwrapped [length]
  step: Float32Array; // quantisation step of each swimmer: unit of `frames` [length]
  frames: Int16Array[]; // x, y, z of each bead minus `start`, in steps of its swimmer
  velocity: CycleTable; // velocity along the axis of the swimmer, minus the mean flow
  arms: [CycleTable, CycleTable]; // arm amplitudes d_i [length]
  phases: [CycleTable, CycleTable]; // arm phases δ_i [rad]
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

function cycleTable(page: Document, name: string, cycles: number, swimmers: number): CycleTable {
  const steps = readFloats(page, `cycle-${name}-step`, swimmers);
  const counts = readIntegers(page, `cycle-${name}`, cycles * swimmers);
  return {
    value(cycle, swimmer) {
      const count = counts[cycle * swimmers + swimmer];
      return count === notANumber ? NaN : count * steps[swimmer];
    },
  };
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
  const table = (name: string) => cycleTable(page, name, cycles, swimmers);
  return {
    file: header.file,
    version: header.version,
    lengthUnit: header.length_unit,
    velocityUnit: header.velocity_unit,
    period: header.period,
    box: header.box,
    periodic: header.periodic,
    ids: header.ids,
    blocks: header.blocks,
    times: header.times,
    cycleTimes: header.cycle_times,
    radius: readFloats(page, "radius", 3 * swimmers),
    start: readFloats(page, "start", 9 * swimmers),
    step: readFloats(page, "step", swimmers),
    frames: header.times.map((_: number, frame: number) => readIntegers(page, `frame-${frame}`, 9 * swimmers)),
    velocity: table("velocity"),
    arms: [table("arm1"), table("arm2")],
    phases: [table("phase1"), table("phase2")],
  };
}
