// Contents of the plots: quantities of the selected swimmer, or, if none is selected, of the swarm.

import { categories, toCss } from "./colours";
import type { Curve, Plot } from "./charts";
import { makeSeries } from "./motion";
import type { CycleTable, Scene } from "./scene";

const colour = (n: number) => toCss(categories[n % categories.length]);

/** Returns the curves of the arms or angles of a swimmer. If they are more than the colours, returns evenly spaced ones. */
function partCurves(parts: number[][], label: (n: number) => string, firstColour = 0): Curve[] {
  const most = categories.length;
  const shown = parts.length <= most ? parts.map((_, n) => n) : categories.map((_, i) => Math.round((i * (parts.length - 1)) / (most - 1)));
  return shown.map((n, i) => ({ label: label(n), colour: colour(firstColour + i), values: parts[n] }));
}

function cyclePlots(scene: Scene, curves: Plot["curves"], title: string, unit: string): Plot[] {
  return scene.cycleTimes.length === 0 ? [] : [{ title, unit, times: scene.cycleTimes, curves }];
}

const valuesByCycle = (scene: Scene, number: (cycle: number) => number) => scene.cycleTimes.map((_, cycle) => number(cycle));

function swimmerPlots(scene: Scene, swimmer: number): Plot[] {
  const { arms, angles, distance, axis } = makeSeries(scene, swimmer);
  const times = scene.times, unit = scene.lengthUnit;
  const cycleValues = (table: CycleTable, column: number) => valuesByCycle(scene, (cycle) => table.value(cycle, column));
  const amplitudes = arms.map((_, n) => cycleValues(scene.amplitudes, scene.firstBond[swimmer] + n));
  const plots = [
    { title: "Stroke: arm lengths", unit, times, curves: partCurves(arms, (n) => `arm ${n + 1}`) },
    { title: "Displacement", unit, times, curves: axis
      ? [{ label: "along the axis", colour: colour(0), values: axis.along }, { label: "across it", colour: colour(5), values: axis.across }]
      : [{ label: "distance from the start", colour: colour(0), values: distance }] },
    { title: "Turning", unit: "degrees", times, curves: [
      ...(axis ? [{ label: "of the axis", colour: colour(2), values: axis.turning }] : []),
      ...partCurves(angles, (n) => (angles.length === 1 ? "bend of the arms" : `bend ${n + 1}`), 3)] },
    ...cyclePlots(scene, [{ label: "velocity", colour: colour(0), values: cycleValues(scene.velocity, swimmer) }],
      "Velocity along the axis, by cycle", scene.velocityUnit),
    ...cyclePlots(scene, partCurves(amplitudes, (n) => `d${n + 1}`), "Arm amplitudes, by cycle", unit),
  ];
  return plots.filter(({ curves }) => curves.length > 0); // a sphere has neither arms nor an axis
}

function swarmPlots(scene: Scene): Plot[] {
  const velocities = (cycle: number) => scene.ids.map((_, s) => scene.velocity.value(cycle, s)).filter((v) => !Number.isNaN(v));
  const summary = (reduce: (values: number[]) => number) => valuesByCycle(scene, (cycle) => reduce(velocities(cycle)));
  const mean = summary((v) => v.reduce((a, b) => a + b, 0) / v.length);
  if (scene.ids.length === 1) return cyclePlots(scene, [{ label: "velocity", colour: colour(0), values: mean }], "Velocity along the axis, by cycle", scene.velocityUnit);
  return cyclePlots(scene, [
    { label: "mean", colour: colour(0), values: mean },
    { label: "least", colour: colour(4), values: summary((v) => v.reduce((a, b) => Math.min(a, b), Infinity)) },
    { label: "greatest", colour: colour(5), values: summary((v) => v.reduce((a, b) => Math.max(a, b), -Infinity)) },
  ], "Swimmers' velocity along their axes, by cycle", scene.velocityUnit);
}

export function makePlots(scene: Scene, swimmer: number | null): Plot[] {
  return swimmer === null ? swarmPlots(scene) : swimmerPlots(scene, swimmer);
}
