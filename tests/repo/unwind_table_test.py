#!/usr/bin/env python3
"""Checks that the programs' exceptions can be unwound everywhere: unwind_table_test.py ROOT PROGRAM.

The binary search table in .eh_frame_hdr must name the entry of each function's code (LSB 5.0, "DWARF Extensions"): an entry that
is missing, or hidden by an empty one at its address, makes an exception that passes through there abort.
"""
import struct
import subprocess
import sys

TABLE_RELATIVE_4 = 0x3B  # DW_EH_PE_datarel | DW_EH_PE_sdata4


def sections(program):
    """Name to (address, bytes) of the two sections."""
    listing = subprocess.run(["readelf", "-SW", program], capture_output=True, text=True, check=True).stdout
    data = open(program, "rb").read()
    found = {}
    for line in listing.splitlines():
        words = line.partition("]")[2].split()
        if words and words[0] in (".eh_frame", ".eh_frame_hdr"):
            address, offset, size = (int(word, 16) for word in words[2:5])
            found[words[0]] = (address, data[offset:offset + size])
    return found


def frame_entries(address, data):
    """(start, length in bytes, address of the entry) of each function in .eh_frame."""
    at = 0
    while at + 4 <= len(data):
        length, = struct.unpack_from("<I", data, at)
        if length == 0:
            at += 4
            continue
        common, = struct.unpack_from("<I", data, at + 4)
        if common != 0:
            start, size = struct.unpack_from("<iI", data, at + 8)
            yield address + at + 8 + start, size, address + at
        at += 4 + length


def table_entries(address, data):
    """Start to the address of the entry that the table names for it; the last of several, as the search finds it."""
    version, _, count_encoding, table_encoding = data[:4]
    assert (version, count_encoding, table_encoding) == (1, 3, TABLE_RELATIVE_4), "an unknown table"
    count, = struct.unpack_from("<I", data, 8)
    pairs = (struct.unpack_from("<ii", data, 12 + 8 * i) for i in range(count))
    return {address + start: address + entry for start, entry in pairs}


def check(program):
    """Whether it is as it should be."""
    found = sections(program)
    table = table_entries(*found[".eh_frame_hdr"])
    entries = [entry for entry in frame_entries(*found[".eh_frame"]) if entry[1] > 0]
    missing = [start for start, _, entry in entries if table.get(start) != entry]
    for start in missing[:20]:
        print(f"0x{start:x}: an exception that passes here aborts")
    print(f"{program}: {len(entries)} functions, {len(missing)} that no exception can pass")
    return not missing and len(entries) >= 100


def main():
    program = sys.argv[2] if len(sys.argv) > 2 else ""
    if not program:
        print("There is no program to check.")
        return 0
    return 0 if all([check(program), check(f"{program}-measure")]) else 1


if __name__ == "__main__":
    sys.exit(main())
