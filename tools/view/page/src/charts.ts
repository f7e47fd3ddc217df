// Plots beside the picture, against time in periods of the driving; a line stands at the moment that is shown.

import uPlot from "uplot";

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

const css = (name: string) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

const written = (value: number | null) => (value == null ? "–" : String(Number(value.toPrecision(4))));

/** Room around numbers that are all the same, which uPlot would draw on an axis up to 100. */
function range(_: uPlot, low: number, high: number): uPlot.Range.MinMax {
  if (low == null || high == null) return [0, 1];
  const room = high > low ? 0.08 * (high - low) : Math.max(0.1 * Math.abs(high), 1e-3);
  return [low - room, high + room];
}

/** As many digits as tell the ticks apart. */
function ticks(_: uPlot, values: number[]): string[] {
  const apart = Math.abs(values[1] - values[0]) || 1, largest = Math.max(...values.map(Math.abs), apart);
  if (largest < 1e-2 || largest >= 1e5) {
    const digits = Math.max(0, Math.floor(Math.log10(largest)) - Math.floor(Math.log10(apart) + 1e-9));
    return values.map((value) => (value === 0 ? "0" : value.toExponential(digits)));
  }
  return values.map((value) => value.toFixed(Math.max(0, -Math.floor(Math.log10(apart) + 1e-9))));
}

export class Charts {
  private charts: uPlot[] = [];
  private time = 0;

  /** `onSeek` is told the time that the reader clicks on. */
  constructor(private readonly parent: HTMLElement, private readonly onSeek: (time: number) => void) {
    new ResizeObserver(() => this.charts.forEach((chart) => chart.setSize(this.sizeOf()))).observe(parent);
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

  private sizeOf() {
    return { width: Math.max(this.parent.clientWidth, 200), height: 170 };
  }

  private chart(plot: Plot): uPlot {
    const axis = { stroke: css("--quiet"), grid: { stroke: css("--line"), width: 1 }, ticks: { stroke: css("--line"), width: 1 } };
    const series = plot.curves.map((curve) => ({
      label: curve.label, stroke: curve.colour, width: 1.5, pxAlign: 0, points: { show: plot.times.length < 30 },
      value: (_: uPlot, value: number | null) => written(value),
    }));
    const options: uPlot.Options = {
      ...this.sizeOf(),
      title: `${plot.title} (${plot.unit})`,
      scales: { x: { time: false }, y: { range } },
      axes: [{ ...axis, label: "cycles of the driving", labelSize: 20, size: 34 }, { ...axis, size: 70, values: ticks }],
      series: [{ label: "cycle", value: (_: uPlot, value: number | null) => written(value) }, ...series],
      cursor: { drag: { x: false, y: false } },
      hooks: { draw: [(chart) => this.drawTime(chart)], ready: [(chart) => this.listen(chart), (chart) => this.showValues(chart)] },
    };
    return new uPlot(options, [plot.times, ...plot.curves.map((curve) => curve.values)], this.parent);
  }

  /** In the legend: the numbers at the frame or cycle next to the moment that is shown. */
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
    chart.ctx.strokeStyle = css("--ink");
    chart.ctx.lineWidth = 1;
    chart.ctx.beginPath();
    chart.ctx.moveTo(x, top);
    chart.ctx.lineTo(x, top + height);
    chart.ctx.stroke();
    chart.ctx.restore();
  }

  private listen(chart: uPlot): void {
    chart.over.addEventListener("click", (event) => this.onSeek(chart.posToVal(event.offsetX, "x")));
  }
}
