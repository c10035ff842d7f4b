"""Makes the CSV files of this folder from an unpacked copy of the npm package vega-datasets.

    npm pack vega-datasets@3.2.1
    tar xzf vega-datasets-3.2.1.tgz
    python3 convert.py package/data .

Rows keep their order and numbers their digits. Rows without the first two coordinates are left out.
"""

import csv
import json
import pathlib
import sys


def load(path):
    """The JSON in `path`, numbers kept as they are written."""
    return json.loads(path.read_text(encoding="utf-8"), parse_float=str, parse_int=str)


def write(path, header, rows):
    with path.open("w", encoding="utf-8", newline="") as out:
        table = csv.writer(out, lineterminator="\n")
        table.writerow(header)
        for row in rows:
            if row[0] is not None and row[1] is not None:
                table.writerow(row)


def main(source, target):
    with (source / "airports.csv").open(encoding="utf-8", newline="") as airports:
        rows = [(a["longitude"], a["latitude"], a["iata"]) for a in csv.DictReader(airports)]
    write(target / "airports.csv", ["longitude", "latitude", "iata"], rows)

    events = load(source / "earthquakes.json")["features"]
    rows = [event["geometry"]["coordinates"] for event in events]
    write(target / "earthquakes.csv", ["longitude", "latitude", "depth_km"], rows)

    names = {
        "flipper_length_mm": "Flipper Length (mm)",
        "body_mass_g": "Body Mass (g)",
        "bill_length_mm": "Beak Length (mm)",
        "bill_depth_mm": "Beak Depth (mm)",
        "species": "Species",
    }
    penguins = load(source / "penguins.json")
    rows = [[penguin[name] for name in names.values()] for penguin in penguins]
    write(target / "penguins.csv", list(names), rows)


if __name__ == "__main__":
    main(*map(pathlib.Path, sys.argv[1:]))
