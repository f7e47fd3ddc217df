// Entry point of the page of beadswim-view: reads the data of the run that the page contains, and connects the controls, the 3D
// view and the plots.

import { Charts } from "./charts";
import { colouring, colourings, unavailableReason, toCss, type Colouring, type ColouringName } from "./colours";
import { download, plotsToCsv } from "./download";
import { flowLegend } from "./flow";
import { beadsAt, isSmooth, framePositionAt, positionsAt, timeAt, wrap, type Point } from "./motion";
import { makePlots } from "./plots";
import { middleBead, PageFault, readScene, type Scene } from "./scene";
import { Stage, type View } from "./stage";

const speeds = [0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10, 25]; // cycles per second

function element<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new PageFault(`This page lacks "${id}": it is not whole. Write it again by beadswim-view.`);
  return found as T;
}

class Player {
  private framePosition = 0; // index of the frame in the view; fractional between two frames
  private clock = 0; // time of the animation [periods]; increases continuously, also if the view shows whole frames only
  private playing = false;
  private picked: number | null = null;
  private colouring: Colouring;
  private paintedFrame = -1;
  private readonly stage: Stage;
  private readonly charts: Charts;
  private readonly last: number;
  private readonly time = element<HTMLInputElement>("time");
  private readonly speed = element<HTMLSelectElement>("speed");
  private readonly colours = element<HTMLSelectElement>("colours");
  private readonly swimmer = element<HTMLInputElement>("swimmer");
  private readonly wrapping = element<HTMLInputElement>("wrap");
  private readonly following = element<HTMLInputElement>("follow");

  constructor(private readonly scene: Scene) {
    this.last = scene.times.length - 1;
    this.stage = new Stage(element<HTMLCanvasElement>("canvas"), scene, element<HTMLCanvasElement>("triad"));
    this.charts = new Charts(element("charts"), (time) => this.seek(framePositionAt(scene, time)));
    this.colouring = colouring(scene, "block");
    this.stage.onPick = (swimmer) => this.pick(swimmer);
    this.fillControls();
    this.listenToControls();
    document.addEventListener("keydown", (event) => this.onKey(event));
    for (const id of ["controls", "panel"]) element(id).hidden = false;
    this.setColours("block");
    this.addFlow();
    this.pick(null);
    this.show(0);
    this.stage.setView("all");
  }

  private fillControls(): void {
    const { scene } = this;
    const counted = (number: number, noun: string) => `${number} ${noun}${number === 1 ? "" : "s"}`;
    const cycles = Number((scene.times[this.last] - scene.times[0]).toPrecision(4));
    const box = scene.box ? `box ${scene.box.map((edge) => Number(edge.toPrecision(6))).join(" × ")} ${scene.lengthUnit}` : scene.space;
    element("title").textContent = document.title = `${scene.file} – Beadswim`;
    element("facts").textContent = `${counted(scene.ids.length, "swimmer")}, ${box}, period ${Number(scene.period.toPrecision(6))}, ` +
      `${counted(scene.times.length, "frame")} over ${counted(cycles, "cycle")}`;
    this.time.max = String(this.last);
    element<HTMLButtonElement>("play").disabled = this.last === 0;
    for (const speed of speeds) this.speed.add(new Option(`${speed} cycles/s`, String(speed)));
    this.speed.value = isSmooth(scene) ? "0.5" : "5";
    for (const name of colourings) {
      const reason = unavailableReason(scene, name);
      const option = new Option(reason ? `${name} (${reason})` : name, name);
      option.disabled = reason !== "";
      this.colours.add(option);
    }
    const periodic = scene.box !== null && scene.periodic.includes(true);
    this.wrapping.checked = periodic;
    this.wrapping.disabled = !periodic;
  }

  private listenToControls(): void {
    element("play").addEventListener("click", () => this.play(!this.playing));
    this.time.addEventListener("input", () => this.seek(Math.round(Number(this.time.value))));
    this.time.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
      if (step) {
        event.preventDefault();
        this.step(step);
      }
    });
    this.colours.addEventListener("change", () => this.setColours(this.colours.value as ColouringName));
    this.swimmer.addEventListener("change", () => this.pickById(this.swimmer.value));
    this.wrapping.addEventListener("change", () => this.show(this.framePosition));
    this.following.addEventListener("change", () => this.show(this.framePosition));
    element("save-picture").addEventListener("click", () => void this.savePicture());
    element("save-numbers").addEventListener("click", () => this.saveNumbers());
    for (const button of document.querySelectorAll<HTMLButtonElement>("[data-view]")) {
      button.addEventListener("click", () => this.stage.setView(button.dataset.view as View));
    }
  }

  private onKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const target = event.target as HTMLElement;
    const onCanvas = target === element("canvas");
    const takesKeys = target.matches("select, input[type=number]") || (event.key === " " && target.matches("button, summary, input[type=checkbox]"));
    if (takesKeys && event.key !== "Escape") return;
    const action = this.actions()[event.key] ?? (onCanvas ? this.cameraActions()[event.key] : undefined);
    if (!action) return;
    event.preventDefault();
    action();
  }

  private actions(): Record<string, () => void> {
    return {
      " ": () => this.play(!this.playing),
      ",": () => this.step(-1),
      ".": () => this.step(1),
      "[": () => this.changeSpeed(-1),
      "]": () => this.changeSpeed(1),
      n: () => this.pickNext(1),
      p: () => this.pickNext(-1),
      Escape: () => this.pick(null),
      w: () => this.wrapping.click(),
      f: () => this.following.click(),
      c: () => this.nextColours(),
      a: () => this.stage.setView("all"),
      x: () => this.stage.setView("x"),
      y: () => this.stage.setView("y"),
      z: () => this.stage.setView("z"),
    };
  }

  private cameraActions(): Record<string, () => void> {
    const angle = Math.PI / 36;
    return {
      ArrowLeft: () => this.stage.turn(-angle, 0),
      ArrowRight: () => this.stage.turn(angle, 0),
      ArrowUp: () => this.stage.turn(0, angle),
      ArrowDown: () => this.stage.turn(0, -angle),
      "+": () => this.stage.zoom(1 / 1.2),
      "=": () => this.stage.zoom(1 / 1.2),
      "-": () => this.stage.zoom(1.2),
    };
  }

  private play(playing: boolean): void {
    if (this.playing === playing || this.last === 0) return;
    this.playing = playing;
    element("play").textContent = playing ? "Pause" : "Play";
    if (!playing) return;
    let previousTime = performance.now();
    const advance = (now: number) => {
      if (!this.playing) return;
      this.clock += (Number(this.speed.value) * (now - previousTime)) / 1000;
      previousTime = now;
      const { times } = this.scene;
      const lastFrameDuration = (times[this.last] - times[0]) / this.last; // mean interval between frames
      if (this.clock > times[this.last] + lastFrameDuration) this.clock = times[0];
      const framePosition = framePositionAt(this.scene, this.clock);
      this.show(isSmooth(this.scene) ? framePosition : Math.floor(framePosition));
      requestAnimationFrame(advance);
    };
    requestAnimationFrame(advance);
  }

  private step(frames: number): void {
    this.play(false);
    const fromFrame = frames > 0 ? Math.floor(this.framePosition) : Math.ceil(this.framePosition);
    this.seek(Math.min(Math.max(fromFrame + frames, 0), this.last));
  }

  private changeSpeed(steps: number): void {
    const index = this.speed.selectedIndex + steps;
    if (index >= 0 && index < speeds.length) this.speed.selectedIndex = index;
  }

  private nextColours(): void {
    const possible = colourings.filter((name) => unavailableReason(this.scene, name) === "");
    const next = possible[(possible.indexOf(this.colours.value as ColouringName) + 1) % possible.length];
    this.colours.value = next;
    this.setColours(next);
  }

  private setColours(name: ColouringName): void {
    this.colouring = colouring(this.scene, name);
    this.paintedFrame = -1;
    this.paint();
    this.showLegend();
  }

  private paint(): void {
    const frame = Math.min(Math.round(this.framePosition), this.last);
    if (frame === this.paintedFrame) return;
    this.paintedFrame = frame;
    this.stage.paint(this.colouring.colours(frame));
  }

  private showLegend(): void {
    const { title, keys, stops, ends } = this.colouring;
    element("legend").hidden = keys.length === 0 && stops.length === 0;
    element("legend-title").textContent = title;
    const bar = element("legend-bar");
    bar.hidden = stops.length === 0;
    bar.style.backgroundImage = stops.length ? `linear-gradient(to right, ${stops.map(toCss).join(", ")})` : "";
    const labels = keys.map(({ name, colour }) => {
      const label = document.createElement("span");
      label.className = "key";
      label.style.setProperty("--key", toCss(colour));
      label.textContent = name;
      return label;
    });
    const scale = ends.map((end) => Object.assign(document.createElement("span"), { textContent: end }));
    element("legend-ends").replaceChildren(...(labels.length ? labels : scale));
  }

  private addFlow(): void {
    const { flow, velocityUnit } = this.scene;
    if (!flow) return;
    const { title, bar, ends } = flowLegend(flow, velocityUnit), shown = element<HTMLInputElement>("flow");
    element("flow-title").textContent = title;
    element("flow-bar").style.backgroundImage = bar;
    element("flow-ends").replaceChildren(...ends.map((end) => Object.assign(document.createElement("span"), { textContent: end })));
    element("flow-control").hidden = element("flow-legend").hidden = false;
    shown.addEventListener("change", () => {
      element("flow-legend").hidden = !shown.checked;
      this.stage.showFlow(shown.checked);
    });
  }

  private fileName(end: string): string {
    const swimmer = this.picked === null ? "" : `-swimmer-${this.scene.ids[this.picked]}`;
    return this.scene.file.replace(/\.h5md$/, "") + swimmer + end;
  }

  private async savePicture(): Promise<void> {
    const picture = await this.stage.picture();
    if (picture) download(this.fileName(`-frame-${Math.round(this.framePosition)}.png`), picture);
  }

  private saveNumbers(): void {
    download(this.fileName(".csv"), new Blob([plotsToCsv(makePlots(this.scene, this.picked))], { type: "text/csv" }));
  }

  private pickById(text: string): void {
    const swimmer = text === "" ? null : this.scene.ids.indexOf(Number(text));
    if (swimmer !== -1) return this.pick(swimmer);
    const { ids } = this.scene;
    const range = ids.reduce(([low, high], id) => [Math.min(low, id), Math.max(high, id)], [Infinity, -Infinity]);
    this.pick(null);
    element("picked").textContent = `There is no swimmer ${text}; ids are ${range[0]} to ${range[1]}.`;
  }

  private pickNext(step: number): void {
    const count = this.scene.ids.length;
    this.pick(this.picked === null ? (step > 0 ? 0 : count - 1) : (this.picked + step + count) % count);
  }

  private pick(swimmer: number | null): void {
    this.picked = swimmer;
    const middle = swimmer === null ? 0 : middleBead(this.scene.shapes[swimmer]);
    const path = swimmer === null ? [] : this.scene.frames.map((_, frame) => beadsAt(this.scene, swimmer, frame)[middle]);
    this.stage.mark(swimmer, path);
    this.swimmer.value = swimmer === null ? "" : String(this.scene.ids[swimmer]);
    this.following.disabled = swimmer === null;
    if (swimmer === null) this.following.checked = false;
    element("picked").textContent = swimmer === null
      ? "Click a swimmer for its stroke, path and turning."
      : `Swimmer ${this.scene.ids[swimmer]}` + (new Set(this.scene.blocks).size > 1 ? `, block ${this.scene.blocks[swimmer]}` : "");
    this.charts.show(makePlots(this.scene, swimmer));
    this.show(this.framePosition);
  }

  private seek(framePosition: number): void {
    this.clock = timeAt(this.scene, framePosition);
    this.show(framePosition);
  }

  private show(framePosition: number): void {
    this.framePosition = framePosition;
    const { positions } = this.stage;
    positionsAt(this.scene, framePosition, positions);
    const unwrappedPosition = this.pickedPosition();
    if (this.wrapping.checked) wrap(this.scene, positions);
    this.showPicked(unwrappedPosition);
    this.paint();
    this.stage.updatePositions();
    const time = timeAt(this.scene, framePosition);
    this.time.value = String(framePosition);
    element("clock").textContent = `cycle ${time.toFixed(3)}, frame ${Math.round(framePosition)} of ${this.last}`;
    this.charts.setTime(time);
  }

  /** Returns the position in the view of the middle bead of the selected swimmer; null if no swimmer is selected. */
  private pickedPosition(): Point | null {
    if (this.picked === null) return null;
    const bead = this.scene.firstBead[this.picked] + middleBead(this.scene.shapes[this.picked]);
    return Array.from(this.stage.positions.subarray(3 * bead, 3 * bead + 3)) as Point;
  }

  /** Shifts the path of the selected swimmer to its periodic image in the view. Centres the view on the swimmer if it is followed. */
  private showPicked(unwrappedPosition: Point | null): void {
    const position = this.pickedPosition();
    if (!position || !unwrappedPosition) return;
    this.stage.shiftPath(position.map((x, a) => x - unwrappedPosition[a]) as Point);
    if (this.following.checked) this.stage.follow(position);
  }
}

function start(): void {
  const message = element("message");
  try {
    new Player(readScene(document));
    message.textContent = "";
  } catch (error) {
    message.classList.add("fault");
    message.textContent = error instanceof PageFault ? error.message : `This page failed: ${error}`;
    if (!(error instanceof PageFault)) throw error;
  }
}

start();
