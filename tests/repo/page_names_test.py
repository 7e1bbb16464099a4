#!/usr/bin/env python3
"""Checks that what Markdown pages name exists: page_names_test.py ROOT.

Links of all pages, and every `folder/file` in CONTRIBUTING.md, where <name> stands for any name.
"""
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True
from markdown_pages import pages_of  # noqa: E402

LINK = re.compile(r"\]\(([^)#:]+)(?:#[^)]*)?\)")
PATH = re.compile(r"`([\w.<>-]+/[\w./<>-]*)`")


def missing_links(root, name, text):
    for target in LINK.findall(text):
        if not (root / name).parent.joinpath(target).exists():
            yield f"{name}: the link to {target} leads nowhere"


def missing_files(root, name, text):
    for path in PATH.findall(text):
        if not any(root.glob(re.sub(r"<\w+>", "*", path).rstrip("/"))):
            yield f"{name}: {path} does not exist"


def main():
    root = Path(sys.argv[1]).resolve()
    pages = pages_of(root)
    problems = [problem for name, text in pages.items() for problem in missing_links(root, name, text)]
    problems += missing_files(root, "CONTRIBUTING.md", pages["CONTRIBUTING.md"])
    print("\n".join(problems) if problems else f"{len(pages)} pages: all that they name is there.")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
