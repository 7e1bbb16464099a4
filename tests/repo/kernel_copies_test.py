#!/usr/bin/env python3
"""Checks that no code of less optimisation holds a function of the kernels: kernel_copies_test.py ROOT PROGRAM.

Of an inline function that several objects hold, the linker keeps any copy. Commands, panels and readers are compiled with less
optimisation than kernels, and a copy of theirs would slow these down.
"""
import json
import re
import subprocess
import sys
from pathlib import Path

KERNELS = re.compile(r"/engine/render/(cpu_|sppm_kernel|first_hits|path_replay)")


def level(command):
    """The last one that is named counts."""
    return (re.findall(r"\s-O(\S*)", command) or ["0"])[-1]


def shared_functions(objects):
    """Glint's own functions that may stand in several objects; destructors, which kernels do not wait for, aside."""
    listing = subprocess.run(["nm", "-C", "--defined-only", *objects], capture_output=True, text=True, check=True).stdout
    names = (line.split(" ", 2)[2] for line in listing.splitlines() if re.match(r"[0-9a-f]+ [WV] ", line))
    return {name for name in names if re.match(r"(?:\S+ )?glint::", name) and "~" not in name}


def main():
    build = Path(sys.argv[2]).parent
    commands = json.loads((build / "compile_commands.json").read_text())
    entries = [(build / re.search(r" -o (\S+)", entry["command"])[1], entry) for entry in commands]
    built = [(path, entry) for path, entry in entries if path.suffix == ".o" and path.exists()]
    kernels = [(path, entry) for path, entry in built if KERNELS.search(entry["file"])]
    if not kernels or any(level(entry["command"]) != "3" for _, entry in kernels):
        print("skipped: the kernels of this build are not optimised")
        return 0
    lesser = [path for path, entry in built
              if path.relative_to(build).parts[0] != "tests" and level(entry["command"]) in ("0", "1")]
    if not lesser:
        print("no code of this build has less optimisation")
        return 1
    both = shared_functions([path for path, _ in kernels]) & shared_functions(lesser)
    for name in sorted(both):
        print(f"{name}: in the kernels, and in code of less optimisation")
    return 1 if both else 0


sys.exit(main())
