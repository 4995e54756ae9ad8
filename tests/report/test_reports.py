# SPDX-License-Identifier: GPL-3.0-or-later
"""Reports of a sphere, a brain with weeks, a comparison and a sweep in headless Chromium, from file:// without a network:
no error, nothing loaded, every view a coloured picture with marks, time limits, values of the files."""

import csv
import os
import re
import statistics
import struct
import sys
import time
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "cli"))
import _browser
import _command
import _heavy
import _runs

FIRST_PICTURE_S = 2.0
FRAME_MS = 100.0
LARGE_PICTURE_S = 10.0  # of five times as many vertices, without a graphics card
LARGE_FRAME_MS = 500.0
PROCESSORS = 2  # that draw a frame together
EVIL = "<script>alert(1)</script>"


def is_quiet():
    """Whether times say something: no more at work than a busy test run has."""
    return os.getloadavg()[0] < 1.5 * os.cpu_count() + 1


def check_limit(bench, what, milliseconds, limit):
    if is_quiet():
        bench.check(milliseconds < limit, f"{what} takes {milliseconds:.0f} ms, more than {limit:.0f}")
    elif milliseconds >= limit:
        print(f"{what} takes {milliseconds:.0f} ms on a busy machine (load {os.getloadavg()[0]:.1f}): not judged")


def check_clean(bench, browser, what):
    """No complaint of the browser, and nothing asked of a network."""
    bench.check(not browser.problems, f"{what}: the console says {browser.problems[:3]}")
    outside = [url for url in browser.requests if not url.startswith(("file:", "data:", "blob:"))]
    bench.check(not outside, f"{what}: it asks for {outside[:3]}")


def check_text(bench, page, what):
    """Nothing in the page names the machine or loads anything."""
    text = page.read_text(encoding="utf-8")
    for path in (str(bench.folder), str(bench.source), str(Path.home())):
        bench.check(len(path) < 4 or path not in text, f"{what}: it holds the path {path}")
    bench.check(not re.search(r"<(script|img|link|iframe)[^>]*(src|href)=\"?(?!data:)[^\">]", text), f"{what}: it refers to something outside")
    return text


def open_page(bench, browser, page, what, limit=None):
    """Opens a page; returns the milliseconds to its first picture."""
    bench.check(browser.open(page, 60), f"{what}: no picture within a minute; the console says {browser.problems[:3]}")
    milliseconds = browser.evaluate("corticleReport.sincePageStart")
    for _ in range(2):  # what else the machine does makes times longer, never shorter
        if limit is not None and milliseconds >= 1000 * limit:
            browser.open(page, 60)
            milliseconds = min(milliseconds, browser.evaluate("corticleReport.sincePageStart"))
    print(f"{what}: {page.stat().st_size / 1e6:.2f} MB, first picture after {milliseconds:.0f} ms")
    if limit is not None:
        check_limit(bench, f"{what}: the first picture", milliseconds, 1000 * limit)
    check_clean(bench, browser, what)
    return milliseconds


def stage_picture(browser):
    box = browser.evaluate("(({x, y, width, height}) => [x, y + scrollY, width, height])(document.querySelector('.stage').getBoundingClientRect())")
    return browser.screenshot(box, scale=0.3)


def check_views(bench, browser, what, marks):
    """Each view is a coloured picture, and its sides have the marks that belong there."""
    for view, (left, right) in marks.items():
        browser.evaluate(f"document.querySelector('[data-view={view}]').click()")
        browser.evaluate("corticleReport.viewer.stage.turn.then(() => corticleReport.viewer.stage.render())")
        shown, colored, hues = _browser.look(stage_picture(browser))
        bench.check(shown > 0.1 and colored > 0.05 and hues >= 4,
                    f"{what}, {view}: {shown:.2f} of the picture shown, {colored:.2f} coloured, {hues} hues")
        got = browser.evaluate("['left', 'right'].map((side) => document.querySelector('.mark-' + side).textContent)")
        bench.check(got == [left, right], f"{what}, {view}: marks {got}, expected {[left, right]}")
    bench.check("mm" in browser.evaluate("document.querySelector('.scale-bar').textContent"), f"{what}: no scale bar")


SLIDER_PASS = """(async () => {
    const slider = document.querySelector('.slider'), { stage } = corticleReport.viewer, times = [];
    const gl = stage.renderer.getContext();
    const drawn = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)); // waits for the picture
    for (let k = 0; k <= slider.max; ++k) {
        const began = performance.now();
        slider.value = k;
        slider.dispatchEvent(new Event('input'));
        await stage.turn;
        drawn();
        times.push(performance.now() - began);
        await new Promise(requestAnimationFrame);
    }
    return times;
})()"""


def slider_passes(browser):
    """Three passes of the slider: the milliseconds of every frame, from its event to the drawn picture, and those that the
    processors spent on a frame. Nothing is drawn or sent to graphics memory before, and the page is composed between frames,
    as for a reader who drags."""
    passes, spent = [], []
    for _ in range(3):
        time.sleep(1.0)  # until what came before is drawn
        before = browser.processor_seconds()
        passes.append(browser.evaluate(SLIDER_PASS, 180))
        if before is not None:
            spent.append(1000 * (browser.processor_seconds() - before) / len(passes[-1]))
    return passes, spent


def check_time(bench, browser, what, limit=FRAME_MS):
    """The slider and the keys move the time; in the best of three passes (what else the machine does makes times longer,
    never shorter) every frame takes less than the limit. Where the machine is busy, the processors' time has to do."""
    browser.wait_for("document.documentElement.dataset.complete === 'true'", 60)
    browser.key("Home")
    first = browser.evaluate("document.querySelector('.time').textContent")
    passes, spent = slider_passes(browser)
    last = browser.evaluate("document.querySelector('.time').textContent")
    medians, worst = [statistics.median(times) for times in passes], [max(times) for times in passes]
    numbers = lambda times: ", ".join(f"{milliseconds:.0f}" for milliseconds in times)
    print(f"{what}: {len(passes[0])} frames from {first} to {last}, passes with median {numbers(medians)} ms, worst {numbers(worst)} ms, "
          f"processors {numbers(spent)} ms a frame")
    bench.check(first != last, f"{what}: the slider changes nothing: {first}")
    check_limit(bench, f"{what}: half of the frames of the slider", min(medians), limit)
    check_limit(bench, f"{what}: the slowest frame of the slider", min(worst), limit)
    bench.check(not spent or min(spent) < PROCESSORS * limit, f"{what}: a frame takes {min(spent, default=0):.0f} ms of the processors")
    browser.key("ArrowLeft")
    bench.check(browser.evaluate("document.querySelector('.time').textContent") not in (last, ""), f"{what}: the left key changes nothing")
    browser.key("End")
    return last


def check_values(bench, browser, folder, what):
    """Plotted numbers are those of measures.csv; values at a click are those of the surface file, to the packing's error."""
    with open(folder / "measures.csv", encoding="utf-8", newline="") as stream:
        rows = list(csv.reader(stream))
    columns = {head.split(" [")[0]: [float(row[k]) for row in rows[1:]] for k, head in enumerate(rows[0])}
    for column in browser.evaluate("corticleReport.content.measures.map(({key, values}) => ({key, values}))"):
        expected = columns[column["key"]]
        same = all(a == b or (a is None and b != b) for a, b in zip(column["values"], expected, strict=True))
        bench.check(same, f"{what}: plotted {column['key']} {column['values']} are not {expected}")
    box = browser.evaluate("(({x, y, width, height}) => [x, y, width, height])(document.querySelector('.stage').getBoundingClientRect())")
    browser.click(box[0] + 0.5 * box[2], box[1] + 0.5 * box[3])
    bench.check(browser.wait_for("document.querySelector('.picked h3') !== null", 60), f"{what}: a click on the surface shows nothing")
    vertex = browser.evaluate("corticleReport.picker.vertex")
    frame = sorted(folder.glob("surface_*.vtp"))[-1]
    output = bench.accepted("export", folder, "--format", "ply", "--out", folder / "ply")
    bench.check("wrote" in output or output, f"{what}: no export of {frame}")
    values = ply_vertex(next((folder / "ply").glob("*.ply")), vertex)
    shown = browser.evaluate(f"""(async () => {{
        const body = corticleReport.bodies[0], frame = body.frames.length - 1, found = {{}};
        for (const key of body.scalarKeys) {{
            const {{low, high}} = body.frames[frame].scalars[key];
            found[key] = [(await body.values(frame, key))[{vertex}], (high[0] - low[0]) / 65534];
        }}
        return found;
    }})()""")
    compared = 0
    for key, (value, step) in shown.items():
        if key in values:
            compared += 1
            bench.check(abs(value - values[key]) <= 0.51 * step + 1e-6 * abs(value), f"{what}: {key} at vertex {vertex} is {value}, in the file {values[key]}")
    bench.check(compared >= 6, f"{what}: only {compared} values at vertex {vertex} could be compared")


def ply_vertex(path, vertex):
    """Properties of a vertex of a binary PLY of doubles."""
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    head = data[:end].decode().splitlines()
    first = next(k for k, line in enumerate(head) if line.startswith("element vertex"))
    names, sizes = [], {"double": "d", "float": "f"}
    form = "<"
    for line in head[first + 1:]:
        if not line.startswith("property "):
            break
        _, kind, name = line.split()
        names.append(name)
        form += sizes[kind]
    at = end + struct.calcsize(form) * vertex
    return dict(zip(names, struct.unpack(form, data[at:at + struct.calcsize(form)])))


def check_cut(bench, browser, what):
    """The cut shows cortex and white matter."""
    browser.evaluate("document.querySelector('[data-view=left-medial]').click()")
    browser.evaluate("corticleReport.viewer.stage.turn.then(() => corticleReport.viewer.stage.render())")
    _, _, rows, channels = _browser.pixels(stage_picture(browser))
    near = lambda r, g, b, color: max(abs(r - color[0]), abs(g - color[1]), abs(b - color[2])) < 12
    counts = {name: sum(near(*row[x:x + 3], color) for row in rows for x in range(0, len(row), channels))
              for name, color in {"cortex": (0xc4, 0x60, 0x4f), "white matter": (0xe9, 0xe6, 0xdf)}.items()}
    for name, count in counts.items():
        bench.check(count > 150, f"{what}: the section shows {count} pixels of {name}")


def check_turned_cut(bench, browser, what):
    """A cut that is chosen shows its section to the viewer, wherever he looks from."""
    for view in ("anterior", "posterior"):
        browser.evaluate(f"document.querySelector('[data-view={view}]').click()")
        keep = browser.evaluate("(corticleReport.viewer.setCutAxis('1'), corticleReport.viewer.stage.state.cut.keep)")
        bench.check(keep == {"anterior": -1, "posterior": 1}[view], f"{what}, {view}: the cut keeps {keep}")
    browser.evaluate("corticleReport.viewer.setCutAxis('')")


PLAIN = {"left": ("+y", "−y"), "superior": ("−x", "+x"), "posterior": ("−x", "+x"), "left-medial": ("−y", "+y")}
SIDES = {"left": ("A", "P"), "right": ("P", "A"), "superior": ("L", "R"), "inferior": ("R", "L"), "anterior": ("R", "L"),
         "posterior": ("L", "R"), "left-medial": ("P", "A"), "right-medial": ("A", "P")}


def check_phone(bench, browser, what):
    """A page as wide as a phone."""
    browser.resize(390, 844, 2, True)
    try:
        width = browser.evaluate("document.documentElement.scrollWidth")
        bench.check(width <= 390, f"{what}: the page is {width} pixels wide on a phone of 390")
    finally:
        browser.resize(1400, 1000)


def check_print(bench, browser, what):
    """What is printed has the sides of the picture, whatever the paper's are."""
    browser.evaluate("dispatchEvent(new Event('beforeprint'))")
    sides = browser.evaluate("[document.querySelector('.still canvas'), document.querySelector('.stage')].map((e) => (e.width || e.clientWidth) / (e.height || e.clientHeight))")
    bench.check(abs(sides[0] - sides[1]) < 0.02, f"{what}: the printed picture has sides {sides[0]:.2f}, the shown one {sides[1]:.2f}")


def sphere_page(bench, browser):
    folder = _runs.sphere(bench)
    check_text(bench, folder / "report.html", "sphere")
    open_page(bench, browser, folder / "report.html", "sphere", FIRST_PICTURE_S)
    check_views(bench, browser, "sphere", PLAIN)
    check_cut(bench, browser, "sphere")
    check_turned_cut(bench, browser, "sphere")
    browser.evaluate("document.querySelector('[data-view=oblique]').click()")
    check_time(bench, browser, "sphere")
    check_values(bench, browser, folder, "sphere")
    check_print(bench, browser, "sphere")
    check_clean(bench, browser, "sphere, after use")


def brain_page(bench, browser):
    """In a folder and with a file whose names are markup."""
    folder = _runs.brain(bench)
    open_page(bench, browser, folder / "report.html", "brain", FIRST_PICTURE_S)
    check_text(bench, folder / "report.html", "brain")
    check_views(bench, browser, "brain", SIDES)
    last = check_time(bench, browser, "brain")
    check_phone(bench, browser, "brain")
    bench.check("week 27" in last, f"brain: the last time is {last!r}, expected week 27")
    check_clean(bench, browser, "brain, after use")


def heavy_page(bench, browser, what, vertices, picture_s, frame_ms):
    """So many vertices at 16 weeks: all of them in a page of less than 40 MB, and quick enough to be used."""
    try:
        import numpy
    except ImportError as error:
        print(f"the {what} page is left out: {error} (python3-numpy brings it)")
        return
    folder = _runs.weeks(bench)
    count = _heavy.enlarge(numpy, folder, vertices)
    bench.accepted("report", folder, timeout=300)
    megabytes = (folder / "report.html").stat().st_size / 1e6
    bench.check(megabytes < 40, f"{what}: {megabytes:.1f} MB")
    open_page(bench, browser, folder / "report.html", what, picture_s)
    shape = browser.evaluate("[corticleReport.bodies[0].frames.length, corticleReport.bodies[0].content.vertices]")
    bench.check(shape == [16, count] and count >= vertices, f"{what}: {shape} times and vertices, expected {[16, count]}")
    check_time(bench, browser, what, frame_ms)
    check_rest(bench, browser, what)
    check_views(bench, browser, what, {"left": ("A", "P")})
    check_clean(bench, browser, what)


def check_rest(bench, browser, what):
    """Without a graphics card the picture is coarse while it moves and fine once it rests."""
    widths = browser.evaluate("""(async () => {
        const { viewer } = corticleReport, found = [];
        await viewer.player.go(1);
        found.push(viewer.canvas.width / viewer.stage.width);
        await new Promise((done) => setTimeout(done, 1000));
        return [...found, viewer.canvas.width / viewer.stage.width];
    })()""")
    bench.check(widths == [1, 2], f"{what}: {widths} pixels of the picture for one of the page, expected 1 moving and 2 at rest")


def middle_page(bench, browser):
    """The size at which a page has to be smooth."""
    heavy_page(bench, browser, "20,000 vertices", 20_000, FIRST_PICTURE_S, FRAME_MS)


def large_page(bench, browser):
    heavy_page(bench, browser, "100,000 vertices", 100_000, LARGE_PICTURE_S, LARGE_FRAME_MS)


def comparison_page(bench, browser):
    _runs.sphere(bench, "a")
    _runs.sphere(bench, "b", "tissue.alpha_t=1.6")
    output = bench.accepted("compare", "runs/a", "runs/b", "--out", "ab", timeout=300)
    bench.check("open ab/report.html" in output, f"compare does not name its page: {output[-200:]!r}")
    open_page(bench, browser, bench.folder / "ab/report.html", "comparison")
    check_text(bench, bench.folder / "ab/report.html", "comparison")
    check_views(bench, browser, "comparison", {"superior": ("−x", "+x")})
    check_time(bench, browser, "comparison")
    lines = browser.evaluate("[...document.querySelectorAll('.outlines .line')].map((line) => line.getAttribute('d').length)")
    bench.check(len(lines) == 2 and min(lines) > 500, f"comparison: outlines {lines}")
    check_clean(bench, browser, "comparison, after use")


def real_page(bench, browser):
    """A run with weeks beside a real brain: here the phantom itself."""
    _runs.brain(bench)
    bench.accepted("compare", "runs/brain", "brain.nii.gz@25", "--out", "real", timeout=300)
    open_page(bench, browser, bench.folder / "real/report.html", "real")
    check_text(bench, bench.folder / "real/report.html", "real")
    check_views(bench, browser, "real", {"left": ("A", "P")})
    bench.check("mean" in browser.evaluate("document.querySelector('main').textContent"), "real: no distance")
    check_clean(bench, browser, "real")


def sweep_page(bench, browser):
    bench.write("sweep.toml", f'base = "{bench.source}/cases/sphere.toml"\nmeasures = ["gi_hull", "area_ratio"]\npictures = false\ntitle = "{EVIL}"\n'
                '[set]\ngeometry.particles = 1500\noutput.pictures = "off"\ntime.end = 0.1\noutput.count = 1\n'
                '[[axis]]\nkey = "tissue.alpha_t"\nvalues = [1.4, 1.6, 1.8]\n')
    output = bench.accepted("sweep", "sweep.toml", "--out", "sweep", timeout=300)
    bench.check("open sweep/report.html" in output, f"sweep does not name its page: {output[-200:]!r}")
    (bench.folder / "sweep/report.html").unlink()
    bench.accepted("sweep", "sweep.toml", "--out", "sweep", "--no-report", timeout=300)
    bench.check(not (bench.folder / "sweep/report.html").exists(), "sweep --no-report writes a page")
    bench.accepted("sweep", "sweep.toml", "--out", "sweep", "--gather", "--quiet", timeout=300)
    open_page(bench, browser, bench.folder / "sweep/report.html", "sweep")
    text = check_text(bench, bench.folder / "sweep/report.html", "sweep")
    bench.check(EVIL not in text, "sweep: its title is not escaped")
    bench.check(browser.evaluate("document.querySelector('h1').textContent") == EVIL, "sweep: its title is not shown as text")
    check_views(bench, browser, "sweep", {"superior": ("−x", "+x")})
    browser.evaluate("document.querySelectorAll('.sort')[1].click(); document.querySelectorAll('.sort')[1].click()")
    order = browser.evaluate("[...document.querySelectorAll('.runs tbody tr')].map((row) => row.children[1].textContent)")
    bench.check(order == ["1.8", "1.6", "1.4"], f"sweep: sorted by alpha_t, the table has {order}")
    browser.evaluate("document.querySelector('.runs tbody tr').click()")
    bench.check(browser.wait_for("document.querySelectorAll('.mark.selected').length + document.querySelectorAll('.pane-names .selected').length === 2", 20),
                "sweep: a row selects no point and no shape")
    check_clean(bench, browser, "sweep")


def reports(bench):
    command = _browser.find()
    began = time.monotonic()
    with _browser.Browser(command) as browser:
        browser.resize(1400, 1000)
        for test in (sphere_page, brain_page, middle_page, large_page, real_page, comparison_page, sweep_page):
            test(bench, browser)
            print(f"{test.__name__}: {time.monotonic() - began:.0f} s", flush=True)


def without_webgl(bench):
    """Pictures and plots, and a line that says why."""
    folder = _runs.sphere(bench, EVIL.replace("/", "_"), "output.pictures=on")
    with _browser.Browser(_browser.find(), webgl=False) as browser:
        open_page(bench, browser, folder / "report.html", "without WebGL")
        text = browser.evaluate("document.querySelector('.warning-line')?.textContent || ''")
        bench.check("WebGL" in text, f"without WebGL: the page says {text!r}")
        bench.check(browser.evaluate("document.querySelectorAll('figure.measure').length") > 20, "without WebGL: no plots")
        bench.check(browser.evaluate("document.querySelector('h1').textContent") == EVIL.replace("/", "_"), "a name that is markup is not shown as text")
        check_clean(bench, browser, "without WebGL")


def refusals(bench):
    """What is no folder of results; a machine without three.js."""
    bench.refused(("report", "nowhere"), ("nowhere", "expected the folder of a run"))
    (bench.folder / "empty").mkdir()
    bench.refused(("report", "empty"), ("none of these",))
    folder = _runs.sphere(bench, "bare", "output.report=off", "time.end=0.05", "output.count=1")
    bench.check(not (folder / "report.html").exists(), "output.report = off: a report was written")
    os.environ["CORTICLE_THREE_JS"] = str(bench.folder / "nothing")
    bench.refused(("report", folder), ("three.js is not installed", "libjs-three"), status=3)
    del os.environ["CORTICLE_THREE_JS"]
    bench.accepted("report", folder, "--max-mb", "2")
    bench.check((folder / "report.html").stat().st_size < 2e6, "--max-mb 2: the page is larger")


if __name__ == "__main__":
    if _browser.find() is None:
        print("skipped: no Chromium here (apt-get install chromium)")
        sys.exit(_command.SKIPPED)
    if not Path("/usr/share/javascript/three/three.min.js").is_file():
        print("skipped: no three.js here (apt-get install libjs-three)")
        sys.exit(_command.SKIPPED)
    _command.main(__doc__, refusals, reports, without_webgl)
