"""Opens the pages of a run in headless Chromium: no error on the console, charts that answer the hand.

`python tools/test_pages.py target/release/examples/spin_up [FOLDER FOR SCREENSHOTS]`
"""

import csv
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

FLAGS = [
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync", "--hide-scrollbars", "--virtual-time-budget=3000",
]

HOOK = """<script>
window.wrong = [];
addEventListener("error", (event) => wrong.push(event.message));
const logged = console.error;
console.error = (...words) => { wrong.push(words.join(" ")); logged(...words); };
</script>"""

# What a hand does with the report; `found` is told at the end.
REPORT = """<script>
addEventListener("load", () => setTimeout(() => {
  const found = [];
  const box = document.querySelector(".live");
  const svg = box.querySelector("svg");
  const at = (kind, share) => {
    const frame = svg.getBoundingClientRect();
    const where = { clientX: frame.left + share * frame.width, clientY: frame.top + 0.5 * frame.height, pointerId: 1, bubbles: true };
    svg.setPointerCapture = () => {};
    svg.dispatchEvent(new PointerEvent(kind, where));
  };
  at("pointermove", 0.5);
  found.push(["told", box.querySelector(".told").innerText.replaceAll("\\n", "; ")]);
  const ticks = () => [...svg.querySelectorAll("text.middle")].map((text) => text.textContent).join(" ");
  const before = ticks();
  at("pointerdown", 0.4); at("pointermove", 0.6); at("pointerup", 0.6);
  found.push(["zoomed", String(before !== ticks())], ["again", String(!box.querySelector(".again").hidden)]);
  box.querySelector(".again").click();
  found.push(["whole", String(before === ticks())]);
  const names = document.querySelectorAll(".names button");
  if (names.length) {
    const lines = () => document.querySelector(".names + .live").querySelectorAll("path.line").length;
    const all = lines();
    names[0].click();
    found.push(["hidden", String(all - lines())]);
    names[0].click();
  }
  const beside = {};
  for (const row of [...document.querySelectorAll(".beside tr")].slice(1)) beside[row.cells[0].innerText] = [1, 2].map((k) => Number(row.cells[k].innerText));
  found.push(["beside", beside]);
  const card = {};
  for (const row of document.querySelectorAll(".card > table tr")) card[row.cells[0].innerText] = row.cells[1].innerText;
  found.push(["card", card]);
  const results = [...document.querySelectorAll("h2")].find((head) => head.innerText === "Results");
  const first = document.querySelector(".card");
  found.push(["before", String(Boolean(first && results && first.compareDocumentPosition(results) & Node.DOCUMENT_POSITION_FOLLOWING))]);
  found.push(["charts", String(document.querySelectorAll(".live svg path.axis").length)]);
  document.title = "TOLD " + JSON.stringify({ found: Object.fromEntries(found), wrong });
}, 300));
</script>"""

# Charts of many kinds: what the cursor is told over the first one, and what a click on its first name hides.
CHARTS = """<script>
addEventListener("load", () => setTimeout(() => {
  const box = document.querySelector(".live");
  const svg = box.querySelector("svg");
  svg.setPointerCapture = () => {};
  const frame = svg.getBoundingClientRect();
  const at = (kind, x, y) => svg.dispatchEvent(new PointerEvent(kind,
    { clientX: frame.left + x * frame.width, clientY: frame.top + y * frame.height, pointerId: 1, bubbles: true }));
  const shapes = () => svg.querySelectorAll("g[clip-path] > *").length;
  const names = [...document.querySelector("figure:has(.live)").querySelectorAll(".names button")];
  const found = { charts: document.querySelectorAll(".live").length, names: names.map((name) => name.innerText), told: [] };
  for (let i = 1; i < 40; i++) for (let j = 1; j < 40; j++) {
    at("pointermove", i / 40, j / 40);
    const told = box.querySelector(".told");
    const text = told.innerText.replaceAll("\\n", "; ");
    if (!told.hidden && !found.told.includes(text)) found.told.push(text);
  }
  const before = shapes();
  if (names.length) names[0].click();
  found.hidden = before - shapes();
  at("pointerdown", 0.3, 0.5); at("pointermove", 0.7, 0.5);
  found.chosen = getComputedStyle(svg.querySelector(".chosen")).opacity;
  at("pointerup", 0.7, 0.5);
  found.zoomed = !box.querySelector(".again").hidden;
  found.drawings = [...document.querySelectorAll("figure > svg")].filter((one) => one.style.display !== "none").length;
  document.title = "TOLD " + JSON.stringify({ found, wrong });
}, 300));
</script>"""

CARD = """<script>
addEventListener("load", () => setTimeout(() => {
  const found = {};
  for (const row of document.querySelectorAll(".card > table tr")) found[row.cells[0].innerText] = row.cells[1].innerText;
  const wider = (one) => one.scrollWidth > one.clientWidth + 1;
  found.wider = [document.documentElement, ...document.querySelectorAll(".tables > *")].filter(wider).length;
  document.title = "TOLD " + JSON.stringify({ found, wrong });
}, 300));
</script>"""

# What a hand does with a scene that moves: each picture is told by the colours of its pixels.
SCENE = """<script>
addEventListener("load", () => setTimeout(() => {
  const scene = document.querySelector(".scene");
  const view = scene.view;
  const found = {};
  const canvas = scene.querySelector("canvas");
  const pixels = () => canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
  const drawn = () => pixels().reduce((sum, value, k) => sum + (k % 4 === 3 && value > 0), 0);
  const changed = (act) => {
    const before = pixels();
    act();
    return String(pixels().some((value, k) => value !== before[k]));
  };
  const touch = (selector, set) => changed(() => {
    const element = scene.querySelector(selector);
    Object.assign(element, set);
    (element.onchange || element.oninput || element.onclick).call(element);
  });
  const switched = (selector) => changed(() => scene.querySelector(selector).click());
  scene.querySelector(".play").click();
  found.drawn = String(drawn() > 100);
  if (scene.querySelector(".time input")) {
    const last = scene.querySelector(".time input").max;
    found.moved = touch(".time input", { value: String(last / 2) });
    found.now = scene.querySelector(".time output").value;
    found.undeformed = switched("input.undeformed");
    found.magnified = touch("input.magnify", { value: "1" });
    found.speeds = [...scene.querySelectorAll("select.speed option")].map((option) => option.textContent).filter((text) => text === "true time").join();
    const legend = scene.querySelector(".legend");
    found.legend = {};
    const options = [...scene.querySelectorAll("select.quantity option")];
    for (const option of options) {
      touch("select.quantity", { value: option.value });
      if (!legend.hidden) found.legend[option.textContent] = [...legend.querySelectorAll(".ends span, .largest")].map((part) => part.textContent);
    }
    found.plain = String(legend.hidden);
    touch("select.quantity", { value: "0" });
    const [, beam] = view.spots.length ? [0, view.spots.find((spot) => /:/.test(spot.text()))] : [];
    found.tip = beam ? beam.text() : "";
  } else {
    [found.modes, found.tips, found.roots] = [[], [], []];
    for (const option of scene.querySelectorAll("select.mode option")) {
      touch("select.mode", { value: option.value });
      const told = {};
      scene.querySelectorAll(".facts dt").forEach((head) => { told[head.textContent] = head.nextSibling.textContent; });
      found.modes.push(told);
      // Sizes of the displacements of both ends, along the axis (of its frame) and across it.
      const shape = view.shapes[option.value];
      const pose = view.pose(0, view.data.curves[0].frame);
      const size = (point) => [0, 1].map((axis) => Math.hypot(...[0, 3].map((part) =>
        [0, 1, 2].reduce((sum, k) => sum + pose[3 + 3 * k + axis] * shape[6 * point + part + k], 0))));
      found.tips.push(size(view.data.curves[0].points - 1).map((x) => Math.round(x)));
      found.roots.push(Math.max(...size(0)));
    }
    touch("select.mode", { value: "0" });
    found.magnified = touch("input.magnify", { value: "0.5" });
    found.moved = changed(() => { view.phase = 1.5; view.draw(); });
    found.undeformed = switched("input.undeformed");
  }
  found.frames = switched("input.frames");
  found.joints = switched("input.joints");
  found.notes = [...scene.querySelectorAll(".told")].map((note) => note.textContent).join(" ");
  document.title = "TOLD " + JSON.stringify({ found, wrong });
}, 500));
</script>"""


def opened(browser, page, script, folder):
    """What the page tells of itself after the script."""
    text = page.read_text(encoding="utf-8")
    assert not re.search(r'(src|href)="https?:', text), f"{page.name} needs the network"
    tried = folder / f"tried-{page.name}"
    text = text.replace("<head>", "<head>" + HOOK, 1) if "<head>" in text else HOOK + text
    tried.write_text(text.replace("</body>", script + "</body>", 1) if "</body>" in text else text + script, encoding="utf-8")
    line = [browser, *FLAGS, f"--user-data-dir={folder / 'profile'}", "--dump-dom", tried.as_uri()]
    dom = subprocess.run(line, capture_output=True, text=True, check=True, timeout=120).stdout
    title = re.search(r"<title>TOLD (.*?)</title>", dom, re.DOTALL)
    assert title, f"{page.name} told nothing"
    told = json.loads(title[1].replace("&quot;", '"').replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&"))
    assert not told["wrong"], f"{page.name}: {told['wrong']}"
    return told["found"]


def value_of(text):
    """A number with a prefix of its unit, `103.5 kN`."""
    number, _, unit = text.partition(" ")
    factors = {"G": 1e9, "M": 1e6, "k": 1e3}
    return float(number) * factors.get(unit[0], 1.0)


def scales_fit(legend, body):
    """The largest numbers of the scales are those of the envelopes, with their place, to the digits that are shown."""
    for name, key in [("axial force [N]", "axial_force"), ("bending moment [N m]", "bending_moment"), ("stress [Pa]", "stress")]:
        low, middle, high, largest = legend[name]
        wanted = body[key]["value"]
        assert abs(value_of(high) - wanted) <= 1e-3 * abs(wanted), (name, high, wanted)
        assert value_of(low) <= value_of(middle) <= value_of(high), legend[name]
        assert f"{body['name']} at x = {body[key]['x']:g} m, t = {body[key]['at']:.6g} s" in largest, (largest, body[key])
    assert "axial strain [1]" in legend, legend


def differences_fit(table, other, own):
    """The largest difference of each output is that of both files, whose rows are at the same times."""
    with open(other, encoding="utf-8") as first, open(own, encoding="utf-8") as second:
        others, rows = list(csv.reader(first)), list(csv.reader(second))
    assert others[0] == rows[0] and len(others) == len(rows) and set(table) == set(rows[0][1:])
    for column, head in enumerate(rows[0][1:], 1):
        found = [(float(b[column]) - float(a[column]), float(b[0])) for a, b in zip(others[1:], rows[1:])]
        value, at = max(found, key=lambda pair: abs(pair[0]))
        assert abs(table[head][0] - value) <= 1e-3 * abs(value) and abs(table[head][1] - at) < 1e-6, (head, table, value, at)


def card_fits(report, summary):
    """The card stands before the results, with the numbers of the summary."""
    card = report["card"]
    assert report["before"] == "true", report
    assert card["Unknowns"].startswith(f"{summary['unknowns']},"), card
    assert card["Flexible bodies"] == "beam: 6 elements, all nodal vectors", card
    mass = float(card["Mass"].split(" kg")[0])
    assert abs(mass - summary["masses"][-1]["mass"]) < 1e-5 * mass, card
    frequencies = [float(text) for text in card["First frequencies"].split(" rad/s")[0].split(", ")]
    wanted = summary["first_frequencies"]["im [rad/s]"]
    assert len(frequencies) == 5 and all(abs(a - b) < 1e-4 * b for a, b in zip(frequencies, wanted)), card


def charts_answer(opens, program, folder):
    """Charts of modes over the spin, of speed against accuracy, of points and of maps: each tells, hides and zooms."""
    sweep = ["sweep", "omega_s=1..5 rad/s in 4", "--t-end", "2 s"]
    lines = {
        "campbell": ["campbell", "--modes", "3"],
        "chart": ["chart", "--rtols", "1e-3,1e-4,1e-5", "--integrators", "radau", "--t-end", "2 s"],
        "map": [*sweep, "elements=2,4,6"],
        "points": ["sweep", "omega_s=1..5 rad/s", "T_s=10..20 s", "--samples", "8", "--t-end", "2 s"],
    }
    pages = {}
    for name, line in lines.items():
        subprocess.run([program, *line, "--quiet", "--out", str(folder / name)], check=True)
        pages[name] = folder / name / "report.html"
    found = {name: opens(page, CHARTS) for name, page in pages.items()}
    print("charts:", {name: {**one, "told": one["told"][:1]} for name, one in found.items()})
    for name, one in found.items():
        assert one["told"] and one["zoomed"] and not one["drawings"], (name, one)
        # What is dragged over still shows.
        assert one["chosen"] == "0.2", (name, one["chosen"])
    campbell, chart, cells, points = (found[name] for name in lines)
    assert campbell["names"] == ["mode 1", "mode 2", "mode 3"] and campbell["hidden"] >= 1, campbell
    assert campbell["told"][0].startswith("spin = 0 rad/s; mode 1 2.9") and campbell["told"][0].count(";") == 3, campbell
    assert chart["names"] == ["rncf, radau", "ancf, radau"] and chart["charts"] == 3, chart
    # Three points and the line that joins them.
    assert chart["hidden"] == 4 and any(re.match(r"rncf, radau, rtol 1e-\d; processor time = \S+ s; error ", text) for text in chart["told"]), chart
    with open(folder / "map" / "sweep.csv", encoding="utf-8") as table:
        rows = list(csv.DictReader(table))
    # Every cell tells its parameters and its value.
    told = {tuple(float(number) for number in re.findall(r"(?:= |last )([-\d.e]+)", text)) for text in cells["told"]}
    wanted = {(float(row["omega_s [rad/s]"]), float(row["elements [1]"]), float(row["u last [m]"])) for row in rows}
    alike = lambda a, b: all(abs(x - y) <= 1e-5 * abs(y) for x, y in zip(a, b))
    assert len(told) == len(wanted) == 12 and all(any(alike(a, b) for a in told) for b in wanted), (told, wanted)
    assert points["names"] == ["max", "min", "last"] and points["hidden"] == 8, points
    assert any("; last " in text for text in points["told"]), points
    return pages


def pictured(browser, page, folder, pictures):
    for name, width, scheme in [("light", 1000, 1), ("dark", 1000, 0), ("narrow", 420, 1)]:
        line = [browser, *FLAGS, f"--user-data-dir={folder / 'profile'}", f"--window-size={width},1400"]
        line += [f"--blink-settings=preferredColorScheme={scheme}", f"--screenshot={pictures / f'{page.stem}-{name}.png'}"]
        subprocess.run([*line, page.as_uri()], capture_output=True, check=True, timeout=120)


def main(program, pictures=None):
    browser = shutil.which("chromium") or shutil.which("google-chrome")
    if not browser:
        sys.exit("error: no Chromium is there")
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made)
        run, sweep = folder / "run", folder / "sweep"
        subprocess.run([program, "--animate", "--quiet", "--out", str(run)], check=True)
        line = [program, "sweep", "omega_s=1..5 rad/s in 4", "--quiet", "--out", str(sweep)]
        subprocess.run(line, check=True)
        report = opened(browser, run / "report.html", REPORT, folder)
        print("report:", report)
        assert report["told"].startswith("t = ") and " m" in report["told"], report
        assert (report["zoomed"], report["again"], report["whole"], report["charts"]) == ("true", "true", "true", "3")
        summary = json.loads((run / "summary.json").read_text(encoding="utf-8"))
        card_fits(report, summary)
        # The fifth frequency of six elements is 1.5 % too high.
        assert "too coarse" in report["card"]["First frequencies"] and "mode 5" in report["card"]["First frequencies"], report
        several = opened(browser, sweep / "report.html", REPORT, folder)
        print("sweep:", several)
        text = (sweep / "report.html").read_text(encoding="utf-8")
        assert "<td>1..5 rad/s in 4</td>" in text and "<b>Complete</b></p>" in text
        assert several["hidden"] == "1" and several["told"].startswith("omega_s = "), several
        animation = opened(browser, run / "animation.html", SCENE, folder)
        print("animation:", animation)
        for key in ("drawn", "moved", "undeformed", "magnified", "frames", "joints", "plain"):
            assert animation[key] == "true", (key, animation)
        scales_fit(animation["legend"], summary["bodies"][0])
        assert animation["speeds"] == "true time" and animation["now"].startswith("t = 10"), animation
        assert animation["tip"].startswith("beam: axial force ") and animation["tip"].endswith("N"), animation
        assert "rows of the run are drawn" in animation["notes"], animation
        beside = folder / "beside"
        subprocess.run([program, "omega_s=4.1 rad/s", "--compare", str(run), "--quiet", "--out", str(beside)], check=True)
        both = opened(browser, beside / "report.html", REPORT, folder)
        print("beside:", both)
        assert both["hidden"] == "1" and "this run" in both["told"] and "the other" in both["told"], both
        differences_fit(both["beside"], run / "history.csv", beside / "history.csv")
        charts = charts_answer(lambda page, script: opened(browser, page, script, folder), program, folder)
        modes = folder / "modes"
        subprocess.run([program, "modes", "--modes", "4", "--frequency", "Hz", "--quiet", "--out", str(modes)], check=True)
        moving = opened(browser, modes / "report.html", SCENE, folder)
        print("modes:", moving)
        for key in ("drawn", "moved", "undeformed", "magnified", "frames", "joints"):
            assert moving[key] == "true", (key, moving)
        found = json.loads((modes / "summary.json").read_text(encoding="utf-8"))["modes"]
        assert len(moving["modes"]) == len(found) == 4
        for told, mode in zip(moving["modes"], found):
            frequency = float(told["in the reference frame [Hz]"].split()[0])
            assert abs(frequency - mode["im [rad/s]"] / (2 * math.pi)) < 1e-6 * frequency, (told, mode)
            assert "damping ratio" in told["in the reference frame [Hz]"], told
        card = opened(browser, modes / "report.html", CARD, folder)
        assert card.pop("wider") == 0, card
        assert card["Flexible bodies"].startswith("beam: 6 elements") and card["Mass"].endswith("at the equilibrium"), card
        # The first bending mode moves the tip across the beam, and no mode its clamped root.
        assert moving["tips"][0] == [0, 1] and moving["roots"] == [0, 0, 0, 0], moving
        if pictures:
            pictures = pathlib.Path(pictures).resolve()
            pictures.mkdir(parents=True, exist_ok=True)
            reports = {"report": run / "report.html", "animation": run / "animation.html", "modes": modes / "report.html"}
            for name, page in {**reports, **charts}.items():
                copy = folder / f"{name}.html"
                shutil.copy(page, copy)
                pictured(browser, copy, folder, pictures)
    print("ok")


if __name__ == "__main__":
    main(*sys.argv[1:])
