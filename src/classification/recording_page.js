
// Cursors of the charts on the page of a recording (classify --page). Without this script the page shows everything
// but the cursors. Frequencies are in Hz; places in a chart are in its own pixels, as C++ drew it.
"use strict";

const numbers = JSON.parse(document.getElementById("numbers").textContent);
const spacing = document.getElementById("spacing");
const bands = document.getElementById("bands");
const colours = { cursor: "#b00020", harmonic: "#b00020", band: "#6a3d9a", curve: "#444444", text: "#222222" };
let shiftIsDown = false;

function add(parent, name, attributes, words) {
  const made = document.createElementNS(parent.namespaceURI, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (words !== undefined) made.textContent = words;
  parent.append(made);
  return made;
}

// Returns a step of 1, 2 or 5 times a power of ten, for four to ten numbers on an axis.
function tickStep(length) {
  const power = 10 ** Math.floor(Math.log10(length / 4));
  const steps = length / 4 / power;
  return power * (steps >= 5 ? 5 : steps >= 2 ? 2 : 1);
}

// A chart: `data` as written by C++, [from, to] the shown part of its axis, `at` the cursor's index or null.
class Chart {
  constructor(id, data) {
    this.data = data;
    this.svg = document.querySelector("#" + id + " svg");
    this.values = data.tenths ? data.tenths.map(tenth => tenth / 10) : null;
    this.count = (this.values || data.low).length;
    this.all = this.count * data.step;
    [this.from, this.to, this.at] = [0, this.all, null];
    // A title would cover the chart with a tooltip.
    const title = this.svg.querySelector("title");
    this.svg.setAttribute("aria-label", title.textContent);
    title.remove();
    this.svg.setAttribute("tabindex", "0");
    this.part = add(this.svg, "g", {});
    this.marks = add(this.svg, "g", { "pointer-events": "none" });
    this.output = document.createElement("output");
    this.svg.after(this.output);
    this.listen();
  }

  listen() {
    this.svg.addEventListener("pointermove", event => this.moveTo(this.placeOf(event), event.shiftKey));
    this.svg.addEventListener("keydown", event => this.press(event));
    this.svg.addEventListener("dblclick", () => this.show(0, this.all));
    if (this.values) this.svg.addEventListener("wheel", event => this.zoom(event), { passive: false });
  }

  pixel(place) {
    return this.data.left + (place - this.from) / (this.to - this.from) * this.data.width;
  }

  placeOf(event) {
    const box = this.svg.getBoundingClientRect();
    const pixel = (event.clientX - box.left) * this.svg.viewBox.baseVal.width / box.width;
    return this.from + (pixel - this.data.left) / this.data.width * (this.to - this.from);
  }

  // The cursor takes the highest bin on the pixel: a thin line cannot be hit otherwise.
  moveTo(place, withShift) {
    shiftIsDown = withShift;
    const half = (this.to - this.from) / this.data.width;
    const index = p => Math.max(0, Math.min(this.count - 1, Math.round(p / this.data.step)));
    let best = this.values ? index(place) : Math.min(this.count - 1, Math.max(0, Math.floor(place / this.data.step)));
    for (let i = index(place - half); this.values && i <= index(place + half); ++i) {
      if (this.values[i] > this.values[best]) best = i;
    }
    this.at = best;
    this.draw();
  }

  press(event) {
    const step = { ArrowLeft: -1, ArrowRight: 1, PageUp: 10, PageDown: -10 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    shiftIsDown = event.shiftKey;
    this.at = Math.max(0, Math.min(this.count - 1, (this.at === null ? 0 : this.at) + step));
    this.draw();
  }

  zoom(event) {
    event.preventDefault();
    const place = this.placeOf(event);
    const factor = event.deltaY < 0 ? 0.8 : 1.25;
    const length = Math.max(20 * this.data.step, Math.min(this.all, (this.to - this.from) * factor));
    const from = place - (place - this.from) * length / (this.to - this.from);
    const start = Math.max(0, Math.min(this.all - length, from));
    this.show(start, start + length);
  }

  // Draws a part of the axis over the chart of C++, or removes it where all is shown.
  show(from, to) {
    [this.from, this.to] = [from, to];
    this.part.replaceChildren();
    if (this.values && to - from < this.all * 0.999) this.drawPart();
    this.draw();
  }

  drawPart() {
    const { left, top, width, height, lowest, highest, step } = this.data;
    add(this.part, "rect", { x: left, y: 0, width: width + 9, height: top, fill: "#ffffff" });
    add(this.part, "rect", { x: left, y: top, width, height, fill: "#ffffff", stroke: "#999999" });
    add(this.part, "rect", { x: left - 20, y: top + height + 5, width: width + 30, height: 30, fill: "#ffffff" });
    for (const [unit, size, y] of [["Hz", 1, 14], ["orders", numbers.shaft_hz, 28]]) {
      const tick = tickStep((this.to - this.from) / size);
      for (let i = Math.ceil(this.from / size / tick); this.pixel(i * tick * size) < left + width - 46; ++i) {
        const words = String(Number((i * tick).toPrecision(9)));
        this.label(this.part, this.pixel(i * tick * size), top + height + y, words, "middle");
      }
      this.label(this.part, left + width, top + height + y, unit, "end");
    }
    for (const [row, [name, hz]] of numbers.lines.entries()) {
      for (let n = 1; n <= 3; ++n) {
        if (n * hz < this.from || n * hz > this.to) continue;
        this.line(this.part, n * hz, "#0072b2", "2 3");
        this.label(this.part, this.pixel(n * hz) + 2, top - 4 - 11 * row, n === 1 ? name : n + "\u00d7" + name, "start");
      }
    }
    const y = value => top + height - (Math.max(lowest, value) - lowest) / (highest - lowest) * height;
    const points = [];
    for (let i = Math.ceil(this.from / step); i < this.count && i * step <= this.to; ++i) {
      points.push(this.pixel(i * step).toFixed(1) + "," + Math.max(top, y(this.values[i])).toFixed(1));
    }
    add(this.part, "polyline", { points: points.join(" "), fill: "none", stroke: colours.curve });
  }

  label(parent, x, y, words, anchor) {
    add(parent, "text", { x, y, "font-size": 10, "text-anchor": anchor, fill: colours.text }, words);
  }

  line(parent, place, colour, dashes) {
    const x = this.pixel(place);
    const { top, height } = this.data;
    add(parent, "line", { x1: x, x2: x, y1: top, y2: top + height, stroke: colour, "stroke-dasharray": dashes });
  }

  // Marks multiples or neighbours of the cursor that lie in the shown part.
  mark(place, words, colour, dashes, y) {
    if (place < Math.max(this.from, this.data.step) || place > this.to) return;
    this.line(this.marks, place, colour, dashes);
    this.label(this.marks, this.pixel(place) + 2, y, words, "start");
  }

  draw() {
    this.marks.replaceChildren();
    if (this.at === null) return;
    const { step, top, low, high } = this.data;
    if (!this.values) {
      const time = (this.at + 0.5) * step;
      this.line(this.marks, time, colours.cursor, "none");
      this.output.textContent = time.toFixed(4) + " s, turn " + (time * numbers.shaft_hz).toFixed(1) +
        ": from " + low[this.at] + " to " + high[this.at];
      return;
    }
    const place = this.at * step;
    if (place >= this.from && place <= this.to) this.line(this.marks, place, colours.cursor, "none");
    for (let n = 2; n <= 8; ++n) this.mark(n * place, n + "\u00d7", colours.harmonic, "5 3", top + 11);
    const found = [this.words(place, "cursor")];
    for (const n of [2, 3]) if (n * place < this.all) found.push(this.words(n * place, n + "\u00d7"));
    if (bands.checked || shiftIsDown) {
      for (const k of [-3, -2, -1, 1, 2, 3]) {
        const sign = (k < 0 ? "\u2212" : "+") + Math.abs(k);
        const band = place + k * Number(spacing.value);
        this.mark(band, sign, colours.band, "1 2", top + 23);
        if (band > 0 && band < this.all && Math.abs(k) === 1) found.push(this.words(band, "side band " + sign));
      }
    }
    this.output.textContent = found.join("; ");
  }

  words(hz, name) {
    const value = this.values[Math.min(this.count - 1, Math.round(hz / this.data.step))];
    return name + " " + hz.toFixed(2) + " Hz (" + (hz / numbers.shaft_hz).toFixed(3) + " orders) " +
      value.toFixed(1) + " dB";
  }
}

const charts = ["waveform", "spectrum", "envelope"].filter(id => numbers[id]).map(id => new Chart(id, numbers[id]));
const redraw = () => charts.forEach(chart => chart.draw());
for (const control of [spacing, bands]) control.addEventListener("input", redraw);
for (const type of ["keydown", "keyup"]) {
  document.addEventListener(type, event => {
    if (event.key !== "Shift") return;
    shiftIsDown = type === "keydown";
    redraw();
  });
}
document.getElementById("controls").hidden = false;
