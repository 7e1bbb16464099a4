"""The repository's Markdown pages, for the tests that read them."""
from pathlib import Path


def pages_of(root: Path):
    """{path from the root: text} of every page, build folders aside."""
    files = (file.relative_to(root) for file in sorted(root.rglob("*.md")))
    return {file.as_posix(): (root / file).read_text(encoding="utf-8") for file in files if file.parts[0] != "build"}
