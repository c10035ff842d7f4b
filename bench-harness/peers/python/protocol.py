"""The engine's end of the pipe protocol, version 1 (see bench-harness/PROTOCOL.md)."""

import json
import sys
import time

import numpy as np


class Refusal(Exception):
    """Why not, in words."""


def serve(name, engine):
    """Answers commands until `quit` or the end of the input.

    `engine` has `version`, `tasks`, and `load(task, points)`, `call()`, which returns a result, and
    `hull(task, points, result)`, which returns a kind and a list of parts.
    """
    pipe_in, pipe_out = sys.stdin.buffer, sys.stdout.buffer
    task = points = result = peak = None
    for line in pipe_in:
        word, _, rest = line.decode().strip().partition(" ")
        arrays = []
        try:
            if word == "version":
                reply = receipt(name, engine)
            elif word == "load":
                task = points = result = None
                header = json.loads(rest)
                count = header["n"] * header["dimension"]
                raw = np.frombuffer(pipe_in.read(8 * count), dtype="<f8")
                if header["task"] not in engine.tasks:
                    raise Refusal(f"does not do {header['task']}")
                if header.get("boundary") == "all":
                    raise Refusal("finds extreme points only")
                task, points = header["task"], raw.reshape(header["n"], header["dimension"])
                engine.load(task, points)
                reply = {"loaded": header["n"]}
            elif word == "run":
                if points is None:
                    raise Refusal("no points were loaded")
                header = json.loads(rest)
                before = rise() if peak is None else None
                result, nanoseconds = sample(engine, header["samples"], header["inner"])
                if peak is None:
                    peak = status("VmHWM:") - before if before is not None else 0
                reply = {"nanoseconds": nanoseconds}
            elif word == "hull":
                if result is None:
                    raise Refusal("nothing was run")
                kind, parts = engine.hull(task, points, result)
                lengths = np.array([len(part) for part in parts], dtype="<u4")
                indices = np.concatenate([np.asarray(part) for part in parts] or [np.empty(0)])
                indices = smallest_copies(points)[indices.astype(np.int64)].astype("<u4")
                reply = {"kind": kind, "lengths": len(lengths), "indices": len(indices)}
                arrays = [lengths, indices]
            elif word == "counters":
                reply = {"counters": {"peak_bytes": peak} if peak else {}}
            elif word == "quit":
                return
            else:
                raise Refusal(f"there is no command {word}")
        except Exception as error:  # a peer refuses in many ways, and all of them are reasons
            reply = {"refused": " ".join(str(error).split())[:300] or type(error).__name__}
        pipe_out.write(json.dumps(reply).encode() + b"\n")
        for array in arrays:
            pipe_out.write(array.tobytes())
        pipe_out.flush()


def receipt(name, engine):
    return {
        "protocol": 1,
        "engine": name,
        "version": engine.version,
        "clock_ns": clock_resolution(),
        "tasks": engine.tasks,
        "build": "Python " + sys.version.split()[0],
    }


def sample(engine, samples, inner):
    """The last result, and the wall time of each sample of `inner` calls in a row."""
    nanoseconds = []
    result = None
    for _ in range(samples):
        result = None
        start = time.perf_counter_ns()
        for _ in range(inner):
            result = engine.call()
        nanoseconds.append(time.perf_counter_ns() - start)
    return result, nanoseconds


def smallest_copies(points):
    """For each point the smallest index of its copies."""
    if len(points) == 0:
        return np.empty(0, dtype=np.int64)
    _, first, inverse = np.unique(points + 0.0, axis=0, return_index=True, return_inverse=True)
    return first[inverse.reshape(-1)]


def clock_resolution():
    """The smallest step of the clock that was seen, in nanoseconds."""

    def step():
        start = now = time.perf_counter_ns()
        while now == start:
            now = time.perf_counter_ns()
        return now - start

    return min(step() for _ in range(1000))


def rise():
    """Sets the peak of resident memory back, and returns what is resident; None where that cannot be done."""
    try:
        with open("/proc/self/clear_refs", "w") as file:
            file.write("5")
        return status("VmRSS:")
    except OSError:
        return None


def status(label):
    with open("/proc/self/status") as file:
        return next(1024 * int(line.split()[1]) for line in file if line.startswith(label))
