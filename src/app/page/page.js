// Charts under the hand: values below the cursor, zoom by dragging, lines hidden by a click on their name.
// Without this script the page shows the drawings beside the data.
"use strict";
(() => {
  const NS = "http://www.w3.org/2000/svg";
  const element = (name, attributes, parent, text) => {
    const made = document.createElementNS(NS, name);
    for (const key in attributes) made.setAttribute(key, attributes[key]);
    if (text !== undefined) made.textContent = text;
    if (parent) parent.append(made);
    return made;
  };
  const html = (name, kind, parent) => {
    const made = document.createElement(name);
    made.className = kind;
    parent.append(made);
    return made;
  };
  // At most seven digits, as the data have; large and small numbers with an exponent.
  const shown = (value, digits = 7) => {
    const short = Number(value.toPrecision(digits));
    const size = Math.abs(short);
    return size !== 0 && (size < 1e-4 || size >= 1e7) ? short.toExponential().replace("e+", "e") : String(short);
  };
  const split = (head) => {
    const found = /^(.*) \[(.*)\]$/.exec(head);
    return found ? [found[1], found[2] === "1" ? "" : ` ${found[2]}`] : [head, ""];
  };

  // Round values between two others.
  const ticks = (low, high, count) => {
    const raw = (high - low) / count;
    const decade = 10 ** Math.floor(Math.log10(raw));
    const step = decade * [1, 2, 5, 10].find((part) => part * decade >= raw * 0.999);
    const found = [];
    for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) found.push(k * step);
    return found.map((value) => Number(value.toPrecision(12)));
  };
  const decades = (low, high) => {
    const found = [];
    for (let k = Math.floor(low); k <= Math.ceil(high); k++) {
      for (const part of high - low < 2 ? [1, 2, 5] : [1]) {
        const place = k + Math.log10(part);
        if (place >= low - 1e-9 && place <= high + 1e-9) found.push(place);
      }
    }
    return found.length > 1 ? found : ticks(low, high, 4);
  };

  class Chart {
    constructor(figure, data) {
      this.data = data;
      this.hidden = new Set();
      const [low, high] = this.range(0);
      const pad = data.lines.length ? 0 : 0.02 * (high - low);
      this.whole = [low - pad, high + pad];
      this.view = this.whole;
      this.drawing = figure.querySelector("svg");
      this.drawing.style.display = "none";
      this.box = html("div", "live", figure);
      this.drawing.before(this.box);
      this.svg = element("svg", { role: "img", "aria-label": data.y }, this.box);
      this.told = html("div", "told", this.box);
      this.again = html("button", "again", this.box);
      this.again.textContent = "whole";
      this.again.onclick = () => this.zoom(this.whole);
      this.names(figure);
      this.listen();
      this.draw();
      new ResizeObserver(() => this.draw()).observe(this.box);
    }

    // Least and greatest value of all visible lines in one direction, within the view in the other one.
    range(side, within) {
      let [low, high] = [Infinity, -Infinity];
      const meet = (x, y) => {
        if (within && (x < within[0] || x > within[1])) return;
        const value = side ? y : x;
        if (value < low) low = value;
        if (value > high) high = value;
      };
      for (const [index, line] of this.data.lines.entries()) {
        if (this.hidden.has(index) || line.guide) continue;
        for (let k = 0; k < line.p.length; k += 2) meet(line.p[k], line.p[k + 1]);
      }
      for (const [x, y] of this.data.dots) meet(x, y);
      return low <= high ? [low, high] : [0, 1];
    }

    names(figure) {
      const named = this.data.lines.map((line, index) => [line, index]).filter(([line]) => line.name);
      if (named.length < 2) return;
      const row = html("div", "names", figure);
      this.box.before(row);
      for (const [line, index] of named) {
        const button = html("button", "", row);
        html("i", `key k${line.color % 6}`, button);
        button.append(line.name);
        button.setAttribute("aria-pressed", "true");
        button.onclick = () => {
          if (!this.hidden.delete(index)) this.hidden.add(index);
          button.setAttribute("aria-pressed", String(!this.hidden.has(index)));
          this.draw();
        };
      }
    }

    zoom(view) {
      if (view[1] > view[0]) this.view = view;
      this.draw();
    }

    draw() {
      const width = Math.max(240, this.box.clientWidth);
      const height = Math.round((this.data.tall ? 0.58 : 0.34) * Math.max(width, 480));
      const log = this.data.log;
      const up = (value) => (log ? Math.log10(value) : value);
      let [low, high] = this.range(1, this.view).map(up);
      const pad = high - low > 1e-9 * Math.max(Math.abs(low), Math.abs(high)) ? 0.06 * (high - low) : 0.1 * Math.abs(low) || 1;
      [low, high] = [low - pad, high + pad];
      const marks = log ? decades(low, high) : ticks(low, high, 6);
      const label = (place) => shown(log ? 10 ** place : place, 6);
      const left = 30 + 7.2 * Math.max(...marks.map((place) => label(place).length));
      const area = { left, right: width - 22, top: this.data.marks.length ? 24 : 8, bottom: height - 42 };
      const [from, to] = this.view[1] > this.view[0] ? this.view : [this.view[0] - 0.5, this.view[0] + 0.5];
      this.x = (value) => area.left + ((value - from) / (to - from)) * (area.right - area.left);
      this.back = (place) => from + ((place - area.left) / (area.right - area.left)) * (to - from);
      this.y = (value) => area.bottom - ((up(value) - low) / (high - low)) * (area.bottom - area.top);
      this.area = area;

      const svg = this.svg;
      svg.replaceChildren();
      svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
      const id = `clip${Chart.count++}`;
      const clip = element("clipPath", { id }, element("defs", {}, svg));
      const frame = { x: area.left, y: area.top, width: area.right - area.left, height: area.bottom - area.top };
      element("rect", frame, clip);
      for (const place of marks) {
        const y = this.y(log ? 10 ** place : place);
        element("line", { x1: area.left, x2: area.right, y1: y, y2: y, class: "grid" }, svg);
        element("text", { x: area.left - 6, y: y + 4, class: "end" }, svg, label(place));
      }
      for (const value of ticks(from, to, Math.max(3, Math.floor(width / 90)))) {
        const x = this.x(value);
        element("line", { x1: x, x2: x, y1: area.top, y2: area.bottom, class: "grid" }, svg);
        element("text", { x, y: area.bottom + 16, class: "middle" }, svg, shown(value, 6));
      }
      element("path", { d: `M${area.left} ${area.top}V${area.bottom}H${area.right}`, class: "axis" }, svg);
      element("text", { x: (area.left + area.right) / 2, y: height - 6, class: "middle" }, svg, this.data.x);
      const middle = (area.top + area.bottom) / 2;
      element("text", { x: 12, y: middle, class: "middle", transform: `rotate(-90 12 ${middle})` }, svg, this.data.y);
      const inside = element("g", { "clip-path": `url(#${id})` }, svg);
      for (const [index, line] of this.data.lines.entries()) {
        if (this.hidden.has(index)) continue;
        let path = "";
        for (let k = 0; k < line.p.length; k += 2) {
          path += `${k ? "L" : "M"}${this.x(line.p[k]).toFixed(2)} ${this.y(line.p[k + 1]).toFixed(2)}`;
        }
        element("path", { d: path, class: line.guide ? "line guide" : `line c${line.color % 6}${line.dashed ? " dashed" : ""}` }, inside);
        if (line.guide) {
          const visible = [];
          for (let k = 0; k < line.p.length; k += 2) {
            const [x, y] = [this.x(line.p[k]), this.y(line.p[k + 1])];
            if (y >= area.top && x <= area.right + 1) visible.push([x, y]);
          }
          const end = visible.pop();
          if (end) element("text", { x: end[0] - 4, y: end[1] + 12, class: "end" }, svg, line.guide);
        }
      }
      for (const [x, y, color] of this.data.dots) {
        element("circle", { cx: this.x(x), cy: this.y(y), r: 3.5, class: `dot c${color % 6}` }, inside);
      }
      for (const [place, text] of this.data.marks) {
        const x = this.x(place);
        element("line", { x1: x, x2: x, y1: area.top, y2: area.bottom, class: "mark" }, inside);
        if (x >= area.left && x <= area.right) element("text", { x, y: area.top - 6, class: "middle" }, svg, text);
      }
      this.hand = element("g", {}, inside);
      this.again.hidden = this.view === this.whole;
      this.told.hidden = true;
    }

    listen() {
      let start = null;
      const place = (event) => {
        const box = this.svg.getBoundingClientRect();
        const x = Math.min(Math.max(event.clientX - box.left, this.area.left), this.area.right);
        return [x, event.clientY - box.top];
      };
      this.svg.onpointerdown = (event) => {
        start = place(event)[0];
        this.svg.setPointerCapture(event.pointerId);
      };
      this.svg.onpointermove = (event) => {
        const [x, y] = place(event);
        if (start !== null && Math.abs(x - start) > 4) this.choose(start, x);
        else this.tell(x, y);
      };
      this.svg.onpointerup = (event) => {
        const x = place(event)[0];
        if (start !== null && Math.abs(x - start) > 4) {
          this.zoom([this.back(Math.min(start, x)), this.back(Math.max(start, x))]);
        }
        start = null;
      };
      this.svg.ondblclick = () => this.zoom(this.whole);
      this.svg.onpointerleave = () => {
        this.hand.replaceChildren();
        this.told.hidden = true;
      };
    }

    choose(from, to) {
      this.told.hidden = true;
      this.hand.replaceChildren();
      const { top, bottom } = this.area;
      const frame = { x: Math.min(from, to), width: Math.abs(to - from), y: top, height: bottom - top, class: "chosen" };
      element("rect", frame, this.hand);
    }

    // Shows the values of all lines at the place of the nearest point, or the nearest dot.
    tell(x, y) {
      const found = [];
      let nearest = null;
      for (const [index, line] of this.data.lines.entries()) {
        if (this.hidden.has(index) || line.guide || !line.p.length) continue;
        let best = 0;
        let [first, last] = [Infinity, -Infinity];
        for (let k = 0; k < line.p.length; k += 2) {
          const place = this.x(line.p[k]);
          if (Math.abs(place - x) < Math.abs(this.x(line.p[best]) - x)) best = k;
          first = Math.min(first, place);
          last = Math.max(last, place);
        }
        // A line that ends elsewhere has no value here.
        if (x < first - 20 || x > last + 20) continue;
        found.push([line.p[best], line.p[best + 1], line.color, line.name]);
      }
      if (!this.data.lines.length) {
        const far = ([a, b]) => Math.hypot(this.x(a) - x, this.y(b) - y);
        for (const dot of this.data.dots) if (!nearest || far(dot) < far(nearest)) nearest = dot;
        if (nearest && far(nearest) < 30) found.push([...nearest, ""]);
      }
      this.hand.replaceChildren();
      this.told.hidden = !found.length;
      if (!found.length) return;
      const { top, bottom, left, right } = this.area;
      const at = this.x(found[0][0]);
      element("line", { x1: at, x2: at, y1: top, y2: bottom, class: "mark" }, this.hand);
      const [[name, unit], [of, its]] = [split(this.data.x), split(this.data.y)];
      this.told.replaceChildren();
      html("div", "", this.told).textContent = `${name} = ${shown(found[0][0])}${unit}`;
      for (const [px, py, color, line] of found) {
        element("circle", { cx: this.x(px), cy: this.y(py), r: 4, class: `dot c${color % 6}` }, this.hand);
        const row = html("div", "", this.told);
        html("i", `key k${color % 6}`, row);
        row.append(`${line || of} ${shown(py)}${its}`);
      }
      const side = at > (left + right) / 2;
      this.told.style.left = side ? "" : `${at + 12}px`;
      this.told.style.right = side ? `${this.box.clientWidth - at + 12}px` : "";
      this.told.style.top = `${top + 4}px`;
    }
  }
  Chart.count = 0;

  for (const data of document.querySelectorAll("figure > script.data")) {
    new Chart(data.parentElement, JSON.parse(data.textContent));
  }
})();
