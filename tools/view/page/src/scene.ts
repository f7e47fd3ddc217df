// What the page shows: read from the elements that beadswim-view wrote into it (tools/view/page_data.hpp).

/** What keeps the page from showing the run, for the reader of the page. */
export class PageFault extends Error {}

/** Numbers of each cycle and swimmer; NaN where a swimmer has ended no cycle yet. */
export interface CycleTable {
  at(cycle: number, swimmer: number): number;
}

export interface Scene {
  file: string;
  version: string;
  lengthUnit: string;
  velocityUnit: string;
  period: number; // of the driving [time]
  box: number[] | null; // its edges; none in open space
  periodic: boolean[];
  ids: number[]; // of the swimmers
  blocks: number[]; // that the swimmers are of
  times: number[]; // of the frames [periods]
  cycleTimes: number[]; // when the cycles ended [periods]
  radius: Float32Array; // of the beads, three a swimmer
  start: Float32Array; // x, y, z of the beads in the first frame, unwrapped
  step: Float32Array; // of the swimmers: the length that `frames` count
  frames: Int16Array[]; // x, y, z of the beads less those at the start, in steps
  velocity: CycleTable; // along the swimmer's axis, against the mean flow
  arms: [CycleTable, CycleTable]; // amplitudes of (4.1)
  phases: [CycleTable, CycleTable]; // of (4.1), radians
}

const none = -32768; // stands for no number

function textOf(page: Document, id: string): string {
  const element = page.getElementById(id);
  if (!element) throw new PageFault(`This page lacks its data "${id}": it is not whole. Write it again by beadswim-view.`);
  const text = element.textContent ?? "";
  element.remove(); // the numbers alone are kept in memory
  return text;
}

function decoded(text: string): Uint8Array {
  const characters = atob(text);
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
  return bytes;
}

function bytesOf(page: Document, id: string, expected: number): ArrayBuffer {
  let bytes: Uint8Array;
  try {
    bytes = decoded(textOf(page, id));
  } catch (error) {
    if (error instanceof PageFault) throw error;
    throw new PageFault(`The data "${id}" of this page are broken. Write it again by beadswim-view.`);
  }
  if (bytes.length !== expected)
    throw new PageFault(`The data "${id}" of this page have ${bytes.length} bytes, not ${expected}: it is not whole. Write it again by beadswim-view.`);
  return bytes.buffer as ArrayBuffer;
}

const floats = (page: Document, id: string, count: number) => new Float32Array(bytesOf(page, id, 4 * count));
const wholes = (page: Document, id: string, count: number) => new Int16Array(bytesOf(page, id, 2 * count));

function cycleTable(page: Document, name: string, cycles: number, swimmers: number): CycleTable {
  const steps = floats(page, `cycle-${name}-step`, swimmers);
  const counts = wholes(page, `cycle-${name}`, cycles * swimmers);
  return {
    at(cycle, swimmer) {
      const count = counts[cycle * swimmers + swimmer];
      return count === none ? NaN : count * steps[swimmer];
    },
  };
}

/** Reads the data and takes them out of the page. Throws PageFault. */
export function readScene(page: Document): Scene {
  let header;
  try {
    header = JSON.parse(textOf(page, "scene"));
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
    radius: floats(page, "radius", 3 * swimmers),
    start: floats(page, "start", 9 * swimmers),
    step: floats(page, "step", swimmers),
    frames: header.times.map((_: number, frame: number) => wholes(page, `frame-${frame}`, 9 * swimmers)),
    velocity: table("velocity"),
    arms: [table("arm1"), table("arm2")],
    phases: [table("phase1"), table("phase2")],
  };
}
