"""Opens the pages of a run in headless Chromium: no error on the console, charts that answer the hand.

`python tools/test_pages.py target/release/examples/spin_up [FOLDER FOR SCREENSHOTS]`
"""

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
  found.push(["charts", String(document.querySelectorAll(".live svg path.axis").length)]);
  document.title = "TOLD " + JSON.stringify({ found: Object.fromEntries(found), wrong });
}, 300));
</script>"""

ANIMATION = """<script>
addEventListener("load", () => setTimeout(() => {
  const canvas = document.querySelector("canvas");
  const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
  let drawn = 0;
  for (let k = 3; k < pixels.length; k += 4) drawn += pixels[k] > 0;
  document.title = "TOLD " + JSON.stringify({ found: { drawn: String(drawn > 100) }, wrong });
}, 500));
</script>"""


def opened(browser, page, script, folder):
    """What the page tells of itself after the script."""
    import json

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
        several = opened(browser, sweep / "report.html", REPORT, folder)
        print("sweep:", several)
        assert several["hidden"] == "1" and several["told"].startswith("omega_s = "), several
        animation = opened(browser, run / "animation.html", ANIMATION, folder)
        print("animation:", animation)
        assert animation["drawn"] == "true"
        if pictures:
            pictures = pathlib.Path(pictures).resolve()
            pictures.mkdir(parents=True, exist_ok=True)
            for page in (run / "report.html", run / "animation.html"):
                pictured(browser, page, folder, pictures)
    print("ok")


if __name__ == "__main__":
    main(*sys.argv[1:])
