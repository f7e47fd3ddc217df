// Contents of the plots: quantities of the selected swimmer, or, if none is selected, of the swarm.

import { categories, toCss } from "./colours";
import type { Plot } from "./charts";
import { makeSeries } from "./motion";
import type { CycleTable, Scene } from "./scene";

const colour = (n: number) => toCss(categories[n]);

function cyclePlots(scene: Scene, curves: Plot["curves"], title: string, unit: string): Plot[] {
  return scene.cycleTimes.length === 0 ? [] : [{ title, unit, times: scene.cycleTimes, curves }];
}

const valuesByCycle = (scene: Scene, number: (cycle: number) => number) => scene.cycleTimes.map((_, cycle) => number(cycle));

function swimmerPlots(scene: Scene, swimmer: number): Plot[] {
  const series = makeSeries(scene, swimmer), times = scene.times, unit = scene.lengthUnit;
  const swimmerValues = (table: CycleTable) => valuesByCycle(scene, (cycle) => table.value(cycle, swimmer));
  return [
    { title: "Stroke: arm lengths", unit, times, curves: [
      { label: "arm 1", colour: colour(0), values: series.arms[0] },
      { label: "arm 2", colour: colour(1), values: series.arms[1] }] },
    { title: "Displacement", unit, times, curves: [
      { label: "along the axis", colour: colour(0), values: series.along },
      { label: "across it", colour: colour(5), values: series.across }] },
    { title: "Turning", unit: "degrees", times, curves: [
      { label: "of the axis", colour: colour(2), values: series.turning },
      { label: "bend of the arms", colour: colour(3), values: series.bend }] },
    ...cyclePlots(scene, [{ label: "velocity", colour: colour(0), values: swimmerValues(scene.velocity) }],
      "Velocity along the axis, by cycle", scene.velocityUnit),
    ...cyclePlots(scene, scene.arms.map((arm, n) => ({ label: `d${n + 1}`, colour: colour(n), values: swimmerValues(arm) })),
      "Arm amplitudes, by cycle", unit),
  ];
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
