# SPDX-License-Identifier: GPL-3.0-or-later
"""What has to hold, and whether it does."""

import reference

FROM_GROWTH = 0.6      # the lineage folds late: its columns are compared well past the onset
LINEAGE_PERCENT = 3.0
LINEAGE_INDEX = 0.06
SPH_PERCENT = 6.0
AGREE_PERCENT = 3.0
ONSET = 0.03
OVERLAP = 0.001
LONGEST_S = 600.0      # of the thesis's case, 223,000 tets to t = 1, on two cores
LARGEST_NS = 100.0


def percent(a, b):
    return 100.0 * (a / b - 1.0)


def verdict(holds, text):
    return ("PASS" if holds else "DIFFERS", text)


def of_size(results, case, method, size):
    return next((r for r in results if (r["case"], r["method"], r["size"], r["slow"]) == (case, method, size, False)), None)


def against_lineage(results, at):
    """1: our tets against the columns of like resolution, our particles against our tets."""
    for size, column in ((100000, 1), (253000, 2)):
        fem = of_size(results, "b", "fem", size)
        if not fem:
            yield "missing", f"(b) FEM {size:,}: no run"
            continue
        rows = [row for row in reference.LINEAGE if row[0] >= FROM_GROWTH]
        for k, key, name in ((0, "area_mm2", "area"), (1, "volume_mm3", "volume")):
            off = [percent(at(fem, row[0])[key], row[column][k]) for row in rows]
            worst = max(off, key=abs)
            yield verdict(abs(worst) <= LINEAGE_PERCENT, f"(b) FEM {size:,}: {name} {worst:+.2f} % off the lineage from "
                          f"growth {FROM_GROWTH} on, at most {LINEAGE_PERCENT} %")
        worst = max((at(fem, row[0])["gi_hull"] - row[column][2] for row in rows), key=abs)
        yield verdict(abs(worst) <= LINEAGE_INDEX, f"(b) FEM {size:,}: hull index {worst:+.3f} off, at most {LINEAGE_INDEX}")
        for particles in (20000, 45000):
            sph = of_size(results, "b", "sph", particles)
            for key in ("area_mm2", "volume_mm3") if sph else ():
                worst = max((percent(at(sph, row[0])[key], at(fem, row[0])[key]) for row in rows), key=abs)
                yield verdict(abs(worst) <= SPH_PERCENT, f"(b) TL-SPH {particles:,} against FEM {size:,}: {key.split('_')[0]} "
                              f"{worst:+.2f} %, at most {SPH_PERCENT} %")


def against_each_other(results, at, finest):
    """2: the finest of both methods."""
    for case in ("a", "b"):
        sph, fem = finest(results, case, "sph"), finest(results, case, "fem")
        if not sph or not fem:
            continue
        pair = f"({case}) {sph['name']} against {fem['name']}"
        for t in (0.5, 1.0):
            for key in ("area_ratio", "volume_ratio", "gi_sphere"):
                off = percent(at(sph, t)[key], at(fem, t)[key])
                yield verdict(abs(off) <= AGREE_PERCENT, f"{pair}: {key} at t = {t} {off:+.2f} %, at most {AGREE_PERCENT} %")
        for run in (sph, fem):
            if case == "a":
                onset = run["onset_t"]
                holds = onset is not None and abs(onset - reference.ONSET_A) <= ONSET
                yield verdict(holds, f"(a) {run['name']}: onset at t = {'none' if onset is None else f'{onset:.3f}'}, theory {reference.ONSET_A}, within {ONSET}")
            yield verdict(run["most_overlap"] < OVERLAP,
                          f"({case}) {run['name']}: overlap up to {run['most_overlap']:.1e}, below {OVERLAP}")


def cost(results):
    """3: the thesis's finite elements."""
    fem = of_size(results, "a", "fem", 223000)
    if not fem:
        yield "missing", "(a) FEM 223,000: no run"
        return
    yield verdict(fem["wall_s"] < LONGEST_S, f"(a) FEM 223,000 to t = 1: {fem['wall_s']:.0f} s on {fem['threads']} threads, "
                  f"below {LONGEST_S:.0f} s")
    each = fem["ns_per_element_step"]
    yield verdict(each is not None and each < LARGEST_NS, f"(a) FEM 223,000: {each:.1f} ns a tet and step, below {LARGEST_NS:.0f}")


def all_of(results, at, finest):
    """("PASS" | "DIFFERS" | "missing", sentence) one by one."""
    yield from against_lineage(results, at)
    yield from against_each_other(results, at, finest)
    yield from cost(results)


def table(found):
    return "\n".join(["| | |", "| --- | --- |", *(f"| {word} | {what} |" for word, what in found)]) + "\n"
