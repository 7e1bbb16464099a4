#!/usr/bin/env python3
"""Runs the commands of all Markdown pages, so that none goes stale: readme_commands_test.py ROOT PROGRAM.

Each line of a fenced ```sh block is run in a scratch folder that mirrors the repository by links, with
build/release/glint being PROGRAM. A block that opens a window or takes long has a comment before it,
<!-- not run by the tests: WHY -->; of its commands only the program and the repository's files that they name must exist.
A page's blocks run in their order, each page in a folder of its own.
"""
import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
from markdown_pages import pages_of  # noqa: E402

BLOCK = re.compile(r"(<!-- not run by the tests: [^>]+ -->\n)?```sh\n(.*?)```", re.DOTALL)
TOP_LEVEL = {"assets", "cuda", "engine", "scenes", "shaders", "tests", "third_party", "viewer", "run", "test"}
TIMEOUT_S = 120


def commands(readme):
    """(command, is run) for each line of each sh block."""
    for match in BLOCK.finditer(readme):
        for line in match.group(2).splitlines():
            line = line.split("  #")[0].strip()
            if line and not line.startswith("#"):
                yield line, match.group(1) is None


def table_commands(readme):
    """The commands that the table names: each must explain itself."""
    for row in re.findall(r"^\| (`glint .*?) \|", readme, re.MULTILINE):
        first, *rest = re.findall(r"`([^`]+)`", row)
        words = [word for word in first.split()[1:] if re.fullmatch(r"[a-z]+", word)]
        yield words
        for other in rest:  # `glint bench rays`, `paths`: the same but for the last word
            if not other.startswith("glint "):
                yield words[:-1] + [other]
            else:
                yield [word for word in other.split()[1:] if re.fullmatch(r"[a-z]+", word)]


def unknown_commands(readme, program):
    for words in table_commands(readme):
        done = subprocess.run([program, *words, "--help"], stdin=subprocess.DEVNULL, capture_output=True)
        print(f"{'FAIL' if done.returncode else 'ok'}: glint {' '.join([*words, '--help'])}", flush=True)
        if done.returncode != 0:
            yield f"the table names `glint {' '.join(words)}`, which the program does not know"


def mirror(root, program, folder):
    for entry in root.iterdir():
        if entry.name not in {"build", ".git"}:
            (folder / entry.name).symlink_to(entry)
    (folder / "build/release").mkdir(parents=True)
    if program:
        (folder / "build/release/glint").symlink_to(program)


def missing_files(command, folder):
    for word in shlex.split(command):
        name = word.removeprefix("./")
        if (name.split("/")[0] in TOP_LEVEL or name == "build/release/glint") and not (folder / name).exists():
            yield f"{word} does not exist"


def failure(command, folder):
    environment = {key: value for key, value in os.environ.items() if key not in {"DISPLAY", "WAYLAND_DISPLAY"}}
    try:
        done = subprocess.run(command, shell=True, cwd=folder, env=environment, timeout=TIMEOUT_S,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    except subprocess.TimeoutExpired:
        return f"took more than {TIMEOUT_S} s"
    return f"exit {done.returncode}\n{done.stdout[-2000:]}" if done.returncode != 0 else None


def failures_of_page(name, text, root, program):
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        mirror(root, program, folder)
        for command, is_run in commands(text):
            problems = list(missing_files(command, folder))
            if is_run and not problems:
                problems = [problem for problem in [failure(command, folder)] if problem]
            print(f"{'FAIL' if problems else 'ok' if is_run else 'ok, not run'}: {name}: {command}", flush=True)
            yield from (f"{name}: {command}: {problem}" for problem in problems)


def main():
    root, program = Path(sys.argv[1]).resolve(), sys.argv[2] if len(sys.argv) > 2 else ""
    pages = pages_of(root)
    failures = list(unknown_commands(pages["README.md"], program)) if program else []
    for name, text in pages.items():
        if BLOCK.search(text):
            failures += failures_of_page(name, text, root, program)
    print("\n".join(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
