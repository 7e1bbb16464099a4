#!/usr/bin/env bash
# Checks that all sources are formatted as .clang-format says: format_test.sh ROOT [--fix].
set -euo pipefail

cd "$1"
mapfile -d '' -t sources < <(find engine viewer cuda tests \
    \( -name '*.h' -o -name '*.cpp' -o -name '*.cu' -o -name '*.cuh' \) -print0)
if ((${#sources[@]} == 0)); then exit 0; fi

if [[ ${2:-} == --fix ]]; then
    clang-format -i --style=file "${sources[@]}"
elif ! clang-format --dry-run -Werror --style=file "${sources[@]}"; then
    echo "Some sources are not formatted; \`./test format --fix\` formats them." >&2
    exit 1
fi
