#!/usr/bin/env python3
"""Finds files that tests left among the sources: source_files.py list|compare ROOT BUILD.

`list` notes ROOT's files in BUILD before the tests, `compare` fails after them when there are others. Build folders
and Git's own files do not count.
"""
import os
import sys
from pathlib import Path


def files_of(root, build):
    left_out = {root / ".git", root / "build", build}
    found = set()
    for folder, folders, files in os.walk(root):
        folders[:] = [name for name in folders if Path(folder, name) not in left_out]
        found.update(os.path.relpath(os.path.join(folder, name), root) for name in files)
    return found


def main():
    step, root, build = sys.argv[1], Path(sys.argv[2]).resolve(), Path(sys.argv[3]).resolve()
    note = build / "source_files.txt"
    if step == "list":
        note.write_text("\n".join(sorted(files_of(root, build))), encoding="utf-8")
        return 0
    left = sorted(files_of(root, build) - set(note.read_text(encoding="utf-8").split("\n")))
    for name in left:
        print(f"{name} was not there before the tests; they may write into their own temporary folders only")
    return 1 if left else 0


if __name__ == "__main__":
    sys.exit(main())
