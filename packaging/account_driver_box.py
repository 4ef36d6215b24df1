#!/usr/bin/env python3
"""Accounts for every sample of a take that was recorded from the emulator while it played another take again and again.

Usage: account_driver_box.py TAKE BASE LOG     LOG is the emulator's, of --log; BASE what it played (--take)

Every sample is the box's own of that index, or lies in a gap that an event tells; every gap is one that the emulator
made; everything that the emulator lost for certain lies in a gap.
"""
import json
import struct
import sys


def data_of(path):
    """An open WAV file (or RF64) at its samples, and their length in bytes."""
    file = open(path, "rb")
    head = file.read(12)
    assert head[:4] in (b"RIFF", b"RF64", b"RIFX") and head[8:] == b"WAVE", path
    large = None
    while True:
        name, length = struct.unpack("<4sI", file.read(8))
        if name == b"ds64":
            body = file.read(length)
            large = struct.unpack_from("<QQ", body)[1]
        elif name == b"data":
            start = file.tell()
            file.seek(0, 2)
            rest = file.tell() - start
            file.seek(start)
            return file, min(rest, large if length == 0xFFFFFFFF and large is not None else length)
        else:
            file.seek(length + (length & 1), 1)


def merged(stretches):
    result = []
    for first, end in sorted(stretches):
        if result and first <= result[-1][1]:
            result[-1][1] = max(result[-1][1], end)
        else:
            result.append([first, end])
    return result


def outside(inner, outer):
    """What of `inner` is not in `outer`; both merged."""
    left = []
    at = 0
    for first, end in inner:
        while at < len(outer) and outer[at][1] <= first:
            at += 1
        place, k = first, at
        while place < end:
            if k == len(outer) or outer[k][0] >= end:
                left.append((place, end))
                break
            if outer[k][0] > place:
                left.append((place, outer[k][0]))
            place = max(place, outer[k][1])
            k += 1
    return left


def main():
    take, base, log = sys.argv[1:4]
    info = json.load(open(f"{take}/take.json"))
    base_info = json.load(open(f"{base}/take.json"))
    channels = info["format"]["channels"]
    frame = 2 * channels
    events = [json.loads(line) for line in open(f"{take}/events.jsonl") if line.strip()]
    faults = [json.loads(line) for line in open(log) if line.strip()]
    file, length = data_of(f"{take}/signal.wav")
    frames = length // frame
    base_file, base_length = data_of(f"{base}/signal.wav")
    box = base_info["rig"]["driver_box"]
    period = box["slot_samples"] * len(base_info["rig"]["sources"])
    period = base_length // frame // period * period
    played = base_file.read(period * frame)

    gaps = [(e["sample"], e["sample"] + e["count"]) for e in events if e["kind"] == "dropped"]
    for (_, end), (first, _) in zip(gaps, gaps[1:]):
        assert end <= first, "gaps overlap"
    lost = merged([f["first"], f["first"] + f["frames"]] for f in faults if f["fault"] == "lost")
    unsent = merged([f["first"], f["first"] + f["frames"]] for f in faults if f["fault"] == "unsent")
    may_be = merged(lost + unsent)
    unknown = outside(merged(gaps), may_be)
    untold = [(a, min(b, frames)) for a, b in outside(lost, merged(gaps)) if a < frames]
    wires = sorted((e["sample"], e["count"], e["kind"]) for e in events if e["kind"].startswith("wire-"))

    # Stretches between gaps and changes of wires, each compared as a whole.
    wrong = 0
    silent = set()
    borders = sorted({0, frames, *(a for a, _ in gaps), *(b for _, b in gaps), *(w[0] for w in wires)})
    borders = [b for b in borders if b <= frames]
    gap_starts = {a for a, _ in gaps}
    next_wire = 0
    for first, end in zip(borders, borders[1:]):
        while next_wire < len(wires) and wires[next_wire][0] <= first:
            _, wire, kind = wires[next_wire]
            (silent.add if kind == "wire-pulled" else silent.discard)(wire)
            next_wire += 1
        for at in range(first, end, 280000):
            count = min(280000, end - at)
            file_part = file.read(count * frame)
            if first in gap_starts:
                wrong += count if file_part.strip(b"\0") else 0
                continue
            start = at % period * frame
            part = (played[start:] + played * (count // period + 1))[: count * frame] if start + count * frame > len(
                played) else played[start:start + count * frame]
            if silent:
                part = bytearray(part)
                for wire in silent:
                    part[2 * wire::frame] = bytes(count)
                    part[2 * wire + 1::frame] = bytes(count)
            wrong += 0 if file_part == bytes(part) else count

    kinds = {}
    for event in events:
        kinds[event["kind"]] = kinds.get(event["kind"], 0) + 1
    made = {}
    for fault in faults:
        made[fault["fault"]] = made.get(fault["fault"], 0) + 1
    total = sum(b - a for a, b in gaps)
    print(f"account: {frames} frames, {total} lost in {len(gaps)} gaps, {wrong} in stretches that differ")
    print(f"account: events {kinds}")
    print(f"account: the emulator's log {made}")
    if unknown:
        print(f"account: gaps that the emulator did not make: {unknown[:5]}")
    if untold:
        print(f"account: losses without a gap: {untold[:5]}")
    sys.exit(bool(wrong or unknown or untold))


main()
