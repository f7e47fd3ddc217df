// Tests pages of beadswim-view in headless Chromium: loading, playing, selecting swimmers, and the content of the picture.
//   node page_test.mjs FOLDER MODULES CHROMIUM
// FOLDER contains the pages alone.html, swarm.html, outside.html, shapes.html, flow.html, ends.html and the run records alone.json, swarm.json,
// shapes.json, which run.sh makes.
// MODULES is a folder with playwright-core in node_modules.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { after, test } from "node:test";
import { decoded, isOf, patches } from "./picture.mjs";

const [folder, modules, chromiumPath] = process.argv.slice(2);
const { chromium } = createRequire(modules + "/")("playwright-core");
const launch = (...flags) => chromium.launch({ executablePath: chromiumPath,
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", ...flags] });
const browser = await launch();
after(() => browser.close());

const blue = isOf([0, 114, 178]), orange = isOf([230, 159, 0]), rim = ([r, g, b]) => r > 190 && g < 40 && b > 90 && b < 160;
const addressOf = (name) => `file://${folder}/${name}`;

/** A page that has loaded; faults are what went wrong in it, requests what it asked for beside itself. */
async function opened(name, { viewport = { width: 1280, height: 800 }, from = browser } = {}) {
  const page = await from.newPage({ viewport });
  page.setDefaultTimeout(60000);
  const faults = [], requests = [];
  page.on("pageerror", (error) => faults.push(error.message));
  page.on("console", (message) => message.type() === "error" && faults.push(message.text()));
  page.on("request", (request) => requests.push(request.url()));
  await page.goto(addressOf(name), { timeout: 60000 });
  await page.waitForFunction(() => document.getElementById("message").textContent !== "Loading …");
  return { page, faults, requests, message: await page.textContent("#message") };
}

/** The canvas alone, without legend and axes that lie over it, when it has been drawn. */
async function picture(page) {
  await page.evaluate(() => {
    for (const id of ["legends", "triad"]) document.getElementById(id).style.visibility = "hidden";
    return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  });
  return decoded(browser, await page.locator("#canvas").screenshot());
}

const frameShown = async (page) => Number(/frame (\d+)/.exec(await page.textContent("#clock"))[1]);
const record = (name) => JSON.parse(readFileSync(`${folder}/${name}`, "utf8"));
const close = (a, b, tolerance, what) => assert.ok(Math.abs(a - b) <= tolerance * Math.abs(b), `${what}: ${a}, not ${b}`);

test("loads without faults, and asks for nothing", async () => {
  const { page, faults, requests, message } = await opened("swarm.html");
  assert.equal(message, "");
  assert.deepEqual(faults, []);
  assert.deepEqual(requests, [addressOf("swarm.html")]);
  assert.match(await page.title(), /^swarm\.h5md/);
  assert.match(await page.textContent("#facts"), /^4 swimmers, box 96 × 64 × 64 lattice units, period 2000, 41 frames over 1 cycle$/);
  await page.close();
});

test("the picture has a swimmer's beads in their sizes and places", async () => {
  const { page } = await opened("alone.html");
  await page.click('[data-view="y"]');
  const beads = patches(await picture(page), blue);
  assert.equal(beads.length, 3);
  const [one, two, three] = beads; // radii 3, 4, 5 and arms 18, 27, all as far from the eye
  const scale = (three.x - one.x) / 45;
  close((two.x - one.x) / scale, 18, 0.03, "arm 1");
  close((three.x - two.x) / scale, 27, 0.03, "arm 2");
  beads.forEach((bead, i) => {
    close(bead.width / scale, 2 * (3 + i), 0.08, `width of bead ${i + 1}`);
    close(bead.height / scale, 2 * (3 + i), 0.08, `height of bead ${i + 1}`);
    close(bead.y, two.y, 0.02, "height in the picture");
  });
  await page.close();
});

test("blocks have their colours", async () => {
  const { page } = await opened("swarm.html");
  await page.click('[data-view="y"]');
  const seen = await picture(page); // blocks of one swimmer: the two in front, one over the other, are of two colours
  const [blues, oranges] = [patches(seen, blue), patches(seen, orange)];
  assert.ok(blues.length >= 3 && oranges.length >= 3, `${blues.length} blue and ${oranges.length} orange beads`);
  assert.deepEqual(await page.locator(".key").allTextContents(), ["block 0", "block 1"]);
  await page.close();
});

test("plays, pauses and scrubs", async () => {
  const { page } = await opened("alone.html");
  await page.click('[data-view="y"]');
  const before = patches(await picture(page), blue);
  await page.click("#play");
  await page.waitForFunction(() => Number(document.getElementById("time").value) > 5);
  assert.equal(await page.textContent("#play"), "Pause");
  await page.click("#play");
  const paused = await frameShown(page);
  await page.waitForTimeout(300);
  assert.equal(await frameShown(page), paused);
  await page.locator("#time").fill("10");
  assert.equal(await frameShown(page), 10);
  await page.locator("#time").press("ArrowRight");
  assert.equal(await frameShown(page), 11);
  const later = patches(await picture(page), blue);
  assert.ok(Math.abs(later[0].x - before[0].x) > 1, "bead 1 has moved");
  await page.close();
});

test("plays frames that lie far apart one by one, the last too", async () => {
  const { page } = await opened("ends.html");
  assert.match(await page.textContent("#facts"), /2 frames/);
  await page.click("#play");
  await page.waitForFunction(() => document.getElementById("clock").textContent.includes("frame 1 of 1"));
  await page.waitForFunction(() => document.getElementById("clock").textContent.includes("frame 0 of 1"));
  await page.close();
});

test("picks the swimmer under the pointer, and lets it go", async () => {
  const { page } = await opened("alone.html");
  await page.click('[data-view="y"]');
  const seen = await picture(page), middle = patches(seen, blue)[1];
  assert.equal(patches(seen, rim, 5).length, 0);
  await page.locator("#canvas").click({ position: { x: middle.x, y: middle.y } });
  assert.equal(await page.textContent("#picked"), "Swimmer 7");
  assert.equal(await page.inputValue("#swimmer"), "7");
  const titles = await page.locator(".u-title").allTextContents();
  assert.deepEqual(titles.map((title) => title.split(" (")[0]), ["Stroke: arm lengths", "Displacement", "Turning",
    "Velocity along the axis, by cycle", "Arm amplitudes, by cycle"]);
  assert.ok(patches(await picture(page), rim, 5).length >= 3, "rims of the beads");
  await page.locator("#canvas").click({ position: { x: middle.x, y: 20 } });
  assert.match(await page.textContent("#picked"), /^Click/);
  await page.close();
});

test("plots the stroke and the velocity of the record", async () => {
  const { page } = await opened("alone.html");
  await page.locator("#swimmer").fill("7");
  await page.keyboard.press("Enter");
  await page.keyboard.press("Escape"); // out of the number, and of the swimmer
  await page.locator("#canvas").focus();
  await page.keyboard.press("n");
  await page.locator("#time").fill("80"); // the end of the second cycle
  const numbers = (await page.locator(".u-legend .u-value").allTextContents()).map(Number);
  const cycle = record("alone.json").swimmers[0].cycles[1];
  const [, arm1, arm2, , along, , , , , , velocity, , d1, d2] = numbers;
  close(velocity, cycle.speed_along_axis, 1e-3, "velocity");
  close(d1, cycle.arm_amplitudes[0], 1e-3, "d1");
  close(d2, cycle.arm_amplitudes[1], 1e-3, "d2");
  const lengthAtEnd = (n) => cycle.arm_means[n] + cycle.arm_amplitudes[n] * Math.cos(cycle.arm_phases[n]);
  close(arm1, lengthAtEnd(0), 0.01, "arm 1"); // the fit has the first harmonic alone
  close(arm2, lengthAtEnd(1), 0.01, "arm 2");
  const moved = record("alone.json").swimmers[0].cycles.reduce((sum, { speed_along_axis }) => sum + 300 * speed_along_axis, 0);
  close(along, moved, 2e-3, "displacement");
  await page.close();
});

test("shows swimmers of any shape", async () => {
  const { page, faults, message } = await opened("shapes.html"); // a triangle of 24 by 22 in blue, and a sphere of radius 8, 40 to its right
  assert.equal(message, "");
  await page.click('[data-view="y"]');
  const seen = await picture(page), beads = patches(seen, (pixel) => blue(pixel) || orange(pixel));
  assert.equal(beads.length, 4);
  const [left, top, right, sphere] = beads, scale = (right.x - left.x) / 24;
  close((left.y - top.y) / scale, 22, 0.03, "height of the triangle");
  close((sphere.x - top.x) / scale, 40, 0.03, "distance of the sphere");
  close(sphere.width / scale, 16, 0.05, "diameter of the sphere");
  const isBond = ([r, g, b]) => Math.max(r, g, b) - Math.min(r, g, b) < 40 && r < 200;
  const drawn = (a, b) => [0.4, 0.5, 0.6].every((part) => isBond(seen.at(Math.round(a.x + part * (b.x - a.x)), Math.round(a.y + part * (b.y - a.y)))));
  for (const [a, b] of [[left, right], [right, top], [top, left]]) assert.ok(drawn(a, b), "a side of the triangle");
  assert.ok(!drawn(right, sphere), "no bond to the sphere");

  await page.locator("#canvas").click({ position: { x: sphere.x, y: sphere.y } });
  assert.match(await page.textContent("#picked"), /^Swimmer 1,/);
  const titles = async () => (await page.locator(".u-title").allTextContents()).map((title) => title.split(" (")[0]);
  assert.deepEqual(await titles(), ["Displacement", "Velocity along the axis, by cycle"]);
  assert.equal(patches(await picture(page), rim, 5).length, 1);
  await page.locator("#canvas").click({ position: { x: top.x, y: top.y } });
  assert.deepEqual(await titles(), ["Stroke: arm lengths", "Displacement", "Velocity along the axis, by cycle", "Arm amplitudes, by cycle"]);
  assert.equal(patches(await picture(page), rim, 5).length, 3);
  await page.locator("#time").fill("80"); // the end of the second cycle
  const numbers = (await page.locator(".u-legend .u-value").allTextContents()).map(Number);
  const amplitudes = record("shapes.json").swimmers[0].cycles[1].arm_amplitudes;
  numbers.slice(-3).forEach((amplitude, n) => close(amplitude, amplitudes[n], 1e-3, `d${n + 1}`));

  const disabled = (value) => page.locator(`#colours option[value=${value}]`).evaluate((option) => option.disabled);
  assert.deepEqual([await disabled("phase"), await disabled("orientation")], [false, true]);
  await page.selectOption("#colours", "phase");
  assert.deepEqual(faults, []);
  await page.close();
});

test("shows the flow as arrows, or hides it", async () => {
  const { page, faults, message } = await opened("flow.html"); // a sphere of radius 4 that is pulled to the right, and one arrow of length 24
  assert.equal(message, "");
  await page.click('[data-view="y"]');
  const seen = await picture(page), yellow = isOf([253, 231, 37]), arrows = patches(seen, yellow), [sphere] = patches(seen, blue);
  assert.equal(arrows.length, 1);
  const [{ x, y, width }] = arrows;
  close(width, (24 / 8) * sphere.width, 0.1, "length of the arrow");
  close(sphere.y - y, (30 / 8) * sphere.width, 0.1, "height of the arrow above the sphere");
  const thickness = (part) => Array.from({ length: seen.height }, (_, row) => row).filter((row) => yellow(seen.at(Math.round(x + part * width), row))).length;
  assert.ok(thickness(0.2) > 2 * thickness(-0.2), "the head is at the right");
  assert.equal(await page.textContent("#flow-title"), "Flow: speed (lattice units)");
  await page.uncheck("#flow");
  assert.equal(patches(await picture(page), yellow).length, 0);
  assert.ok(await page.locator("#flow-legend").isHidden());
  assert.deepEqual(faults, []);
  await page.close();
});

test("says which ids there are", async () => {
  const { page } = await opened("swarm.html");
  await page.locator("#swimmer").fill("99");
  await page.locator("#swimmer").press("Enter");
  assert.equal(await page.textContent("#picked"), "There is no swimmer 99; ids are 0 to 3.");
  await page.close();
});

test("works by keyboard", async () => {
  const { page } = await opened("swarm.html");
  const value = (id) => page.inputValue(`#${id}`);
  await page.keyboard.press("n");
  await page.keyboard.press("n");
  assert.equal(await value("swimmer"), "1");
  await page.keyboard.press("p");
  assert.equal(await value("swimmer"), "0");
  await page.keyboard.press("f");
  assert.ok(await page.isChecked("#follow"));
  await page.keyboard.press("Escape");
  assert.equal(await value("swimmer"), "");
  await page.keyboard.press("c");
  assert.equal(await value("colours"), "velocity");
  await page.keyboard.press(".");
  await page.keyboard.press(".");
  await page.keyboard.press(",");
  assert.equal(await frameShown(page), 1);
  await page.keyboard.press("]");
  assert.equal(await value("speed"), "1");
  await page.keyboard.press("w");
  assert.equal(await page.isChecked("#wrap"), false);
  await page.keyboard.press("Space");
  assert.equal(await page.textContent("#play"), "Pause");
  await page.keyboard.press("Space");
  await page.locator("#canvas").focus();
  const before = patches(await picture(page), blue, 10).length + (await page.locator("#canvas").screenshot()).toString("base64");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("+");
  assert.notEqual(patches(await picture(page), blue, 10).length + (await page.locator("#canvas").screenshot()).toString("base64"), before);
  await page.close();
});

test("wraps swimmers into the box", async () => {
  const { page } = await opened("outside.html"); // its middle bead starts on the face of the box, 60 long, and goes to and fro
  await page.click('[data-view="y"]');
  const moved = [];
  for (const frame of ["10", "30"]) {
    await page.locator("#time").fill(frame);
    await page.locator("#wrap").check();
    const inside = patches(await picture(page), blue, 10);
    await page.locator("#wrap").uncheck();
    const outside = patches(await picture(page), blue, 10);
    moved.push((4 * (inside[0].x - outside[0].x)) / inside[0].width); // beads are 4 wide; bead 1 no edge of the box hides
  }
  moved.sort((a, b) => a - b);
  assert.equal(moved[0], 0);
  close(moved[1], 60, 0.05, "moved by a box");
  await page.close();
});

test("colours by velocity go from the least to the greatest of the record", async () => {
  const { page } = await opened("swarm.html");
  await page.selectOption("#colours", "velocity");
  const speeds = record("swarm.json").swimmers.flatMap(({ cycles }) => cycles).map(({ velocity, mean_flow }) => velocity[0] - mean_flow[0]);
  const ends = (await page.locator("#legend-ends span").allTextContents()).map(Number);
  close(ends[0], Math.min(...speeds), 5e-3, "least");
  close(ends[1], Math.max(...speeds), 5e-3, "greatest");
  for (const colours of ["orientation", "phase"]) {
    await page.selectOption("#colours", colours);
    assert.equal(await page.locator("#legend-ends span").count(), 2);
  }
  await page.close();
});

test("colours are of the cycle that is shown, up to its end", async () => {
  const { page } = await opened("alone.html"); // the first cycle is the slower one
  await page.selectOption("#colours", "velocity");
  await page.click('[data-view="y"]');
  const yellow = async (frame) => {
    await page.locator("#time").fill(frame);
    return patches(await picture(page), isOf([253, 231, 37])).length;
  };
  const { cycles } = record("alone.json").swimmers[0];
  assert.ok(cycles[0].speed_along_axis < cycles[1].speed_along_axis);
  assert.deepEqual([await yellow("40"), await yellow("41")], [0, 3]);
  await page.close();
});

test("draws the picture in its new size before it is seen", async () => {
  const { page } = await opened("alone.html");
  const [drawn, seen] = await page.evaluate(() => new Promise((done) => {
    const canvas = document.getElementById("canvas");
    let calls = 0;
    new ResizeObserver(() => { // is called after the observer of the page, and before the browser shows the picture
      if (++calls === 1) document.getElementById("stage").style.height = "200px";
      else done([canvas.width / canvas.height, canvas.clientWidth / canvas.clientHeight]);
    }).observe(canvas);
  }));
  close(drawn, seen, 0.01, "width over height");
  await page.close();
});

test("plots of one cycle have a tick that says what its value is", async () => {
  const { page } = await opened("outside.html");
  const labels = await page.evaluate(() => {
    const texts = [], { fillText } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.fillText = function (text, ...rest) { texts.push(text); return fillText.call(this, text, ...rest); };
    document.querySelector("#swimmer").dispatchEvent(new Event("change"));
    return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(texts))));
  });
  const velocity = record("outside.json").swimmers[0].cycles[0].speed_along_axis;
  assert.ok(labels.map(Number).some((tick) => tick !== 0 && Math.abs(tick / velocity - 1) < 0.2), `${velocity}: ${labels}`);
  await page.close();
});

test("fits a narrow screen", async () => {
  const { page } = await opened("swarm.html", { viewport: { width: 360, height: 740 } });
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "nothing sticks out");
  const boxes = await Promise.all(["#canvas", "#controls", "#panel"].map((id) => page.locator(id).boundingBox()));
  assert.ok(boxes[0].width > 300 && boxes[0].height > 300);
  assert.ok(boxes[1].y >= boxes[0].y + boxes[0].height - 1 && boxes[2].y >= boxes[1].y + boxes[1].height - 1, "one below the other");
  const legend = await page.locator("#legend").boundingBox();
  assert.ok(legend.height > 10 && legend.y >= boxes[0].y + boxes[0].height - 1, "the legend lies below the swimmers, not over them");
  await page.close();
});

/** Colours of the triad in the corner of a drawing, and the mean place of each in it. */
async function triadOf(page, image) {
  const colours = { x: isOf([213, 94, 0]), y: isOf([0, 158, 115]), z: blue };
  return Object.fromEntries(Object.entries(colours).map(([name, colour]) => [name, patches(image, colour, 3)]));
}

test("shows the directions of the axes", async () => {
  const { page } = await opened("alone.html");
  const shown = async (view) => {
    await page.click(`[data-view="${view}"]`);
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    return triadOf(page, await decoded(browser, await page.locator("#triad").screenshot()));
  };
  const y = await shown("y"), middle = 37; // seen along y: x to the right, z up
  assert.ok(y.x.some((patch) => patch.x > middle + 8 && Math.abs(patch.y - middle) < 4), JSON.stringify(y));
  assert.ok(y.z.some((patch) => patch.y < middle - 8 && Math.abs(patch.x - middle) < 4), JSON.stringify(y));
  const z = await shown("z"); // from above: x to the right, y up
  assert.ok(z.y.some((patch) => patch.y < middle - 8 && Math.abs(patch.x - middle) < 4), JSON.stringify(z));
  await page.close();
});

test("saves the picture and the numbers", async () => {
  const { page } = await opened("alone.html");
  await page.locator("#swimmer").fill("7");
  await page.locator("#swimmer").press("Enter");
  const saved = async (button) => {
    const [file] = await Promise.all([page.waitForEvent("download"), page.click(button)]);
    return [file.suggestedFilename(), readFileSync(await file.path())];
  };
  const [picture, png] = await saved("#save-picture");
  assert.equal(picture, "alone-swimmer-7-frame-0.png");
  const image = await decoded(browser, png);
  assert.equal(patches(image, blue).filter(({ width }) => width > 8).length, 3, "three beads");
  const [numbers, csv] = await saved("#save-numbers");
  assert.equal(numbers, "alone-swimmer-7.csv");
  const [head, ...lines] = csv.toString().trim().split("\n");
  assert.equal(head, "quantity,unit,curve,cycle,value");
  const { cycles } = record("alone.json").swimmers[0];
  const velocities = lines.filter((line) => line.startsWith('"Velocity')).map((line) => Number(line.split(",").at(-1)));
  velocities.forEach((velocity, cycle) => close(velocity, cycles[cycle].speed_along_axis, 1e-3, `velocity in cycle ${cycle + 1}`));
  assert.equal(velocities.length, 2);
  assert.ok(lines.some((line) => line.startsWith('"Stroke: arm lengths","lattice units","arm 1",0,18')), lines[0]);
  await page.close();
});

test("labels of ticks are true to their values", async () => {
  const ticks = [[0, 2.5e-4, 5e-4], [0, 0.25, 0.5, 0.75], [0, 10, 20], [100000.5, 100001, 100001.5], [-2e-5, 0, 2e-5], [1.4e-4], [0]];
  const { build } = createRequire(modules + "/")("esbuild");
  const bundled = await build({ entryPoints: [`${modules}/src/ticks.ts`], bundle: true, write: false, format: "cjs" });
  const made = { exports: {} };
  new Function("module", bundled.outputFiles[0].text)(made);
  const labels = ticks.map(made.exports.tickLabels);
  assert.deepEqual(labels, [["0", "2.5e-4", "5.0e-4"], ["0", "0.25", "0.50", "0.75"], ["0", "10", "20"],
    ["1.000005e+5", "1.000010e+5", "1.000015e+5"], ["-2e-5", "0", "2e-5"], ["1.4e-4"], ["0"]]);
});

test("runs no script but its own", async () => {
  const text = readFileSync(`${folder}/alone.html`, "utf8");
  writeFileSync(`${folder}/foreign.html`, text.replace("</body>", "<script>window.foreign = true</script><img src='x' onerror='window.foreign = true'></body>"));
  const { page, message } = await opened("foreign.html");
  assert.equal(message, "");
  assert.equal(await page.evaluate(() => window.foreign), undefined);
  assert.equal(await page.evaluate(() => fetch("data:text/plain,x").then(() => "fetched", () => "refused")), "refused");
  await page.close();
});

test("says what is wrong with a page that is not whole", async () => {
  const text = readFileSync(`${folder}/alone.html`, "utf8");
  const broken = {
    lost: [text.replace(/<script type="text\/plain" id="frame-3">.*?<\/script>\n/, ""), /lacks its data "frame-3"/],
    cut: [text.replace(/(id="radius">)..../, "$1"), /data "radius" of this page have 9 bytes, not 12/],
    bent: [text.replace(/(id="start">)./, "$1!"), /data "start" of this page are broken/],
    header: [text.replace(/(id="scene">)./, "$1["), /data "scene" of this page are broken/],
  };
  for (const [name, [content, expected]] of Object.entries(broken)) {
    assert.notEqual(content, text);
    writeFileSync(`${folder}/${name}.html`, content);
    const { page, message } = await opened(`${name}.html`);
    assert.match(message, expected);
    await page.close();
  }
});

test("says that it needs WebGL", async () => {
  const plain = await launch("--disable-webgl", "--disable-webgl2", "--disable-3d-apis");
  const { page, message } = await opened("alone.html", { from: plain });
  assert.match(message, /gives no WebGL 2/);
  await page.close();
  await plain.close();
});
