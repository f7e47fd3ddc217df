// Plots of quantities against time in base periods, beside the 3D view. A vertical line marks the time of the frame in the view.

import uPlot from "uplot";
import { cssVariable } from "./colours";
import { tickLabels } from "./ticks";

export interface Curve {
  label: string;
  colour: string;
  values: number[];
}

export interface Plot {
  title: string;
  unit: string;
  times: number[];
  curves: Curve[];
}

const formatNumber = (value: number | null) => (value == null ? "–" : String(Number(value.toPrecision(4))));

/** Returns the range of an axis, with margins. If all values are equal, uPlot alone would choose a range up to 100. */
function range(_: uPlot, low: number, high: number): uPlot.Range.MinMax {
  if (low == null || high == null) return [0, 1];
  const margin = high > low ? 0.08 * (high - low) : 0.1 * Math.abs(high) || 1;
  return [low - margin, high + margin];
}

export class Charts {
  private charts: uPlot[] = [];
  private time = 0;

  /** `onSeek`: function that is called with the time at which the user clicks in a plot [periods]. */
  constructor(private readonly parent: HTMLElement, private readonly onSeek: (time: number) => void) {
    new ResizeObserver(() => this.charts.forEach((chart) => chart.setSize(this.chartSize()))).observe(parent);
  }

  show(plots: Plot[]): void {
    for (const chart of this.charts) chart.destroy();
    this.charts = plots.map((plot) => this.chart(plot));
  }

  setTime(time: number): void {
    this.time = time;
    for (const chart of this.charts) {
      if (chart.cursor.idx == null) this.showValues(chart);
      chart.redraw(false);
    }
  }

  private chartSize() {
    return { width: Math.max(this.parent.clientWidth, 200), height: 170 };
  }

  private chart(plot: Plot): uPlot {
    const axis = { stroke: cssVariable("--quiet"), grid: { stroke: cssVariable("--line"), width: 1 }, ticks: { stroke: cssVariable("--line"), width: 1 } };
    const series = plot.curves.map((curve) => ({
      label: curve.label, stroke: curve.colour, width: 1.5, pxAlign: 0, points: { show: plot.times.length < 30 },
      value: (_: uPlot, value: number | null) => formatNumber(value),
    }));
    const options: uPlot.Options = {
      ...this.chartSize(),
      title: `${plot.title} (${plot.unit})`,
      scales: { x: { time: false }, y: { range } },
      axes: [{ ...axis, label: "cycles of the driving", labelSize: 20, size: 34 }, { ...axis, space: 15, size: (_, labels) => 20 + 7 * Math.max(6, ...(labels ?? []).map((label) => label.length)), values: (_: uPlot, values: number[]) => tickLabels(values) }],
      series: [{ label: "cycle", value: (_: uPlot, value: number | null) => formatNumber(value) }, ...series],
      cursor: { drag: { x: false, y: false } },
      hooks: { draw: [(chart) => this.drawTime(chart)], ready: [(chart) => this.addClickListener(chart), (chart) => this.showValues(chart)] },
    };
    return new uPlot(options, [plot.times, ...plot.curves.map((curve) => curve.values)], this.parent);
  }

  /** Shows in the legend of a plot the values of the frame or cycle that is nearest to the current time. */
  private showValues(chart: uPlot): void {
    const times = chart.data[0];
    let nearest = 0;
    for (let i = 1; i < times.length; ++i) {
      if (Math.abs(times[i] - this.time) < Math.abs(times[nearest] - this.time)) nearest = i;
    }
    chart.setLegend({ idx: nearest }, false);
  }

  private drawTime(chart: uPlot): void {
    const { left, top, width, height } = chart.bbox;
    const x = chart.valToPos(this.time, "x", true);
    if (x < left - 1 || x > left + width + 1) return;
    chart.ctx.save();
    chart.ctx.strokeStyle = cssVariable("--ink");
    chart.ctx.lineWidth = 1;
    chart.ctx.beginPath();
    chart.ctx.moveTo(x, top);
    chart.ctx.lineTo(x, top + height);
    chart.ctx.stroke();
    chart.ctx.restore();
  }

  private addClickListener(chart: uPlot): void {
    chart.over.addEventListener("click", (event) => this.onSeek(chart.posToVal(event.offsetX, "x")));
  }
}
