#!/usr/bin/env bash
# Installs the program into a folder of its own and renders an installed scene there: install_test.sh ROOT PROGRAM.
set -euo pipefail

program=$2
if [[ -z $program ]]; then
    echo "the program was not built"
    exit 0
fi
build=$(dirname "$program")
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT

cmake --install "$build" --prefix "$prefix" >"$prefix/install.log"
cd "$prefix"
scenes=share/glint/scenes
test -s $scenes/glint.schema.json
for page in README.md scenes/README.md; do test -s "share/doc/Glint/$page"; done
for scene in "$1"/scenes/*.json "$1"/scenes/*.txt; do cmp "$scene" "$scenes/$(basename "$scene")"; done

bin/glint bench paths --help >measure.txt
bin/glint stress --list >>measure.txt
test -s measure.txt
bin/glint render $scenes/environment_mesh.json -o picture.png --size 32x32 --passes 1
test -s picture.png
if grep -q '^GLINT_VIEWER:BOOL=ON' "$build/CMakeCache.txt"; then
    bin/glint view $scenes/cornell.json --headless --size 640x360 --passes 1 --screenshot window.png
    test -s window.png
fi
