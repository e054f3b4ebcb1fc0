#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tables for docs/results.md from results.json files of `lixel compare`.

    tools/results_table.py RESULTS.json... > table.md

One row a scene, view and light, one column a technique: percent of light-facing samples misclassified; then for each technique the
geometric mean of its ratio to `focused` over the rows that have both, and the refusals by reason.
"""
import collections
import json
import math
import sys


def read(paths):
    rows, order = collections.defaultdict(dict), []
    for path in paths:
        with open(path, encoding="utf-8") as file:
            for row in json.load(file)["results"]:
                if row["technique"] == "exact":
                    continue
                if row["technique"] not in order:
                    order.append(row["technique"])
                rows[row["scene"], row["view"], row["light"]][row["technique"]] = row
    return rows, order


def percent(row):
    return None if row is None or row.get("refused") else row["misclassified_percent"]


def geometric_mean(values):
    return math.exp(sum(math.log(v) for v in values) / len(values)) if values else float("nan")


def main():
    if len(sys.argv) < 2 or sys.argv[1] in ("-h", "--help"):
        sys.exit(__doc__.strip())
    rows, order = read(sys.argv[1:])
    order.sort(key=lambda t: (t not in ("focused", "uniform"), t))
    print("| scene | view, light | " + " | ".join(f"`{t}`" for t in order) + " |")
    print("| --- | --- |" + " --- |" * len(order))
    for (scene, view, light), by in rows.items():
        cells = [f"{percent(by.get(t)):.3f}" if percent(by.get(t)) is not None else "refused" for t in order]
        print(f"| {scene} | {view}, {light} | " + " | ".join(cells) + " |")

    ratios = {t: [percent(by[t]) / percent(by["focused"]) for by in rows.values()
                  if percent(by.get(t)) and percent(by.get("focused"))] for t in order}
    means = {t: [percent(by[t]) for by in rows.values() if percent(by.get(t)) is not None] for t in order}
    print("\n| technique | rows | mean | against `focused` | unserved | refused |")
    print("| --- | --- | --- | --- | --- | --- |")
    for t in order:
        refused = collections.Counter(by[t]["refused"]["reason"] for by in rows.values() if t in by and by[t].get("refused"))
        unserved = sum(by[t].get("unserved", 0) for by in rows.values() if t in by and not by[t].get("refused"))
        reasons = ", ".join(f"{n} {reason}" for reason, n in sorted(refused.items()))
        mean = sum(means[t]) / len(means[t]) if means[t] else float("nan")
        print(f"| `{t}` | {len(ratios[t])} | {mean:.3f} | {geometric_mean(ratios[t]):.3f} | {unserved} | {reasons} |")


if __name__ == "__main__":
    main()
