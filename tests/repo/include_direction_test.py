#!/usr/bin/env python3
"""Checks that includes run downwards only, and what else a layer may not name: include_direction_test.py ROOT.

The table is the architecture. A layer sees itself and the layers listed for it; third-party and standard headers are
checked only where a rule below forbids them.
"""
import re
import sys
from pathlib import Path

SEES = {
    "engine/base": "",
    "engine/math": "base",
    "engine/kernels": "base math",
    "engine/scene": "base math kernels",
    "engine/io": "base math scene",
    "engine/examples": "base math scene io",
    "engine/builders": "base math scene io kernels",
    "engine/denoise": "base math",
    "engine/render": "base math scene io kernels builders denoise",
    "engine/report": "base math scene io kernels builders render",
    "engine/stress": "base math scene io kernels builders render report",
}
VIEWER_SEES = {
    "viewer/base": "",
    "viewer/model": "base",
    "viewer/ui": "base",
    "viewer/panels": "base model ui",
    "viewer/window": "base model ui panels",
    "viewer/commands": "base window",
    "viewer/bench": "base window commands",
    "viewer": "base commands bench",
}
ENGINE = set(SEES)
VIEWER = set(VIEWER_SEES)
ALLOWED = {layer: {layer} | {f"engine/{name}" for name in names.split()} for layer, names in SEES.items()}
ALLOWED |= {layer: ENGINE | {"cuda", layer} | {f"viewer/{name}" for name in names.split()}
            for layer, names in VIEWER_SEES.items()}
ALLOWED["cuda"] = {"cuda"} | {f"engine/{name}" for name in ("base", "math", "kernels", "builders", "render")}
ALLOWED["tests"] = ENGINE | VIEWER | {"cuda", "tests"}

# Kernels run on the GPU too: plain data, no containers, no exceptions, no input or output.
NOT_IN_KERNELS = {
    "algorithm", "any", "atomic", "deque", "exception", "fmt/format.h", "fstream", "functional", "iostream", "list",
    "map", "memory", "mutex", "optional", "ostream", "queue", "random", "set", "span", "sstream", "stdexcept", "string",
    "string_view", "thread", "tuple", "unordered_map", "unordered_set", "variant", "vector",
}
WINDOW_HEADER = re.compile(r"^(GL/|GLFW/|imgui|backends/imgui)")
WINDOW_FOLDERS = ("viewer/ui/", "viewer/panels/", "viewer/window/", "tests/viewer/")

INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')
SUFFIXES = {".h", ".cpp", ".cu", ".cuh"}


def layer_of(path):
    parts = path.split("/")
    return "/".join(parts[:2]) if parts[0] in ("engine", "viewer") and len(parts) > 2 else parts[0]


def problem_with_include(layer, quote, target, path, root):
    """What is wrong with one include, or None."""
    if quote == '"':
        if not (root / target).is_file():
            return f'"{target}" is not a file; includes are written from the repository\'s root'
        if layer_of(target) not in ALLOWED[layer]:
            return f"{layer} must not see {layer_of(target)}"
    if layer == "engine/kernels" and quote == "<" and target in NOT_IN_KERNELS:
        return f"kernels must not use <{target}>: they run on the GPU too"
    if WINDOW_HEADER.match(target) and not path.startswith(WINDOW_FOLDERS):
        return f"<{target}> belongs in {', '.join(WINDOW_FOLDERS[:3])}, which a build without the viewer leaves out"
    return None


def check_file(file, root):
    path = file.relative_to(root).as_posix()
    layer = layer_of(path)
    if layer not in ALLOWED:
        return [f"{path}: this folder is not in the table of {Path(__file__).name}"]
    problems = []
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        if match := INCLUDE.match(line):
            if problem := problem_with_include(layer, *match.groups(), path, root):
                problems.append(f"{path}:{number}: {problem}")
        elif "__CUDACC__" in line and path != "engine/base/host_device.h":
            problems.append(f"{path}:{number}: only engine/base/host_device.h may name __CUDACC__")
    return problems


def main():
    root = Path(sys.argv[1]).resolve()
    files = [file for folder in ("engine", "cuda", "viewer", "tests") for file in sorted((root / folder).rglob("*"))
             if file.suffix in SUFFIXES]
    problems = [problem for file in files for problem in check_file(file, root)]
    print("\n".join(problems) if problems else f"{len(files)} files: all includes run downwards.")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
