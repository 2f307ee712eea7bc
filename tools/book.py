#!/usr/bin/env python3
"""Make the book of the documents with mdBook (https://rust-lang.github.io/mdBook), and check all of its links.

    tools/book.py FOLDER     # FOLDER/index.html is the first page

The pages link to the README and to sources, which stand outside of docs/. So the repository's texts are laid out
as they stand there, and the sources that pages name are copied beside them.
"""

import html
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Pages behind those of docs/SUMMARY.md.
BESIDE = {
    "A crate to copy": "examples/template/README.md",
    "Architecture": "ARCHITECTURE.md",
    "Contributing": "CONTRIBUTING.md",
    "Changelog": "CHANGELOG.md",
}
KINDS = (".md", ".svg", ".csv", ".rs", ".rncf", ".toml", "LICENSE-MIT", "LICENSE-APACHE")
LINK = re.compile(r"\]\(([^)\s#]+\.md)")


def layout(source: pathlib.Path) -> None:
    """All texts that are checked in, the pictures, and the order of the pages."""
    tracked = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    for name in filter(None, tracked.split("\0")):
        target = source / name
        if name.startswith("generated/") or not name.endswith(KINDS):
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        if name.endswith(".md"):
            # mdBook calls the page of README.md index.html, and its own list of pages toc.html.
            text = re.sub(r"(\]\([^)\s]*)README\.md", r"\1index.md", (ROOT / name).read_text())
            target.write_text(text.replace("](docs/SUMMARY.md", "](toc.html"))
        else:
            shutil.copyfile(ROOT / name, target)
    order = (ROOT / "docs/SUMMARY.md").read_text()
    order = LINK.sub(lambda link: "](" + os.path.normpath("docs/" + link[1]), order)
    order += "\n# To change it\n\n" + "".join(f"- [{title}]({name})\n" for title, name in BESIDE.items())
    (source / "SUMMARY.md").write_text(order)


def broken(book: pathlib.Path) -> list[str]:
    """Links of the book's pages that lead nowhere, and pages to which none leads."""
    names: dict[pathlib.Path, set[str]] = {}

    def anchors(page: pathlib.Path) -> set[str]:
        if page not in names:
            names[page] = set(re.findall(r'\bid="([^"]+)"', page.read_text()))
        return names[page]

    pages = [page for page in book.rglob("*.html") if page.name not in ("404.html", "print.html", "toc.html")]
    wrong = []
    for page in pages:
        text = re.search(r"<main>(.*)</main>", page.read_text(), re.S)
        for link in re.findall(r'\b(?:href|src)="([^"]+)"', text[1] if text else ""):
            path, _, anchor = urllib.parse.unquote(html.unescape(link)).partition("#")
            if re.match(r"[a-z]+:", path):
                continue
            target = (page.parent / path).resolve() if path else page
            if not target.is_relative_to(book.resolve()) or not target.exists():
                wrong.append(f"{page.relative_to(book)} links to {link}, which is not there")
            elif anchor and target.suffix == ".html" and anchor not in anchors(target):
                wrong.append(f"{page.relative_to(book)} links to {link}, which has no such heading")
    listed = (book / "toc.html").read_text()
    for page in pages:
        name = page.relative_to(book).as_posix()
        if f'href="{name}"' not in listed:
            wrong.append(f"{name} is not in the list of pages")
    return wrong


def main() -> int:
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    book = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        layout(work / "pages")
        text = (ROOT / "docs/book.toml").read_text().replace('src = "."', 'src = "pages"')
        (work / "book.toml").write_text(text)
        if subprocess.run(["mdbook", "build", str(work), "--dest-dir", str(book)]).returncode:
            return 1
    wrong = broken(book)
    print("\n".join(wrong), file=sys.stderr, end="\n" if wrong else "")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
