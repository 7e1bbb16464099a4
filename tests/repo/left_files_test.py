#!/usr/bin/env python3
"""Checks that source_files.py finds what a test leaves among the sources: left_files_test.py ROOT."""
import subprocess
import sys
import tempfile
from pathlib import Path

SCRIPT = Path(__file__).with_name("source_files.py")


def step(name, root):
    return subprocess.run([SCRIPT, name, root, root / "out"], stdout=subprocess.PIPE, text=True)


def main():
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for name in ("tests/unit", "build/release", "out", ".git"):
            (root / name).mkdir(parents=True)
        (root / "tests/unit/a.cpp").touch()
        step("list", root)
        for name in ("build/release/a.o", "out/b.o", ".git/index"):
            (root / name).touch()
        quiet = step("compare", root)
        (root / "tests/unit/left.png").touch()
        found = step("compare", root)
    right = quiet.returncode == 0 and found.returncode == 1 and found.stdout.startswith("tests/unit/left.png ")
    print("ok" if right else f"without a file: {quiet}\nwith one: {found}")
    return 0 if right else 1


if __name__ == "__main__":
    sys.exit(main())
