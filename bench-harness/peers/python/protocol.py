"""The engine's end of the pipe protocol, version 1 (see bench-harness/PROTOCOL.md)."""

import json
import sys
import time

import numpy as np


class Refusal(Exception):
    """Why not, in words."""


def serve(name, make):
    """Answers commands until `quit` or the end of the input.

    `make` is a class with `version` and `tasks`; every set of a batch gets an instance of its own, which has
    `load(task, points)`, `call()`, which returns a result, and `hull(task, points, result)`, which returns a kind and a
    list of parts.
    """
    server = Server(name, make)
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
    def __init__(self, name, make):
        self.name, self.make = name, make
        self.task = self.peak = None
        self.sets, self.engines, self.results = [], [], []

    def answer(self, word, rest):
        """The reply, and the arrays that follow it."""
        if word == "version":
            return receipt(self.name, self.make), []
        if word == "load":
            return self.load(json.loads(rest)), []
        if word == "run":
            return self.run(json.loads(rest)), []
        if word == "hull":
            return self.hull(json.loads(rest)["set"] if rest else 0)
        if word == "counters":
            return {"counters": {"peak_bytes": self.peak} if self.peak else {}}, []
        raise Refusal(f"there is no command {word}")

    def load(self, header):
        self.sets, self.engines, self.results = [], [], []
        shape = (header.get("sets", 1), header["n"], header["dimension"])
        raw = sys.stdin.buffer.read(8 * shape[0] * shape[1] * shape[2])
        if shape[0] == 0:
            raise Refusal("no sets")
        if header["task"] not in self.make.tasks:
            raise Refusal(f"does not do {header['task']}")
        if header.get("boundary") == "all":
            raise Refusal("finds extreme points only")
        sets = np.frombuffer(raw, dtype="<f8").reshape(shape)
        engines = [self.make() for _ in sets]
        for engine, points in zip(engines, sets):
            engine.load(header["task"], points)
        self.task, self.sets, self.engines = header["task"], sets, engines
        return {"loaded": header["n"], "sets": len(sets)}

    def run(self, header):
        if len(self.sets) == 0:
            raise Refusal("no points were loaded")
        self.results = []
        before = reset_peak() if self.peak is None else None
        self.results, nanoseconds = sample(self.engines, header["samples"], header["inner"])
        if before is not None:
            self.peak = max(0, without_files("VmHWM:") - before)
        return {"nanoseconds": nanoseconds}

    def hull(self, number):
        if not self.results:
            raise Refusal("nothing was run")
        if not 0 <= number < len(self.results):
            raise Refusal(f"there is no set {number}")
        points = self.sets[number]
        kind, parts = self.engines[number].hull(self.task, points, self.results[number])
        lengths = np.array([len(part) for part in parts], dtype="<u4")
        indices = np.concatenate(parts).astype(np.int64) if len(parts) else np.empty(0, np.int64)
        indices = smallest_copies(points)[indices].astype("<u4")
        return {"kind": kind, "lengths": len(lengths), "indices": len(indices)}, [lengths, indices]


def receipt(name, make):
    return {
        "protocol": 1,
        "engine": name,
        "version": make.version,
        "clock_ns": clock_resolution(),
        "tasks": make.tasks,
        "build": "Python " + sys.version.split()[0],
    }


def sample(engines, samples, inner):
    """The last results, and the wall time of each sample of `inner` passes over the engines."""
    nanoseconds = []
    calls = [engine.call for engine in engines]
    results = []
    for _ in range(samples):
        results = [None] * len(calls)
        start = time.perf_counter_ns()
        for _ in range(inner):
            for number, call in enumerate(calls):
                results[number] = call()
        nanoseconds.append(time.perf_counter_ns() - start)
    return results, nanoseconds


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
    """Sets the peak of resident memory back, and returns what is resident, without the pages of files; None where that cannot be
    done."""
    try:
        with open("/proc/self/clear_refs", "w") as file:
            file.write("5")
        return without_files("VmRSS:")
    except OSError:
        return None


def without_files(label):
    """A size of resident memory without the pages of files, such as code, that are resident now."""
    return status(label) - status("RssFile:")


def status(label):
    with open("/proc/self/status") as file:
        return next(1024 * int(line.split()[1]) for line in file if line.startswith(label))
