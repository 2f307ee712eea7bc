"""What rust-analyzer finds in the text of `model!`: definitions, hovers, uses, new names, and how words go on.

python3 tools/test_editor.py            it needs rust-analyzer

A crate with a model of every kind of name is made in a folder of its own, and the server is asked at words of its text.
"""

import json
import pathlib
import queue
import subprocess
import sys
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
ROTOR = (ROOT / "rncf-macros/codegen/src/editor/rotor.txt").read_text()
# Where there is no rustup, or it does not reach its server, there is the other way.
NEEDED = """it needs rust-analyzer: `rustup component add rust-analyzer`, or the program of a release of
https://github.com/rust-lang/rust-analyzer or of a package of the system, in a folder of PATH"""
MODEL = f"""rncf::model! {{
{ROTOR}}}
fn main() {{
    let rotor = Rotor {{ long: 2.0, ..Rotor::default() }};
    println!("{{}}", rotor.long);
}}
"""


ITEMS = "param const material section frame motion component body joint part output".split()

# Half-typed text in place of the model's: what completes it at `|`, and what is no name there.
TYPED = [
    ("output tip = blade[1].spar.end;", "output tip = |", "long blade hub turn steel inertial total", "spar clip"),
    ("output tip = blade[1].spar.end;", "output tip = bl|", "blade blades", "spar"),
    ("output tip = blade[1].spar.end;", "output tip = blade[1].|", "spar clip pull", "hub start"),
    ("output tip = blade[1].spar.end;", "output tip = blade[1].spar.|", "start end at mass", "spar ex"),
    ("output tip = blade[1].spar.end;", "output tip = blade[1].spar.en|;", "start end at", "spar ex"),
    ("output tip = blade[1].spar.end;", "output tip = blade[1].spar.end.|;", "x velocity axial_force", "start"),
    ("output tip = blade[1].spar.end;", "output tip = blade[1].spar.at(1 m).velocity.|;", "x y z", "velocity"),
    ("output tip = blade[1].spar.end;", "output tip = hub.|;", "angle ex at", "start"),
    ("output tip = blade[1].spar.end;", "joint other = clamp(blade[1].spar.end, h|);", "hub", "start"),
    ("clamp(spar.start, root);", "clamp(|, root);", "spar root hub long azimuth", "start"),
    ("clamp(spar.start, root);", "clamp(sp|", "spar root hub long azimuth", "start"),
    ("clip.force.x", "clip.|", "force moment", "spar"),
    ("cable(round, steel)", "cable(ro|, st)", "round steel", "start"),
    ("cable(round, steel)", "cable(round, |)", "round steel", "start"),
    ("turn(t)", "tu|(t)", "turn", "spar"),
    ("body spar in root", "body spar in ro|", "root hub", "start"),
    ("long * cos(azimuth), ", "lo|, ", "long azimuth", "start"),
]


class Server:
    """One run of rust-analyzer."""

    def __init__(self, folder):
        self.process = subprocess.Popen(
            ["rust-analyzer"], cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
        )
        self.answers, self.last, self.is_ready = queue.Queue(), 0, False
        threading.Thread(target=self.read, daemon=True).start()

    def read(self):
        while True:
            size = None
            while line := self.process.stdout.readline().strip():
                if line.lower().startswith(b"content-length"):
                    size = int(line.split(b":")[1])
            if size is None:
                return
            self.answers.put(json.loads(self.process.stdout.read(size)))

    def write(self, message):
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n" % len(body) + body)
        self.process.stdin.flush()

    def wait(self, wanted, seconds):
        end = time.time() + seconds
        while time.time() < end:
            try:
                message = self.answers.get(timeout=1)
            except queue.Empty:
                continue
            if message.get("method") == "experimental/serverStatus":
                self.is_ready = message["params"]["quiescent"]
            if "method" in message and "id" in message:
                self.write({"id": message["id"], "result": None})
            elif message.get("id") == wanted:
                return message.get("result")
        return None

    def ask(self, method, params, seconds=300):
        self.last += 1
        self.write({"id": self.last, "method": method, "params": params})
        return self.wait(self.last, seconds)


def places(text, word):
    """Line and column of each whole word."""
    found = []
    for row, line in enumerate(text.split("\n")):
        at = line.find(word)
        while at >= 0:
            around = (line[at - 1 : at] + line[at + len(word) : at + len(word) + 1]).replace("_", "a")
            if not any(letter.isalnum() for letter in around):
                found.append((row, at))
            at = line.find(word, at + 1)
    return found


def check_completion(server, uri, at):
    """What completes half-typed text, at its own version of the document each."""
    slowest = 0.0
    for version, (found, typed, wanted, strange) in enumerate(TYPED, 2):
        assert found in MODEL, found
        text = MODEL.replace(found, typed, 1)
        rest = text[: text.index("|")]
        text = text.replace("|", "", 1)
        if typed.count("(") > typed.count(")"):
            # What is typed stands in parentheses that are closed by an editor.
            text = text[: len(rest)] + ");" + text[len(rest) :]
        document = {"uri": uri, "version": version}
        server.write({"method": "textDocument/didChange", "params": {"textDocument": document, "contentChanges": [{"text": text}]}})
        began = time.time()
        place = (rest.count("\n"), len(rest) - rest.rfind("\n") - 1)
        answer = server.ask("textDocument/completion", at(place)) or {}
        slowest = max(slowest, time.time() - began)
        labels = {item["label"] for item in answer.get("items", [])}
        assert set(wanted.split()) <= labels, f"`{typed}`: {sorted(labels)}"
        assert not set(strange.split()) & labels, f"`{typed}`: {sorted(labels)}"
        print(f"{typed}: {len(labels)} words")
    print(f"the slowest answer took {slowest:.2f} s")


def check(folder):
    source = folder / "src" / "main.rs"
    source.parent.mkdir()
    source.write_text(MODEL)
    lock = (ROOT / "Cargo.lock").read_text()
    (folder / "Cargo.lock").write_text(lock)
    (folder / "Cargo.toml").write_text(
        '[package]\nname = "rotor"\nversion = "0.1.0"\nedition = "2024"\n[workspace]\n'
        f'[dependencies]\nrncf = {{ path = "{ROOT}" }}\n'
    )
    server = Server(folder)
    try:
        server.ask(
            "initialize",
            {
                "processId": None,
                "rootUri": folder.as_uri(),
                "capabilities": {"experimental": {"serverStatusNotification": True}},
                "initializationOptions": {"checkOnSave": False, "cachePriming": {"enable": False}},
            },
        )
        server.write({"method": "initialized", "params": {}})
        document = {"uri": source.as_uri(), "languageId": "rust", "version": 1, "text": MODEL}
        server.write({"method": "textDocument/didOpen", "params": {"textDocument": document}})
        end = time.time() + 600
        while not server.is_ready and time.time() < end:
            server.wait(None, 2)
        at = lambda place: {
            "textDocument": {"uri": source.as_uri()},
            "position": {"line": place[0], "character": place[1]},
        }
        lines = MODEL.split("\n")
        start = lambda found: (found["range"]["start"]["line"], found["range"]["start"]["character"])
        # Ready it is at first before the macro is built, too.
        while time.time() < end and not server.ask("textDocument/definition", at(places(MODEL, "steel")[0])):
            time.sleep(2)
        kinds = {"steel": "material", "round": "section", "hub": "frame", "turn": "motion", "spar": "body"}
        kinds |= {"clip": "joint", "blade": "part", "Blade": "component", "blades": "const", "long": "pub long: f64"}
        for word, kind in kinds.items():
            all_places = places(MODEL, word)
            declared = [place for place in all_places if lines[place[0]][: place[1]].split()[-1] in ITEMS]
            for place in all_places:
                found = [start(one) for one in server.ask("textDocument/definition", at(place)) or []]
                assert declared[0] in found, f"{word} at {place} leads to {found}"
                hover = (server.ask("textDocument/hover", at(place)) or {}).get("contents", {})
                assert kind in json.dumps(hover), f"{word} at {place}: {hover}"
            params = at(all_places[-1]) | {"context": {"includeDeclaration": True}}
            uses = {start(one) for one in server.ask("textDocument/references", params) or []}
            assert set(all_places) <= uses, f"{word}: {uses} of {all_places}"
            print(f"{word}: {len(all_places)} places")
        renamed = server.ask("textDocument/rename", at(places(MODEL, "spar")[1]) | {"newName": "girder"})
        edits = {start(edit) for change in renamed["documentChanges"] for edit in change["edits"]}
        assert edits == set(places(MODEL, "spar")), edits
        print("spar: renamed")
        check_completion(server, source.as_uri(), at)
    finally:
        server.process.kill()


if __name__ == "__main__":
    try:
        subprocess.run(["rust-analyzer", "--version"], check=True, capture_output=True)
    except (OSError, subprocess.CalledProcessError):
        sys.exit(NEEDED)
    with tempfile.TemporaryDirectory() as made:
        check(pathlib.Path(made))
