#!/usr/bin/env python3
"""Every type of a namespace is defined in one file: type_names_test.py ROOT.

Two types of one name link without a word, and functions made for one are called for the other. Types in unnamed
namespaces and inside others are their file's own.
"""
import re
import sys
from collections import defaultdict
from pathlib import Path

TYPE = re.compile(r"^(?:struct|class|union|enum(?: class)?) (?:alignas\(\w+\) |\[\[\w+\]\] )?(\w+)(?![\w:<])(?![^{]*;)")
OPENED = re.compile(r"^namespace( [\w:]+)? \{")
CLOSED = re.compile(r"^\}\s+// namespace")


def types_in(file):
    """The types at the left margin, with the namespaces around them."""
    namespaces = []
    for line in file.read_text(encoding="utf-8").splitlines():
        if match := OPENED.match(line):
            namespaces.append((match[1] or "").strip())
        elif CLOSED.match(line):
            namespaces.pop()
        elif (match := TYPE.match(line)) and namespaces and "" not in namespaces:
            yield "::".join([*namespaces, match[1]])


def main():
    root = Path(sys.argv[1]).resolve()
    places = defaultdict(set)
    for folder in ("engine", "cuda", "viewer"):
        for file in sorted((root / folder).rglob("*")):
            if file.suffix in {".h", ".cpp", ".cu", ".cuh"}:
                for name in types_in(file):
                    places[name].add(file.relative_to(root).as_posix())
    twice = {name: files for name, files in places.items() if len(files) > 1}
    for name, files in twice.items():
        print(f"{name} is defined in {', '.join(sorted(files))}")
    if len(places) < 500:
        print(f"only {len(places)} types were found: what this looks for is no longer how they are written")
        return 1
    if not twice:
        print(f"{len(places)} types, each in one file.")
    return 1 if twice else 0


if __name__ == "__main__":
    sys.exit(main())
