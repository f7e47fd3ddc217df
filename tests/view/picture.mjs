// Evaluates the pixels of a screenshot of the page: what the picture shows.

/** Pixels of a PNG, decoded by a blank page of the browser: { width, height, at(x, y) -> [r, g, b] }. */
export async function decoded(browser, png) {
  const page = await browser.newPage();
  const { width, height, data } = await page.evaluate(async (base64) => {
    const image = new Image();
    image.src = `data:image/png;base64,${base64}`;
    await image.decode();
    const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const pixels = context.getImageData(0, 0, image.width, image.height).data;
    let text = "";
    for (let i = 0; i < pixels.length; i += 8192) text += String.fromCharCode(...pixels.subarray(i, i + 8192));
    return { width: image.width, height: image.height, data: btoa(text) };
  }, png.toString("base64"));
  await page.close();
  const pixels = Buffer.from(data, "base64");
  return { width, height, at: (x, y) => [...pixels.subarray(4 * (y * width + x), 4 * (y * width + x) + 3)] };
}

/** Whether a pixel is a bead of this hue, lit or in the shade: r, g, b in the ratio of the colour. */
export function isOf(colour) {
  const [r, g, b] = colour, largest = Math.max(r, g, b);
  return ([x, y, z]) => {
    const top = Math.max(x, y, z), low = Math.min(x, y, z);
    if (top < 50 || top - low < 30) return false;
    return [[x, r], [y, g], [z, b]].every(([have, want]) => Math.abs(have / top - want / largest) < 0.22);
  };
}

/** Patches of at least `least` joined pixels that pass: { x, y } of their middles, width, height, count; left to right. */
export function patches(picture, passes, least = 30) {
  const seen = new Uint8Array(picture.width * picture.height);
  const found = [];
  for (let start = 0; start < seen.length; ++start) {
    if (seen[start]) continue;
    const stack = [start];
    let count = 0, left = Infinity, right = -1, top = Infinity, bottom = -1;
    while (stack.length) {
      const i = stack.pop(), x = i % picture.width, y = (i / picture.width) | 0;
      if (seen[i] || !passes(picture.at(x, y))) continue;
      seen[i] = 1;
      ++count;
      left = Math.min(left, x), right = Math.max(right, x), top = Math.min(top, y), bottom = Math.max(bottom, y);
      if (x > 0) stack.push(i - 1);
      if (x + 1 < picture.width) stack.push(i + 1);
      if (y > 0) stack.push(i - picture.width);
      if (y + 1 < picture.height) stack.push(i + picture.width);
    }
    if (count >= least) found.push({ x: (left + right) / 2, y: (top + bottom) / 2, width: right - left + 1, height: bottom - top + 1, count });
  }
  return found.sort((a, b) => a.x - b.x);
}
