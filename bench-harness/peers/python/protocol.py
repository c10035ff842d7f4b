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
    server = Server(name, engine)
    for line in sys.stdin.buffer:
        word, _, rest = line.decode().strip().partition(" ")
        if word == "quit":
            return
        try:
            reply, arrays = server.answer(word, rest)
        except Exception as error:  # a peer refuses in many ways, and all of them are reasons
            reply = {"refused": " ".join(str(error).split())[:300] or type(error).__name__}
            arrays = []
        sys.stdout.buffer.write(json.dumps(reply).encode() + b"\n")
        for array in arrays:
            sys.stdout.buffer.write(array.tobytes())
        sys.stdout.buffer.flush()


class Server:
    def __init__(self, name, engine):
        self.name, self.engine = name, engine
        self.task = self.points = self.result = self.peak = None

    def answer(self, word, rest):
        """The reply, and the arrays that follow it."""
        if word == "version":
            return receipt(self.name, self.engine), []
        if word == "load":
            return self.load(json.loads(rest)), []
        if word == "run":
            return self.run(json.loads(rest)), []
        if word == "hull":
            return self.hull()
        if word == "counters":
            return {"counters": {"peak_bytes": self.peak} if self.peak else {}}, []
        raise Refusal(f"there is no command {word}")

    def load(self, header):
        self.task = self.points = self.result = None
        shape = (header["n"], header["dimension"])
        raw = sys.stdin.buffer.read(8 * shape[0] * shape[1])
        if header["task"] not in self.engine.tasks:
            raise Refusal(f"does not do {header['task']}")
        if header.get("boundary") == "all":
            raise Refusal("finds extreme points only")
        points = np.frombuffer(raw, dtype="<f8").reshape(shape)
        self.engine.load(header["task"], points)
        self.task, self.points = header["task"], points
        return {"loaded": header["n"]}

    def run(self, header):
        if self.points is None:
            raise Refusal("no points were loaded")
        before = reset_peak() if self.peak is None else None
        self.result, nanoseconds = sample(self.engine, header["samples"], header["inner"])
        if before is not None:
            self.peak = status("VmHWM:") - before
        return {"nanoseconds": nanoseconds}

    def hull(self):
        if self.result is None:
            raise Refusal("nothing was run")
        kind, parts = self.engine.hull(self.task, self.points, self.result)
        lengths = np.array([len(part) for part in parts], dtype="<u4")
        indices = np.concatenate(parts).astype(np.int64) if len(parts) else np.empty(0, np.int64)
        indices = smallest_copies(self.points)[indices].astype("<u4")
        return {"kind": kind, "lengths": len(lengths), "indices": len(indices)}, [lengths, indices]


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


def reset_peak():
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
