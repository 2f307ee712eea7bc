// Charts and maps under the hand: values below the cursor, zoom by dragging, lines hidden by a click on their name.
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
    return found.length > 1 ? found : ticks(10 ** low, 10 ** high, 4).map(Math.log10);
  };
  // A value on an axis, even or logarithmic, as a number that grows evenly along it; and back.
  const even = (log) => (value) => (log ? Math.log10(value) : value);
  const plain = (log) => (place) => (log ? 10 ** place : place);

  // Values that are told at once.
  const MOST = 12;
  // Corners of the markers of points about their middle.
  const CORNERS = {
    triangle: [[0, -5.6], [5.2, 3.8], [-5.2, 3.8]],
    diamond: [[0, -5.8], [5.8, 0], [0, 5.8], [-5.8, 0]],
    square: [[-4.2, -4.2], [4.2, -4.2], [4.2, 4.2], [-4.2, 4.2]],
  };
  const marker = (kind, x, y, attributes, parent) => {
    if (!CORNERS[kind]) return element("circle", { cx: x, cy: y, r: 3.5, ...attributes }, parent);
    const points = CORNERS[kind].map(([dx, dy]) => `${x + dx},${y + dy}`).join(" ");
    return element("polygon", { points, ...attributes }, parent);
  };

  // The rows of names, counted from the chart, that are centred at places and so wide.
  const rows = (names) => {
    const spans = names.map(([place, wide], index) => ({ from: place - wide / 2, to: place + wide / 2, index }));
    const ends = [];
    const found = [];
    for (const { from, to, index } of spans.sort((a, b) => a.from - b.from)) {
      const free = ends.findIndex((end) => end <= from);
      found[index] = free < 0 ? ends.length : free;
      ends[found[index]] = to;
    }
    return found;
  };

  class Chart {
    constructor(figure, data) {
      this.data = data;
      this.hidden = new Set();
      // Points that no line joins are told one by one, as those which tell what they are.
      this.single = data.lines.some((line) => line.told) || !data.lines.some((line) => line.joined);
      const [across, back] = [even(data.logx), plain(data.logx)];
      const [low, high] = this.range(0).map(across);
      const pad = this.single && !data.cells ? 0.04 * (high - low) : 0;
      this.whole = [low - pad, high + pad].map(back);
      this.view = this.whole;
      this.drawing = figure.querySelector("svg");
      this.drawing.style.display = "none";
      this.box = html("div", "live", figure);
      this.drawing.before(this.box);
      this.svg = element("svg", { role: "img", "aria-label": data.cells ? data.cells.what : data.y }, this.box);
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
      if (this.data.cells) return [this.data.cells.x, this.data.cells.y].map((edges) => [edges[0], edges[edges.length - 1]])[side];
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
      return low <= high ? [low, high] : [(side ? this.data.log : this.data.logx) ? 0.1 : 0, 1];
    }

    names(figure) {
      const named = new Map();
      for (const [index, line] of this.data.lines.entries()) {
        if (line.name) named.set(line.name, [...(named.get(line.name) || []), index]);
      }
      this.named = named.size > 0;
      if (named.size < 2) return;
      for (const keys of figure.querySelectorAll("figcaption .keys")) keys.hidden = true;
      const row = html("div", "names", figure);
      this.box.before(row);
      for (const [name, indices] of named) {
        const line = this.data.lines[indices[0]];
        const button = html("button", "", row);
        if (line.dots) this.key(line, button);
        else html("i", `key k${line.color % 6}`, button);
        button.append(name);
        button.setAttribute("aria-pressed", "true");
        button.onclick = () => {
          const hides = !this.hidden.has(indices[0]);
          for (const index of indices) {
            if (hides) this.hidden.add(index);
            else this.hidden.delete(index);
          }
          button.setAttribute("aria-pressed", String(!hides));
          this.draw();
        };
      }
    }

    // The marker of a line's points, for its name.
    key(line, parent) {
      const small = element("svg", { viewBox: "-7 -7 14 14", class: "marker" }, parent);
      marker(line.dots, 0, 0, { class: `dot c${line.color % 6}`, opacity: line.shade ?? 1 }, small);
    }

    zoom(view) {
      if (view[1] > view[0]) this.view = view;
      this.draw();
    }

    draw() {
      const width = Math.max(240, this.box.clientWidth);
      const height = Math.round((this.data.tall ? 0.58 : 0.34) * Math.max(width, 480));
      const { log, logx, cells } = this.data;
      const up = even(log);
      let [low, high] = this.range(1, this.view).map(up);
      let pad = high - low > 1e-9 * Math.max(Math.abs(low), Math.abs(high)) ? 0.06 * (high - low) : 0.1 * Math.abs(low) || 1;
      if (cells) pad = 0;
      [low, high] = [low - pad, high + pad];
      const marks = log ? decades(low, high) : ticks(low, high, 6);
      const label = (place) => shown(log ? 10 ** place : place, 6);
      const left = 30 + 7.2 * Math.max(...marks.map((place) => label(place).length));
      const area = { left, right: width - 22, top: 8, bottom: height - 42 };
      const across = even(logx);
      let [from, to] = this.view.map(across);
      if (!(to > from)) [from, to] = [from - 0.5, from + 0.5];
      this.x = (value) => area.left + ((across(value) - from) / (to - from)) * (area.right - area.left);
      this.back = (place) => plain(logx)(from + ((place - area.left) / (area.right - area.left)) * (to - from));
      const lanes = rows(this.data.marks.map(([place, text]) => [this.x(place), 7 * (text.length + 1)]));
      if (lanes.length) area.top = 24 + 15 * Math.max(...lanes);
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
      const most = Math.max(3, Math.floor(width / 90));
      let values = logx ? decades(from, to).map(plain(true)) : ticks(from, to, most);
      values = values.filter((_, index) => index % Math.ceil(values.length / (1.5 * most)) === 0);
      for (const value of values) {
        const x = this.x(value);
        element("line", { x1: x, x2: x, y1: area.top, y2: area.bottom, class: "grid" }, svg);
        element("text", { x, y: area.bottom + 16, class: "middle" }, svg, shown(value, 6));
      }
      element("path", { d: `M${area.left} ${area.top}V${area.bottom}H${area.right}`, class: "axis" }, svg);
      element("text", { x: (area.left + area.right) / 2, y: height - 6, class: "middle" }, svg, this.data.x);
      const middle = (area.top + area.bottom) / 2;
      element("text", { x: 12, y: middle, class: "middle", transform: `rotate(-90 12 ${middle})` }, svg, this.data.y);
      const inside = element("g", { "clip-path": `url(#${id})` }, svg);
      if (cells) this.cells(inside);
      for (const [index, line] of this.data.lines.entries()) {
        if (this.hidden.has(index)) continue;
        let path = "";
        for (let k = 0; k < line.p.length; k += 2) {
          path += `${k ? "L" : "M"}${this.x(line.p[k]).toFixed(2)} ${this.y(line.p[k + 1]).toFixed(2)}`;
        }
        const kind = line.guide ? "line guide" : `line c${line.color % 6}${line.dashed ? " dashed" : ""}`;
        const opacity = line.shade ?? 1;
        if (line.joined || line.guide) element("path", { d: path, class: kind, opacity }, inside);
        for (let k = 0; line.dots && k < line.p.length; k += 2) {
          const dot = line.hollow && line.hollow[k / 2] ? "hollow" : "dot";
          marker(line.dots, this.x(line.p[k]), this.y(line.p[k + 1]), { class: `${dot} c${line.color % 6}`, opacity }, inside);
        }
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
      for (const [index, [place, text]] of this.data.marks.entries()) {
        const x = this.x(place);
        element("line", { x1: x, x2: x, y1: area.top, y2: area.bottom, class: "mark" }, inside);
        if (x >= area.left && x <= area.right) element("text", { x, y: area.top - 6 - 15 * lanes[index], class: "middle" }, svg, text);
      }
      this.hand = element("g", {}, inside);
      this.again.hidden = this.view === this.whole;
      this.told.hidden = true;
    }

    // Cells of a map, with their colours, which are a scale.
    cells(parent) {
      const { x, y, colors } = this.data.cells;
      const group = element("g", { "shape-rendering": "crispEdges" }, parent);
      for (const [cell, color] of colors.entries()) {
        const [i, j] = [cell % (x.length - 1), Math.floor(cell / (x.length - 1))];
        const [left, right, bottom, top] = [this.x(x[i]), this.x(x[i + 1]), this.y(y[j]), this.y(y[j + 1])];
        element("rect", { x: left, y: top, width: right - left, height: bottom - top, style: `fill: ${color}` }, group);
      }
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

    // Shows the values of all lines at the place of the nearest point, or those of the nearest point or cell alone.
    tell(x, y) {
      this.hand.replaceChildren();
      const found = this.data.cells || this.single ? [] : this.over(x, y);
      if (this.data.cells) this.tellCell(x, y);
      else if (this.single) this.tellPoint(x, y);
      else if (found.length) {
        const at = this.x(found[0][0]);
        element("line", { x1: at, x2: at, y1: this.area.top, y2: this.area.bottom, class: "mark" }, this.hand);
        this.say(at, found[0][0], found);
      } else this.told.hidden = true;
    }

    // The nearest points of the lines that have a value at a place, of many those that are nearest to the cursor.
    over(x, y) {
      const found = [];
      for (const [index, line] of this.data.lines.entries()) {
        if (this.hidden.has(index) || !line.joined || line.guide || !line.p.length) continue;
        if (this.named && !line.name) continue;
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
      const far = ([, value]) => Math.abs(this.y(value) - y);
      const most = [...found].sort((a, b) => far(a) - far(b)).slice(0, MOST);
      return found.filter((one) => most.includes(one));
    }

    tellPoint(x, y) {
      let [nearest, least] = [null, 30];
      for (const [index, line] of this.data.lines.entries()) {
        if (this.hidden.has(index) || line.guide) continue;
        for (let k = 0; k < line.p.length; k += 2) {
          const far = Math.hypot(this.x(line.p[k]) - x, this.y(line.p[k + 1]) - y);
          // Of those at one place the last one is above the others.
          if (far <= least) [nearest, least] = [[line.p[k], line.p[k + 1], line.color, line.name, line.told && line.told[k / 2]], far];
        }
      }
      if (nearest) this.say(this.x(nearest[0]), nearest[0], [nearest], nearest[4]);
      else this.told.hidden = true;
    }

    tellCell(x, y) {
      const { x: across, y: up, at, told, what } = this.data.cells;
      // The places of the edges of the cells ascend to the right, and descend.
      const inside = (places, place) => places.findIndex((edge, k) => k > 0 && (places[k - 1] - place) * (edge - place) <= 0) - 1;
      const [i, j] = [inside(across.map(this.x), x), inside(up.map(this.y), y)];
      this.told.hidden = i < 0 || j < 0;
      if (this.told.hidden) return;
      const cell = i + j * at[0].length;
      const [left, right, bottom, top] = [this.x(across[i]), this.x(across[i + 1]), this.y(up[j]), this.y(up[j + 1])];
      element("rect", { x: left, y: top, width: right - left, height: bottom - top, class: "frame" }, this.hand);
      const value = (head, number) => `${split(head)[0]} = ${shown(number)}${split(head)[1]}`;
      const [name, unit] = split(what);
      this.rows(x, [value(this.data.x, at[0][i]), value(this.data.y, at[1][j]), `${name} ${told[cell]}${unit}`]);
    }

    // Points with their values, below the place that they have in common and what is there.
    say(at, place, points, what) {
      const [[name, unit], [of, its]] = [split(this.data.x), split(this.data.of || this.data.y)];
      const rows = this.rows(at, [...(what ? [what] : []), `${name} = ${shown(place)}${unit}`]);
      for (const [px, py, color, line] of points) {
        element("circle", { cx: this.x(px), cy: this.y(py), r: 4.5, class: `dot c${color % 6}` }, this.hand);
        const row = html("div", "", rows);
        html("i", `key k${color % 6}`, row);
        row.append(`${(!what && line) || of} ${shown(py)}${its}`);
      }
    }

    // Shows lines of text beside a place.
    rows(at, texts) {
      const { top, left, right } = this.area;
      this.told.hidden = false;
      this.told.replaceChildren();
      for (const text of texts) html("div", "", this.told).textContent = text;
      const side = at > (left + right) / 2;
      this.told.style.left = side ? "" : `${at + 12}px`;
      this.told.style.right = side ? `${this.box.clientWidth - at + 12}px` : "";
      this.told.style.top = `${top + 4}px`;
      return this.told;
    }
  }
  Chart.count = 0;

  for (const data of document.querySelectorAll("figure > script.data")) {
    new Chart(data.parentElement, JSON.parse(data.textContent));
  }
})();
