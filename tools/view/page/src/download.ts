// Files that the user saves from the page.

import type { Plot } from "./charts";

export function download(name: string, content: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

const quoted = (text: string) => `"${text.replaceAll('"', '""')}"`;

/** Returns the numbers of the plots as comma-separated values, a line per point; times are in cycles of the driving. */
export function plotsToCsv(plots: Plot[]): string {
  const lines = ["quantity,unit,curve,cycle,value"];
  for (const { title, unit, times, curves } of plots) {
    for (const { label, values } of curves) {
      values.forEach((value, i) => {
        if (Number.isFinite(value)) lines.push([quoted(title), quoted(unit), quoted(label), times[i], value].join(","));
      });
    }
  }
  return lines.join("\n") + "\n";
}
