// A scene that moves: pictures of a run, or the modes about an equilibrium.
"use strict";
(() => {
  const decoded = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
  const shown = (value, digits = 4) => {
    const short = Number(value.toPrecision(digits));
    const size = Math.abs(short);
    return size !== 0 && (size < 1e-3 || size >= 1e7) ? short.toExponential().replace("e+", "e") : String(short);
  };
  const PREFIXES = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""]];
  const quantity = (value, unit) => {
    if (unit === "1") return shown(value);
    const [factor, prefix] = PREFIXES.find(([factor]) => Math.abs(value) >= factor) || [1, ""];
    return `${shown(value / factor)} ${prefix}${unit}`;
  };
  // From the least to the greatest value; seen on white and on black.
  const STOPS = [[59, 99, 214], [38, 160, 175], [92, 178, 84], [221, 158, 32], [205, 52, 42]];
  const colour = (part) => {
    const place = Math.min(Math.max(part, 0), 1) * (STOPS.length - 1);
    const at = Math.min(Math.floor(place), STOPS.length - 2);
    const mixed = STOPS[at].map((low, k) => Math.round(low + (place - at) * (STOPS[at + 1][k] - low)));
    return `rgb(${mixed.join(",")})`;
  };
  const SHADES = Array.from({ length: 256 }, (_, k) => colour(k / 255));
  const make = (name, parent, set = {}) => {
    const made = document.createElement(name);
    for (const key in set) made[key] = set[key];
    parent.append(made);
    return made;
  };
  const UNKNOWN = 65535;

  class View {
    constructor(host, data) {
      this.data = data;
      this.raw = new Uint16Array(decoded(data.shots || ""));
      this.rest = new Float32Array(decoded(data.rest));
      this.poses = new Float64Array(decoded(data.poses));
      this.acting = new Float32Array(decoded(data.acting || ""));
      this.total = this.rest.length / 3;
      let at = 0;
      let values = 0;
      for (const curve of data.curves) {
        [curve.from, curve.values] = [at, curve.told ? values : -1];
        at += curve.points;
        if (curve.told) values += curve.points;
      }
      this.told = values;
      this.size = 3 * this.total + data.quantities.length * values;
      this.shapes = data.modes && data.modes.map((mode) => new Float32Array(decoded(mode.shape)));
      this.pictures = data.times.length;
      this.loads = data.signs.filter((sign) => sign.kind !== "joint" && sign.kind !== "spread");
      this.largest = { line: 0, force: 0, moment: 0, gravity: 0 };
      for (let k = 0; k < this.acting.length; k += 3) {
        const kind = this.loads[(k / 3) % this.loads.length].kind;
        this.largest[kind] = Math.max(this.largest[kind], Math.hypot(...this.acting.subarray(k, k + 3)));
      }
      [this.shot, this.phase, this.playing, this.held, this.before] = [0, 0, true, null, null];
      this.build(host);
      this.measure();
      this.draw();
      new ResizeObserver(() => this.draw()).observe(this.stage);
      requestAnimationFrame((now) => this.frame(now));
    }

    build(host) {
      const data = this.data;
      // Above the drawing, so that nothing is hidden.
      this.legend = make("div", host, { className: "legend", hidden: true });
      this.facts = make("dl", host, { className: "facts", hidden: true });
      this.stage = make("div", host, { className: "stage" });
      this.canvas = make("canvas", this.stage);
      this.canvas.setAttribute("aria-label", data.title);
      this.pen = this.canvas.getContext("2d");
      this.tip = make("div", this.stage, { className: "tip", hidden: true });
      const form = make("form", host, { onsubmit: () => false });
      const label = (text, title = "") => make("label", form, { textContent: text, title });
      this.play = make("button", form, { type: "button", className: "play", textContent: "Pause" });
      this.play.onclick = () => {
        this.playing = !this.playing;
        this.play.textContent = this.playing ? "Pause" : "Play";
      };
      if (this.shapes) {
        this.mode = make("select", label("mode"), { className: "mode" });
        data.modes.forEach((mode, k) => this.mode.add(new Option(mode.name, k)));
        this.mode.onchange = () => this.draw();
      } else {
        const row = label("");
        row.className = "time";
        this.slider = make("input", row, { type: "range", min: 0, max: this.pictures - 1, step: 1, value: 0 });
        this.slider.setAttribute("aria-label", "time");
        this.slider.oninput = () => {
          this.shot = Number(this.slider.value);
          this.clock = data.times[this.shot] - data.times[0];
          this.draw();
        };
        this.now = make("output", row);
      }
      const factors = [0.001, 0.01, 0.1, 0.3, 1, 3, 10, 30, 100, 1000, 10000, 100000];
      this.speed = make("select", label("speed", "Times true time"), { className: "speed" });
      const span = this.pictures > 1 ? data.times[this.pictures - 1] - data.times[0] : 0;
      // About twelve seconds for the whole of it; of a mode a period in two seconds.
      const apart = (factor) => Math.abs(Math.log(span / factor / 12));
      const steps = this.shapes ? [0.1, 0.3, 1, 3] : factors;
      for (const factor of steps) {
        this.speed.add(new Option(this.shapes ? `${factor} ×` : factor === 1 ? "true time" : `${factor} × true time`, factor));
      }
      this.speed.value = this.shapes || !(span > 0) ? 1 : factors.reduce((best, factor) => (apart(factor) < apart(best) ? factor : best));
      [this.span, this.clock] = [span, 0];
      if (data.quantities.length) {
        this.quantity = make("select", label("colour"), { className: "quantity" });
        data.quantities.forEach((of, k) => this.quantity.add(new Option(`${of.name} [${of.unit}]`, k)));
        this.quantity.add(new Option("by kind", -1));
        this.quantity.onchange = () => this.draw();
      }
      if (data.magnified) {
        const row = label("deformation", data.magnified);
        this.factor = make("input", row, { type: "range", min: this.shapes ? -1 : 0, max: this.shapes ? 1 : 3, step: 0.01, value: 0, className: "magnify" });
        this.factor.oninput = () => this.draw();
        this.times = make("output", row);
      }
      this.seen = make("select", label("seen from"), { className: "seen" });
      this.choices = [];
      data.frames.forEach((name, frame) => {
        this.choices.push({ frame, axes: frame, text: frame ? `${name} and its axes` : name });
        if (frame) this.choices.push({ frame, axes: 0, text: `origin of ${name}` });
      });
      this.choices.forEach((choice, k) => this.seen.add(new Option(choice.text, k)));
      this.seen.value = this.choices.findIndex((choice) => choice.frame === data.followed && choice.axes === 0);
      this.seen.onchange = () => {
        this.measure();
        this.draw();
      };
      this.show = {};
      const kinds = [
        ["frames", "frames", data.frames.length > 1, data.frames.length <= 12],
        ["joints", "joints", data.signs.some((sign) => sign.kind === "joint"), true],
        ["loads", "loads", this.loads.length > 0, true],
        ["rigid", "rigid bodies", data.curves.some((curve) => !curve.flexible && !curve.hidden), true],
        ["undeformed", this.shapes ? "equilibrium" : "undeformed", Boolean(data.magnified), Boolean(this.shapes)],
      ];
      for (const [key, text, isThere, isOn] of kinds) {
        if (!isThere) continue;
        const row = label("");
        this.show[key] = make("input", row, { type: "checkbox", checked: isOn, className: key });
        row.append(text);
        this.show[key].onchange = () => this.draw();
      }
      const row = label("stretch z", "Places along this axis are drawn farther apart");
      this.stretch = make("input", row, { type: "range", min: 0, max: 3, step: 0.05, value: 0, className: "stretch" });
      this.stretch.oninput = () => this.draw();
      this.stretched = make("output", row);
      make("button", form, { type: "button", textContent: "Reset view" }).onclick = () => {
        this.home();
        this.draw();
      };
      for (const text of data.notes) make("p", host, { className: "told", textContent: text });
      this.listen();
    }

    // Origin and rotation (rows) of a frame in a picture.
    pose(shot, frame) {
      const at = 12 * (shot * this.data.frames.length + frame);
      return this.poses.subarray(at, at + 12);
    }

    isOn(key) {
      return Boolean(this.show[key] && this.show[key].checked);
    }

    // Points of a picture relative to what stands still, in its axes, with the deformation times a factor.
    points(shot, factor, phase = null) {
      const choice = this.choices[this.seen.value];
      const [axes, origin] = [this.pose(shot, choice.axes), this.pose(shot, choice.frame)];
      const out = new Float64Array(3 * this.total);
      const { low, high } = this.data;
      const shape = phase === null ? null : this.shapes[this.mode.value];
      const [c, s] = [Math.cos(phase), Math.sin(phase)];
      for (const curve of this.data.curves) {
        const pose = this.pose(shot, curve.frame);
        for (let i = curve.from; i < curve.from + curve.points; i++) {
          let [x, y, z] = [this.rest[3 * i], this.rest[3 * i + 1], this.rest[3 * i + 2]];
          if (!this.shapes && factor !== 0) {
            const at = shot * this.size + 3 * i;
            const [l, h] = [low[curve.frame], high[curve.frame]];
            x += factor * (l[0] + ((h[0] - l[0]) * this.raw[at]) / 65535);
            y += factor * (l[1] + ((h[1] - l[1]) * this.raw[at + 1]) / 65535);
            z += factor * (l[2] + ((h[2] - l[2]) * this.raw[at + 2]) / 65535);
          }
          const p = [0, 1, 2].map((k) => pose[k] - origin[k] + pose[3 + 3 * k] * x + pose[4 + 3 * k] * y + pose[5 + 3 * k] * z);
          if (shape) for (let k = 0; k < 3; k++) p[k] += factor * this.amplitude * (shape[6 * i + k] * c - shape[6 * i + 3 + k] * s);
          for (let k = 0; k < 3; k++) out[3 * i + k] = axes[3 + k] * p[0] + axes[6 + k] * p[1] + axes[9 + k] * p[2];
        }
      }
      return out;
    }

    // A place or direction in inertial axes, as it is seen.
    seenAs(shot, vector, isPlace) {
      const choice = this.choices[this.seen.value];
      const [axes, origin] = [this.pose(shot, choice.axes), this.pose(shot, choice.frame)];
      const p = isPlace ? vector.map((x, k) => x - origin[k]) : vector;
      return [0, 1, 2].map((k) => axes[3 + k] * p[0] + axes[6 + k] * p[1] + axes[9 + k] * p[2]);
    }

    // Extent over all pictures as they are, for the middle and the scale.
    measure() {
      this.low = [Infinity, Infinity, Infinity];
      this.high = [-Infinity, -Infinity, -Infinity];
      // Signs and origins of frames may be far away.
      const hidden = this.data.curves.find((curve) => curve.hidden);
      const visible = 3 * (hidden ? hidden.from : this.total);
      const meet = (all) => {
        for (let i = 0; i < all.length && i < visible; i++) {
          this.low[i % 3] = Math.min(this.low[i % 3], all[i]);
          this.high[i % 3] = Math.max(this.high[i % 3], all[i]);
        }
      };
      const step = Math.max(1, Math.floor(this.pictures / 40));
      for (let shot = 0; shot < this.pictures; shot += step) {
        meet(this.points(shot, 1));
        if (this.data.frames.length <= 12) this.data.frames.forEach((_, f) => f && meet(this.seenAs(shot, [...this.pose(shot, f).subarray(0, 3)], true)));
      }
      const extent = this.high.map((x, k) => x - this.low[k]);
      this.amplitude = 0.1 * Math.hypot(...extent);
      if (this.shapes) {
        // Room for what moves across a line.
        const moving = [0, 1, 2].map((k) => this.shapes.some((shape) => shape.some((x, i) => i % 3 === k && Math.abs(x) > 1e-6)));
        moving.forEach((moves, k) => {
          if (moves) [this.low[k], this.high[k]] = [this.low[k] - this.amplitude, this.high[k] + this.amplitude];
        });
      }
      // A shallow cone is no line.
      const size = Math.min(extent[0], extent[1]);
      const wanted = !this.shapes && !this.isFlat(2) && size > 20 * extent[2] ? (0.1 * size) / extent[2] : 1;
      this.stretch.value = Math.log10(Math.min(1000, wanted));
      this.home();
    }

    // What happens in a plane is looked at across it; round-off is no third dimension.
    isFlat(axis) {
      const extent = this.high.map((x, k) => x - this.low[k]);
      return extent[axis] <= 1e-9 * Math.max(...extent);
    }

    home() {
      const [x, y, z] = [0, 1, 2].map((axis) => this.isFlat(axis));
      [this.turn, this.tilt] = z ? [0, Math.PI / 2] : y ? [0, 0] : x ? [-Math.PI / 2, 0] : [-0.6, 0.5];
      this.begun = [this.turn, this.tilt];
      this.zoom = 1;
      this.shift = [0, 0];
      this.stretch.parentElement.hidden = z;
    }

    // Pixels per metre that fit all into the view as it begins.
    fit(width, height, stretch) {
      const [x, y, z] = this.high.map((high, k) => (high - this.low[k]) * (k === 2 ? stretch : 1));
      const [c, s, u, v] = this.begun.flatMap((angle) => [Math.cos(angle), Math.sin(angle)].map(Math.abs));
      this.across = Math.hypot(x, y, z) || 1;
      const [wide, tall] = [c * x + s * y, u * z + v * (s * x + c * y)];
      return this.zoom * Math.min((width - 90) / (wide || this.across), (height - 90) / (tall || this.across));
    }

    value(shot, curve, point, of) {
      const code = this.raw[shot * this.size + 3 * this.total + of * this.told + curve.values + point];
      const { low, high } = this.data.quantities[of];
      return code === UNKNOWN ? NaN : low + ((high - low) * code) / 65534;
    }

    draw() {
      const { data, pen } = this;
      const [width, height, ratio] = [this.canvas.clientWidth, this.canvas.clientHeight, window.devicePixelRatio || 1];
      if (this.canvas.width !== Math.round(width * ratio) || this.canvas.height !== Math.round(height * ratio)) {
        this.canvas.width = Math.round(width * ratio);
        this.canvas.height = Math.round(height * ratio);
      }
      pen.setTransform(ratio, 0, 0, ratio, 0, 0);
      pen.clearRect(0, 0, width, height);
      const style = getComputedStyle(this.stage);
      const named = (name) => style.getPropertyValue(name);
      const stretch = 10 ** this.stretch.value;
      const middle = this.low.map((x, k) => (x + this.high[k]) / 2);
      const scale = this.fit(width, height, stretch);
      const [c, s, u, v] = [Math.cos(this.turn), Math.sin(this.turn), Math.cos(this.tilt), Math.sin(this.tilt)];
      const project = (x, y, z) => {
        [x, y, z] = [x - middle[0], y - middle[1], (z - middle[2]) * stretch];
        return [width / 2 + this.shift[0] + scale * (c * x - s * y), height / 2 + this.shift[1] - scale * (u * z + v * (s * x + c * y))];
      };
      // Directions keep their lengths where places are drawn farther apart.
      this.towards = ([x, y, z], long) => [long * (c * x - s * y), -long * (u * z + v * (s * x + c * y))];
      const factor = this.factor ? 10 ** this.factor.value : 1;
      const all = this.points(this.shot, factor, this.shapes ? this.phase : null);
      this.spots = [];
      if (this.isOn("undeformed")) {
        pen.setLineDash([4, 4]);
        this.lines(this.points(this.shot, 0), project, () => named("--faint"), 1);
        pen.setLineDash([]);
      }
      this.lines(all, project, (curve) => named(curve.flexible ? "--drawn" : "--rigid"), 0);
      if (this.isOn("frames")) this.drawFrames(all, project, named);
      this.drawSigns(all, project, named);
      this.drawCorner(width, height, scale, named);
      if (this.now) this.now.value = `t = ${shown(data.times[this.shot], 5)} s`;
      if (this.times) this.times.value = `×${shown(factor, 3)}`;
      this.stretched.value = `×${shown(stretch, 3)}`;
      this.explain();
    }

    // Lines of the bodies; coloured ones in pieces. The width is that of ghosts, or 0.
    lines(all, project, plain, width) {
      const pen = this.pen;
      const of = !width && this.quantity ? Number(this.quantity.value) : -1;
      // What is rigid lies below: frames of flexible bodies have places on them.
      const order = [false, true].flatMap((flexible) => this.data.curves.filter((curve) => curve.flexible === flexible));
      for (const curve of order) {
        if (curve.hidden || (!curve.flexible && (width || !this.isOn("rigid")))) continue;
        const places = [];
        for (let i = 0; i < curve.points; i++) {
          const at = 3 * (curve.from + i);
          places.push(project(all[at], all[at + 1], all[at + 2]));
        }
        pen.lineWidth = width || (curve.flexible ? 2 : 2.6);
        const isColoured = of >= 0 && curve.values >= 0;
        pen.strokeStyle = plain(curve);
        if (isColoured) {
          pen.lineWidth = 3;
          pen.lineCap = "round";
          const { low, high } = this.data.quantities[of];
          for (let i = 0; i + 1 < curve.points; i++) {
            const mean = (this.value(this.shot, curve, i, of) + this.value(this.shot, curve, i + 1, of)) / 2;
            const part = high > low ? (mean - low) / (high - low) : 0.5;
            pen.strokeStyle = Number.isNaN(mean) ? plain(curve) : SHADES[Math.round(255 * Math.min(Math.max(part, 0), 1))];
            pen.beginPath();
            pen.moveTo(...places[i]);
            pen.lineTo(...places[i + 1]);
            pen.stroke();
          }
          pen.lineCap = "butt";
        } else {
          pen.beginPath();
          places.forEach((place, i) => (i ? pen.lineTo(...place) : pen.moveTo(...place)));
          pen.stroke();
        }
        if (width) continue;
        places.forEach((place, i) => this.spots.push({ place, text: () => this.told_of(curve, i, of, isColoured) }));
        if (!curve.flexible) this.dot(places[0], 4, plain(curve), true);
      }
    }

    told_of(curve, point, of, isColoured) {
      if (!isColoured) return curve.name;
      const value = this.value(this.shot, curve, point, of);
      const { name, unit } = this.data.quantities[of];
      return `${curve.name}: ${name} ${Number.isNaN(value) ? "not known" : quantity(value, unit)}`;
    }

    dot([x, y], radius, colour, isFilled) {
      const pen = this.pen;
      pen.beginPath();
      pen.arc(x, y, radius, 0, 2 * Math.PI);
      [pen.fillStyle, pen.strokeStyle, pen.lineWidth] = [colour, colour, 1.6];
      if (isFilled) pen.fill();
      else pen.stroke();
    }

    arrow([x, y], [a, b], colour, isDouble) {
      const pen = this.pen;
      const long = Math.hypot(a - x, b - y);
      if (long < 3) return;
      const [dx, dy] = [(a - x) / long, (b - y) / long];
      [pen.strokeStyle, pen.fillStyle, pen.lineWidth] = [colour, colour, 1.8];
      pen.beginPath();
      pen.moveTo(x, y);
      pen.lineTo(a, b);
      pen.stroke();
      for (const back of isDouble ? [0, 6] : [0]) {
        const [tx, ty] = [a - back * dx, b - back * dy];
        pen.beginPath();
        pen.moveTo(tx, ty);
        pen.lineTo(tx - 8 * dx + 3.5 * dy, ty - 8 * dy - 3.5 * dx);
        pen.lineTo(tx - 8 * dx - 3.5 * dy, ty - 8 * dy + 3.5 * dx);
        pen.fill();
      }
    }

    drawFrames(all, project, named) {
      const pen = this.pen;
      const long = Math.min(this.canvas.clientWidth, this.canvas.clientHeight) / 14;
      [pen.strokeStyle, pen.fillStyle, pen.lineWidth, pen.font] = [named("--faint"), named("--faint"), 1.2, "11px system-ui, sans-serif"];
      this.data.frames.forEach((name, frame) => {
        const pose = this.pose(this.shot, frame);
        const origin = this.data.origins === undefined ? -1 : this.data.curves[this.data.origins + frame].from;
        const at = origin < 0 ? this.seenAs(this.shot, [...pose.subarray(0, 3)], true) : all.subarray(3 * origin, 3 * origin + 3);
        const from = project(...at);
        [0, 1, 2].forEach((axis) => {
          const along = this.seenAs(this.shot, [0, 1, 2].map((k) => pose[3 + 3 * k + axis]), false);
          const to = this.towards(along, long).map((shift, k) => from[k] + shift);
          pen.beginPath();
          pen.moveTo(...from);
          pen.lineTo(...to);
          pen.stroke();
          if (Math.hypot(to[0] - from[0], to[1] - from[1]) > 8) pen.fillText("xyz"[axis], to[0] + 2, to[1] - 2);
        });
        this.spots.push({ place: from, text: () => `frame ${name}` });
      });
    }

    // Where a sign is, as it is seen.
    placeOf(sign, all) {
      if (sign.curve === undefined) {
        const pose = this.pose(this.shot, sign.frame);
        const place = [0, 1, 2].map((k) => pose[k] + pose[3 + 3 * k] * sign.at[0] + pose[4 + 3 * k] * sign.at[1] + pose[5 + 3 * k] * sign.at[2]);
        return this.seenAs(this.shot, place, true);
      }
      const curve = this.data.curves[sign.curve];
      const first = Math.min(Math.floor(sign.point), curve.points - 1);
      const second = Math.min(first + 1, curve.points - 1);
      const part = sign.point - first;
      return [0, 1, 2].map((k) => (1 - part) * all[3 * (curve.from + first) + k] + part * all[3 * (curve.from + second) + k]);
    }

    drawSigns(all, project, named) {
      let load = 0;
      for (const sign of this.data.signs) {
        if (sign.kind === "joint") {
          if (!this.isOn("joints")) continue;
          const place = project(...this.placeOf(sign, all));
          this.dot(place, 5, named("--joint"), false);
          this.spots.push({ place, text: () => `joint ${sign.name}` });
          continue;
        }
        if (sign.kind === "spread") continue;
        const at = 3 * (this.shot * this.loads.length + load++);
        if (!this.isOn("loads") || sign.kind === "gravity" || !(this.largest[sign.kind] > 0)) continue;
        const vector = [...this.acting.subarray(at, at + 3)];
        const place = this.placeOf(sign, all);
        // Many of what acts along bodies stand beside each other.
        const part = sign.kind === "line" ? 12 : 6;
        const long = Math.min(this.canvas.clientWidth, this.canvas.clientHeight) / part / this.largest[sign.kind];
        const from = project(...place);
        const to = this.towards(this.seenAs(this.shot, vector, false), long).map((shift, k) => from[k] + shift);
        this.arrow(from, to, named("--load"), sign.kind === "moment");
        this.spots.push({ place: to, text: () => `${sign.name}: ${quantity(Math.hypot(...vector), { line: "N/m", force: "N", moment: "N m" }[sign.kind])}` });
      }
    }

    // Axes of the view, gravity, and a length as a scale.
    drawCorner(width, height, scale, named) {
      const pen = this.pen;
      const [x0, y0] = [48, height - 48];
      const towards = (along, long) => this.towards(along, long).map((shift, k) => [x0, y0][k] + shift);
      pen.font = "12px system-ui, sans-serif";
      [["x", 1, 0, 0], ["y", 0, 1, 0], ["z", 0, 0, 1]].forEach(([name, ...axis]) => {
        [pen.fillStyle, pen.strokeStyle, pen.lineWidth] = [named("--faint"), named("--faint"), 1];
        const to = towards(axis, 28);
        if (Math.hypot(to[0] - x0, to[1] - y0) < 3) return;
        pen.beginPath();
        pen.moveTo(x0, y0);
        pen.lineTo(...to);
        pen.stroke();
        const [x, y] = towards(axis, 38);
        pen.fillText(name, x - 3, y + 4);
      });
      this.loads.forEach((sign, k) => {
        const vector = [...this.acting.subarray(3 * (this.shot * this.loads.length + k)).subarray(0, 3)];
        const size = Math.hypot(...vector);
        if (sign.kind !== "gravity" || !this.isOn("loads") || !(size > 0)) return;
        const to = towards(this.seenAs(this.shot, vector, false).map((x) => x / size), 40);
        this.arrow([x0, y0], to, named("--load"), false);
        this.spots.push({ place: to, text: () => `${sign.name}: gravity ${shown(size)} m/s²` });
      });
      const wanted = (0.2 * width) / scale;
      const power = 10 ** Math.floor(Math.log10(wanted));
      const bar = power * [5, 2, 1].find((part) => part * power <= wanted * 1.0001);
      pen.fillStyle = named("--faint");
      pen.fillRect(width - 20 - bar * scale, height - 24, bar * scale, 2);
      pen.textAlign = "right";
      pen.fillText(`${shown(bar, 3)} m`, width - 20, height - 30);
      pen.textAlign = "left";
    }

    // The scale of the colours, or what is known of the mode.
    explain() {
      const of = this.quantity ? Number(this.quantity.value) : -1;
      if (this.explained === `${of} ${this.mode?.value}`) return;
      this.explained = `${of} ${this.mode?.value}`;
      this.legend.hidden = of < 0;
      if (of >= 0) {
        const { name, unit, low, high, largest } = this.data.quantities[of];
        this.legend.replaceChildren();
        make("div", this.legend, { textContent: name, className: "name" });
        const bar = make("div", this.legend, { className: "bar" });
        bar.style.background = `linear-gradient(to right, ${STOPS.map((stop) => `rgb(${stop.join(",")})`).join(",")})`;
        const ends = make("div", this.legend, { className: "ends" });
        for (const value of [low, (low + high) / 2, high]) make("span", ends, { textContent: quantity(value, unit) });
        make("div", this.legend, { className: "largest", textContent: largest });
      }
      if (!this.mode) return;
      this.facts.hidden = false;
      this.facts.replaceChildren();
      for (const [head, text] of this.data.modes[this.mode.value].facts) {
        const pair = make("div", this.facts);
        make("dt", pair, { textContent: head });
        make("dd", pair, { textContent: text });
      }
    }

    listen() {
      const canvas = this.canvas;
      canvas.onpointerdown = (event) => {
        this.held = [event.clientX, event.clientY];
        this.tip.hidden = true;
        canvas.setPointerCapture(event.pointerId);
      };
      canvas.onpointerup = () => {
        this.held = null;
      };
      canvas.onpointerleave = () => {
        this.tip.hidden = true;
      };
      canvas.onpointermove = (event) => {
        if (!this.held) {
          this.tell(event);
          return;
        }
        const [dx, dy] = [event.clientX - this.held[0], event.clientY - this.held[1]];
        this.held = [event.clientX, event.clientY];
        if (event.shiftKey || event.buttons === 2) {
          this.shift[0] += dx;
          this.shift[1] += dy;
        } else {
          this.turn += 0.008 * dx;
          this.tilt = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, this.tilt + 0.008 * dy));
        }
        this.draw();
      };
      canvas.oncontextmenu = () => false;
      const wheel = (event) => {
        event.preventDefault();
        this.zoom *= Math.exp(-0.001 * event.deltaY);
        this.draw();
      };
      canvas.addEventListener("wheel", wheel, { passive: false });
    }

    // What is under the cursor: the nearest point of a body, joint, load or frame.
    tell(event) {
      const box = this.canvas.getBoundingClientRect();
      const [x, y] = [event.clientX - box.left, event.clientY - box.top];
      const far = ({ place }) => Math.hypot(place[0] - x, place[1] - y);
      let best = null;
      for (const spot of this.spots) if (far(spot) < 14 && (!best || far(spot) <= far(best))) best = spot;
      this.tip.hidden = !best;
      if (!best) return;
      this.tip.textContent = best.text();
      const side = x > box.width / 2;
      this.tip.style.left = side ? "" : `${x + 14}px`;
      this.tip.style.right = side ? `${box.width - x + 14}px` : "";
      this.tip.style.top = `${Math.max(0, y - 10)}px`;
    }

    frame(now) {
      const passed = this.playing && this.before !== null ? ((now - this.before) / 1000) * this.speed.value : 0;
      this.before = now;
      if (this.shapes && passed > 0) {
        this.phase = (this.phase + Math.PI * passed) % (2 * Math.PI);
        this.draw();
      } else if (passed > 0 && this.span > 0) {
        this.clock = (this.clock + passed) % this.span;
        const times = this.data.times;
        let shot = 0;
        while (shot + 1 < this.pictures && times[shot + 1] - times[0] <= this.clock) shot++;
        if (shot !== this.shot) {
          this.shot = shot;
          this.slider.value = shot;
          this.draw();
        }
      }
      requestAnimationFrame((next) => this.frame(next));
    }
  }

  for (const data of document.querySelectorAll(".scene > script")) {
    data.parentElement.view = new View(data.parentElement, JSON.parse(data.textContent));
  }
})();
