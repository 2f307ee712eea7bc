"""The template as a user installs it: `python tools/test_template.py [TARGET]`.

Builds the wheel of examples/template as `pip install .` does, installs it into a new environment, imports it there, and runs the
template's tests and its notebook with it. Needs maturin, numpy, pandas, matplotlib, nbclient and ipykernel; without one of them
it says so and does nothing. TARGET is a folder for what cargo builds.
"""

import glob
import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
import venv

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
NEEDED = ["pip", "ensurepip", "maturin", "numpy", "pandas", "matplotlib", "nbclient", "ipykernel"]

# What the new environment runs, in a folder without sources.
NOTEBOOK = """
import sys
import nbformat
from nbclient import NotebookClient

notebook = nbformat.read(sys.argv[1], as_version=4)
NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
outputs = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
kinds = {kind for output in outputs for kind in output.get("data", {})}
assert "image/png" in kinds and "text/html" in kinds, kinds
text = "".join(output.get("text", "") for output in outputs)
assert "did you mean `length`?" in text, text
print(f"notebook: {len(notebook.cells)} cells, {len(outputs)} outputs")
"""


def run(command, **how):
    print("+", " ".join(command))
    subprocess.run(command, check=True, **how)


def main():
    missing = [name for name in NEEDED if importlib.util.find_spec(name) is None]
    if missing:
        print(f"not tried: it needs {', '.join(missing)} (pip install {' '.join(missing)})")
        return
    with tempfile.TemporaryDirectory() as folder:
        source = os.path.join(folder, "source")
        shutil.copytree(os.path.join(ROOT, "examples", "template"), source, ignore=shutil.ignore_patterns("target"))
        shutil.copy(os.path.join(ROOT, "Cargo.lock"), source)
        manifest = os.path.join(source, "Cargo.toml")
        with open(manifest, encoding="utf-8") as file:
            text = file.read()
        assert 'path = "../.."' in text
        with open(manifest, "w", encoding="utf-8") as file:
            file.write(text.replace('path = "../.."', f'path = "{ROOT}"'))

        # Unoptimised, as the other tests of the template are built.
        building = {**os.environ, "MATURIN_PEP517_ARGS": "--profile dev", "PATH": os.path.dirname(sys.executable) + os.pathsep + os.environ["PATH"]}
        if len(sys.argv) > 1:
            building["CARGO_TARGET_DIR"] = os.path.abspath(sys.argv[1])
        wheels = os.path.join(folder, "wheels")
        run([sys.executable, "-m", "pip", "wheel", "-q", "--no-build-isolation", "--no-deps", "-w", wheels, source], env=building)
        [wheel] = glob.glob(os.path.join(wheels, "swing-*.whl"))

        place = os.path.join(folder, "environment")
        venv.create(place, with_pip=True)
        python = os.path.join(place, "bin", "python")
        [packages] = glob.glob(os.path.join(place, "lib", "python*", "site-packages"))
        # Its numpy, pandas and notebooks are those of this Python; the module is not there.
        with open(os.path.join(packages, "outer.pth"), "w", encoding="utf-8") as file:
            file.write("\n".join(path for path in sys.path if path.endswith("-packages")) + "\n")
        run([python, "-m", "pip", "install", "-q", "--no-index", "--no-deps", wheel])
        check = f"import swing; assert swing.__file__.startswith({packages!r}), swing.__file__; print(swing.__file__)"
        run([python, "-c", check], cwd=folder)
        assert not os.path.exists(os.path.join(folder, "swing.so"))
        run([python, os.path.join(source, "test_swing.py")], cwd=folder)
        run([python, "-c", NOTEBOOK, os.path.join(source, "swing.ipynb")], cwd=folder)


if __name__ == "__main__":
    main()
