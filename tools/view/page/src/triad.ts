// Triad of axes in a corner of the 3D view: the directions of x, y and z as the camera sees them.

import type { Point } from "./motion";

export const triadSize = 74; // width and height of the drawing [px]
const arm = 24; // length of an axis in the plane of the picture [px]
const names = ["x", "y", "z"], colours = ["#d55e00", "#009e73", "#0072b2"];

/** An axis in the drawing: end and place of its name, relative to the middle of the drawing [px]. */
interface Axis {
  name: string;
  colour: string;
  end: [number, number];
  label: [number, number];
}

/** Returns the axes, the farthest from the eye first. `directions`: x, y and z in the frame of the camera: right, up, to the eye. */
function axes(directions: Point[]): Axis[] {
  const at = (direction: Point, size: number): [number, number] => [size * direction[0], -size * direction[1]];
  const order = [0, 1, 2].sort((i, j) => directions[i][2] - directions[j][2]);
  return order.map((i) => ({ name: names[i], colour: colours[i], end: at(directions[i], arm), label: at(directions[i], arm + 8) }));
}

/** Draws the triad with its middle at (x, y) of the canvas. `paper`: colour of the halo of the names. */
export function drawTriad(context: CanvasRenderingContext2D, directions: Point[], x: number, y: number, paper: string): void {
  context.save();
  context.translate(x, y);
  context.lineWidth = 2;
  context.lineCap = "round";
  context.font = "13px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (const { name, colour, end, label } of axes(directions)) {
    context.strokeStyle = context.fillStyle = colour;
    context.beginPath();
    context.moveTo(0, 0);
    context.lineTo(...end);
    context.stroke();
    context.strokeStyle = paper;
    context.strokeText(name, ...label);
    context.fillText(name, ...label);
  }
  context.restore();
}
