// The page of beadswim-view: reads the run that it holds, and joins controls, picture and plots.

import { Charts } from "./charts";
import { colouring, colourings, reasonAgainst, toCss, type Colouring, type ColouringName } from "./colours";
import { beadsAt, isSmooth, momentOf, positionsAt, timeAt, wrap, type Point } from "./motion";
import { plotsOf } from "./plots";
import { PageFault, readScene, type Scene } from "./scene";
import { Stage, type View } from "./stage";

const speeds = [0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10, 25]; // cycles a second

function element<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new PageFault(`This page lacks "${id}": it is not whole. Write it again by beadswim-view.`);
  return found as T;
}

class Player {
  private moment = 0; // that is shown
  private clock = 0; // what playing goes by [periods]: between frames too, where the picture jumps
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
    this.stage = new Stage(element<HTMLCanvasElement>("canvas"), scene);
    this.charts = new Charts(element("charts"), (time) => this.seek(momentOf(scene, time)));
    this.colouring = colouring(scene, "block");
    this.stage.onPick = (swimmer) => this.pick(swimmer);
    this.fillControls();
    this.listenToControls();
    document.addEventListener("keydown", (event) => this.onKey(event));
    for (const id of ["controls", "panel"]) element(id).hidden = false;
    this.setColours("block");
    this.pick(null);
    this.show(0);
    this.stage.look("all");
  }

  private fillControls(): void {
    const { scene } = this;
    const swimmers = `${scene.ids.length} swimmer${scene.ids.length === 1 ? "" : "s"}`;
    const box = scene.box ? `box ${scene.box.map((edge) => Number(edge.toPrecision(6))).join(" × ")} ${scene.lengthUnit}` : "open space";
    element("title").textContent = document.title = `${scene.file} – Beadswim`;
    element("facts").textContent = `${swimmers}, ${box}, period ${Number(scene.period.toPrecision(6))}, ` +
      `${scene.times.length} frame${this.last === 0 ? "" : "s"} over ${Number((scene.times[this.last] - scene.times[0]).toPrecision(4))} cycles`;
    this.time.max = String(this.last);
    element<HTMLButtonElement>("play").disabled = this.last === 0;
    for (const speed of speeds) this.speed.add(new Option(`${speed} cycles/s`, String(speed)));
    this.speed.value = isSmooth(scene) ? "0.5" : "5";
    for (const name of colourings) {
      const reason = reasonAgainst(scene, name);
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
    this.wrapping.addEventListener("change", () => this.show(this.moment));
    this.following.addEventListener("change", () => this.show(this.moment));
    for (const button of document.querySelectorAll<HTMLButtonElement>("[data-view]")) {
      button.addEventListener("click", () => this.stage.look(button.dataset.view as View));
    }
  }

  private onKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const target = event.target as HTMLElement;
    const onCanvas = target === element("canvas");
    const takesKeys = target.matches("select, input[type=number]") || (event.key === " " && target.matches("button, summary, input[type=checkbox]"));
    if (takesKeys && event.key !== "Escape") return;
    const act = this.actions()[event.key] ?? (onCanvas ? this.cameraActions()[event.key] : undefined);
    if (!act) return;
    event.preventDefault();
    act();
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
      a: () => this.stage.look("all"),
      x: () => this.stage.look("x"),
      y: () => this.stage.look("y"),
      z: () => this.stage.look("z"),
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
    let then = performance.now();
    const advance = (now: number) => {
      if (!this.playing) return;
      this.clock += (Number(this.speed.value) * (now - then)) / 1000;
      then = now;
      const { times } = this.scene;
      const beyond = (times[this.last] - times[0]) / this.last; // for which the last frame is shown
      if (this.clock > times[this.last] + beyond) this.clock = times[0];
      const moment = momentOf(this.scene, this.clock);
      this.show(isSmooth(this.scene) ? moment : Math.floor(moment));
      requestAnimationFrame(advance);
    };
    requestAnimationFrame(advance);
  }

  private step(frames: number): void {
    this.play(false);
    const from = frames > 0 ? Math.floor(this.moment) : Math.ceil(this.moment);
    this.seek(Math.min(Math.max(from + frames, 0), this.last));
  }

  private changeSpeed(steps: number): void {
    const index = this.speed.selectedIndex + steps;
    if (index >= 0 && index < speeds.length) this.speed.selectedIndex = index;
  }

  private nextColours(): void {
    const possible = colourings.filter((name) => reasonAgainst(this.scene, name) === "");
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
    const frame = Math.min(Math.round(this.moment), this.last);
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
    const path = swimmer === null ? [] : this.scene.frames.map((_, frame) => beadsAt(this.scene, swimmer, frame)[1]);
    this.stage.mark(swimmer, path);
    this.swimmer.value = swimmer === null ? "" : String(this.scene.ids[swimmer]);
    this.following.disabled = swimmer === null;
    if (swimmer === null) this.following.checked = false;
    element("picked").textContent = swimmer === null
      ? "Click a swimmer for its stroke, path and turning."
      : `Swimmer ${this.scene.ids[swimmer]}, block ${this.scene.blocks[swimmer]}`;
    this.charts.show(plotsOf(this.scene, swimmer));
    this.show(this.moment);
  }

  private seek(moment: number): void {
    this.clock = timeAt(this.scene, moment);
    this.show(moment);
  }

  private show(moment: number): void {
    this.moment = moment;
    const { positions } = this.stage;
    positionsAt(this.scene, moment, positions);
    const unwrapped = this.pickedPlace();
    if (this.wrapping.checked) wrap(this.scene, positions);
    this.showPicked(unwrapped);
    this.paint();
    this.stage.moved();
    const time = timeAt(this.scene, moment);
    this.time.value = String(moment);
    element("clock").textContent = `cycle ${time.toFixed(3)}, frame ${Math.round(moment)} of ${this.last}`;
    this.charts.setTime(time);
  }

  /** Of the picked swimmer's middle bead, as it stands in the picture. */
  private pickedPlace(): Point | null {
    if (this.picked === null) return null;
    const first = 9 * this.picked + 3;
    return Array.from(this.stage.positions.subarray(first, first + 3)) as Point;
  }

  /** Puts the path where the swimmer is shown. */
  private showPicked(unwrapped: Point | null): void {
    const place = this.pickedPlace();
    if (!place || !unwrapped) return;
    this.stage.shiftPath(place.map((x, a) => x - unwrapped[a]) as Point);
    if (this.following.checked) this.stage.follow(place);
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
