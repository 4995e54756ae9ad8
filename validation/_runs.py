# SPDX-License-Identifier: GPL-3.0-or-later
"""What the comparisons share: making or finding runs of several sizes, and what is read from a run folder."""

import argparse
import csv
import datetime
import json
import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SKIPPED = 77
HALF = 0.5
STAMP = re.compile(r"^\[([^]]+)\] \[run\] \[info\] (.*)$")
MOST_REJECTED_SHARE = 0.001


def faults(result, most_overlap):
    """What must not happen in a run, whatever the body and the resolution."""
    name = f"{result['particles']} particles"
    if result["most_overlap"] > most_overlap:
        yield f"{name}: overlap up to {result['most_overlap']}, expected at most {most_overlap}"
    if result["rejected_steps"] > MOST_REJECTED_SHARE * result["steps"]:
        yield f"{name}: {result['rejected_steps']} rejected steps"
    if result["least_J"] <= 0:
        yield f"{name}: J down to {result['least_J']}"


def parse_arguments(description, sizes, add=None):
    """--command, --out, --runs, --sizes; the first two from the environment unless given."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--command", type=Path, default=os.environ.get("CORTICLE", ROOT / "build/release/bin/corticle"))
    parser.add_argument("--out", type=Path, default=os.environ.get("CORTICLE_OUT"), help="where runs are written")
    parser.add_argument("--runs", type=Path, help="folder of existing runs: only read, nothing is run")
    parser.add_argument("--sizes", type=int, nargs="+", default=sizes, help="numbers of particles")
    if add:
        add(parser)
    arguments = parser.parse_args()
    arguments.sizes = sorted(arguments.sizes)
    return arguments


def read_summary(folder):
    try:
        return json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}


def is_complete(folder):
    return read_summary(folder).get("status") == "completed"


def make_run(arguments, case, folder, settings):
    """Makes the run, or goes on with it when it was interrupted."""
    words = [str(Path(arguments.command).resolve()), "run", str(case), "--out", str(folder), "--resume"]
    words += [word for setting in settings for word in ("--set", setting)]
    print(" ".join(words), flush=True)
    return subprocess.run(words, check=False).returncode == 0


def has_run(arguments, case, folder, settings):
    """Makes the run, unless runs are only read; whether it is complete, which it says where it is not."""
    if not arguments.runs:
        make_run(arguments, case, folder, settings)
    if is_complete(folder):
        return True
    print(f"{folder}: no complete run, left out")
    return False


def folders(arguments, case, letter, settings, out):
    """(size, folder) of every run that is complete; says which are not."""
    base = arguments.runs or Path(arguments.out or out)
    found = []
    for size in arguments.sizes:
        folder = base / f"{letter}{size // 1000}"
        if has_run(arguments, case, folder, [f"geometry.particles={size}", *settings]):
            found.append((size, folder))
    return found


def read_measures(folder):
    """Rows of measures.csv: key (without its unit) -> number."""
    with open(folder / "measures.csv", encoding="utf-8", newline="") as stream:
        return [{key.split(" ")[0]: float(value) for key, value in row.items()} for row in csv.DictReader(stream)]


def nearest_row(rows, t):
    """(number, row) of the output time nearest to t."""
    return min(enumerate(rows), key=lambda entry: abs(entry[1]["t"] - t))


def log_times(folder):
    """(time, text) of the lines of run.log."""
    text = (folder / "run.log").read_text(encoding="utf-8")
    matches = filter(None, map(STAMP.match, text.splitlines()))
    return [(datetime.datetime.fromisoformat(match[1]), match[2]) for match in matches]


def wall_at(folder, summary, t):
    """Wall time up to output time t [s]: the whole less what came after; None when the run was resumed or lacks t."""
    lines = log_times(folder)
    if any(text.startswith("resumed") for _, text in lines):
        return None
    there = [time for time, text in lines if text.startswith(f"t = {t:.4f}:")]
    return summary["wall_s"] - (lines[-1][0] - there[0]).total_seconds() if there else None


def at_time(rows, t):
    row = nearest_row(rows, t)[1]
    return {key: row[key] for key in ("t", "area_ratio", "volume_ratio", "gi_sphere", "gi_hull")}


def describe(folder):
    """What the tables show of a run."""
    summary, rows = read_summary(folder), read_measures(folder)
    half = at_time(rows, HALF) | {"wall_s": wall_at(folder, summary, HALF)}
    end = at_time(rows, 1.0) | {"wall_s": summary["wall_s"]}
    result = {key: summary[key] for key in ("version", "particles", "spacing_mm", "threads", "steps", "rejected_steps",
                                            "zero_mode_share")}
    result["onset_t"] = summary["onset_t"]
    result["most_overlap"] = max(row["overlap_area_share"] for row in rows)
    result["most_penetration_in_spacings"] = max(row["max_penetration_mm"] for row in rows) / summary["spacing_mm"]
    result["least_J"] = min(row["J_min"] for row in rows)
    return result | {"half": half, "end": end}


def number(value, form):
    return "-" if value is None else format(value, form)


def table(columns, results):
    """A Markdown table; columns: (heading, function of a result, format)."""
    lines = ["| " + " | ".join(heading for heading, _, _ in columns) + " |", "|" + " ---: |" * len(columns)]
    lines += ["| " + " | ".join(number(get(result), form) for _, get, form in columns) + " |" for result in results]
    return "\n".join(lines) + "\n"


def time_table(results, when):
    """Measures at one time."""
    def of(key):
        return lambda result: result[when][key]

    columns = [("particles", lambda r: r["particles"], ",d"), ("t", of("t"), ".2f"), ("area ratio", of("area_ratio"), ".3f"),
               ("volume ratio", of("volume_ratio"), ".3f"), ("sphere index", of("gi_sphere"), ".3f"),
               ("hull index", of("gi_hull"), ".3f"), ("wall s", of("wall_s"), ".0f")]
    return table(columns, results)


def control_table(results):
    """What must stay small."""
    columns = [("particles", lambda r: r["particles"], ",d"), ("spacing mm", lambda r: r["spacing_mm"], ".3f"),
               ("onset t", lambda r: r["onset_t"], ".4f"), ("most overlap", lambda r: r["most_overlap"], ".1e"),
               ("most penetration / spacing", lambda r: r["most_penetration_in_spacings"], ".4f"),
               ("least J", lambda r: r["least_J"], ".3f"),
               ("zero-mode share", lambda r: r["zero_mode_share"], ".3f"), ("steps", lambda r: r["steps"], ",d"),
               ("rejected", lambda r: r["rejected_steps"], "d"), ("threads", lambda r: r["threads"], "d")]
    return table(columns, results)


def write_results(folder, title, results, sections):
    """results.json and results.md beside the script; sections: (heading, text)."""
    (folder / "results.json").write_text(json.dumps(results, indent=2) + "\n", encoding="utf-8")
    parts = [f"# {title}\n\nWritten by `run.py`; see [README.md](README.md) for what is compared.\n"]
    parts += [f"## {heading}\n\n{text}" for heading, text in sections]
    (folder / "results.md").write_text("\n".join(parts), encoding="utf-8")
    print("\n".join(parts))


def finish(problems):
    """Prints what differs and ends the process."""
    for problem in problems:
        print("DIFFERS:", problem)
    sys.exit(1 if problems else 0)
