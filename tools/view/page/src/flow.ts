// Arrows of a flow field. Their lengths and colours change with the square root of the speed, so that slow flow far from the
// swimmers stays visible.

import * as three from "three";
import { interpolate, sequential, toCss } from "./colours";
import type { Flow } from "./scene";
import { arrowFragment, arrowVertex } from "./shaders";
import { tickLabels } from "./ticks";

const longest = 1.5; // arrow, in distances between neighbours
const outline = [[0, -0.5], [0.03, -0.5], [0.03, 0.15], [0.1, 0.15], [0, 0.5]]; // distance from the axis, and place along it

function speeds(flow: Flow): number[] {
  return Array.from({ length: flow.places.length / 3 }, (_, n) => Math.hypot(...flow.velocities.subarray(3 * n, 3 * n + 3)));
}

const largest = (numbers: number[]) => numbers.reduce((a, b) => Math.max(a, b), 0);

/** Returns the arrows as one object; fluid at rest has none. */
export function flowArrows(flow: Flow): three.Mesh {
  const all = speeds(flow), max = largest(all);
  const moving = all.flatMap((speed, n) => (speed > 0 ? [n] : []));
  const share = moving.map((n) => Math.sqrt(all[n] / max));
  const ofArrows = (numbers: Float32Array) => moving.flatMap((n) => [...numbers.subarray(3 * n, 3 * n + 3)]);
  const lathe = new three.LatheGeometry(outline.map(([x, y]) => new three.Vector2(x, y)), 6);
  const geometry = new three.InstancedBufferGeometry();
  geometry.setIndex(lathe.index).setAttribute("position", lathe.getAttribute("position"));
  const add = (name: string, size: number, numbers: number[]) =>
    geometry.setAttribute(name, new three.InstancedBufferAttribute(new Float32Array(numbers), size));
  add("centre", 3, ofArrows(flow.places));
  add("velocity", 3, ofArrows(flow.velocities).map((component) => component / max));
  add("colour", 3, share.flatMap((part) => interpolate(sequential, part)));
  const size = longest * flow.spacing;
  add("size", 2, share.flatMap((part) => [size * Math.sqrt(part), size * part])); // short arrows are relatively wide
  geometry.instanceCount = moving.length;
  const shader = new three.RawShaderMaterial({ glslVersion: three.GLSL3, vertexShader: arrowVertex, fragmentShader: arrowFragment, side: three.DoubleSide });
  const mesh = new three.Mesh(geometry, shader);
  mesh.frustumCulled = false;
  return mesh;
}

/** Returns the content of the legend: a title, the colours as a background image, and the speeds at the start, middle and end. */
export function flowLegend(flow: Flow, velocityUnit: string): { title: string; bar: string; ends: string[] } {
  const max = largest(speeds(flow)), cycles = flow.meanCycles;
  const name = cycles === null ? "Flow" : `Mean flow of ${cycles} cycle${cycles === 1 ? "" : "s"}`;
  return { title: `${name}: speed (${velocityUnit})`, bar: `linear-gradient(to right, ${sequential.map(toCss).join(", ")})`,
    ends: tickLabels([0, max / 4, max].map((speed) => Number(speed.toPrecision(3)))) }; // at equal distances of the square root
}
