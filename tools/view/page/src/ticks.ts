// Labels of the ticks of an axis.

/** Returns the labels of axis ticks, with as few digits as show all values to a hundredth of the spacing of the ticks. */
export function tickLabels(values: number[]): string[] {
  const spacing = Math.abs(values.length > 1 ? values[1] - values[0] : values[0]) || 1, largest = Math.max(...values.map(Math.abs), spacing);
  const isScientific = largest < 1e-2 || largest >= 1e5, maxDigits = 12;
  const text = (value: number, digits: number) => (value === 0 ? "0" : isScientific ? value.toExponential(digits) : value.toFixed(digits));
  const isTrue = (digits: number) => values.every((value) => Math.abs(Number(text(value, digits)) - value) < 0.01 * spacing);
  let digits = 0;
  while (digits < maxDigits && !isTrue(digits)) ++digits;
  return values.map((value) => text(value, digits));
}
