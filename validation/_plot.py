# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves as an SVG picture, without any library."""

WIDTH, HEIGHT = 420, 300
LEFT, RIGHT, TOP, BOTTOM = 55, 12, 28, 42
COLOURS = ("#1b6ca8", "#c0392b", "#2e8b57", "#8e44ad", "#d98c00", "#555555", "#17a2a2", "#b5651d")


def ticks(low, high):
    """Four to nine round numbers between two bounds."""
    span = high - low
    size = 10.0 ** len(str(int(1 / span))) if span < 1 else 1.0
    step = next(s for k in range(-8, 9) for s in (10.0**k, 2 * 10.0**k, 5 * 10.0**k) if span / s <= 8)
    first = int(low / step) - 1
    places = [k * step for k in range(first, first + 20)]
    return [round(p * size) / size if step >= 1 else round(p, 10) for p in places if low - 1e-9 * span <= p <= high + 1e-9 * span]


def panel(title, x_label, curves, left, top):
    """curves: (label, x values, y values, "line" or "points")."""
    xs = [x for _, x_values, _, _ in curves for x in x_values]
    ys = [y for _, _, y_values, _ in curves for y in y_values]
    low_x, high_x, low_y, high_y = min(xs), max(xs), min(ys), max(ys)
    high_x += 1e-9 + (low_x == high_x)
    high_y += 1e-9 + (low_y == high_y)

    def across(x):
        return left + LEFT + (x - low_x) / (high_x - low_x) * (WIDTH - LEFT - RIGHT)

    def up(y):
        return top + HEIGHT - BOTTOM - (y - low_y) / (high_y - low_y) * (HEIGHT - TOP - BOTTOM)

    frame = (left + LEFT, top + TOP, WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM)
    parts = ['<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="none" stroke="#888"/>'.format(*frame),
             f'<text x="{left + WIDTH / 2:.1f}" y="{top + 18}" text-anchor="middle" font-weight="bold">{title}</text>',
             f'<text x="{left + WIDTH / 2:.1f}" y="{top + HEIGHT - 8}" text-anchor="middle">{x_label}</text>']
    for x in ticks(low_x, high_x):
        parts.append(f'<text x="{across(x):.1f}" y="{top + HEIGHT - BOTTOM + 15}" text-anchor="middle">{x:g}</text>')
    for y in ticks(low_y, high_y):
        parts.append(f'<line x1="{left + LEFT}" x2="{left + WIDTH - RIGHT}" y1="{up(y):.1f}" y2="{up(y):.1f}" stroke="#eee"/>')
        parts.append(f'<text x="{left + LEFT - 6}" y="{up(y) + 4:.1f}" text-anchor="end">{y:g}</text>')
    for k, (label, x_values, y_values, kind) in enumerate(curves):
        colour = COLOURS[k % len(COLOURS)]
        points = [f"{across(x):.1f},{up(y):.1f}" for x, y in zip(x_values, y_values)]
        if kind == "line":
            parts.append(f'<polyline points="{" ".join(points)}" fill="none" stroke="{colour}" stroke-width="1.6"/>')
        else:
            parts += ['<circle cx="{}" cy="{}" r="3" fill="{}"/>'.format(*point.split(","), colour) for point in points]
        parts.append(f'<text x="{left + LEFT + 8}" y="{top + TOP + 14 + 13 * k}" fill="{colour}">{label}</text>')
    return parts


def write(path, panels, columns=3):
    """panels: (title, label of x, curves). Writes them side by side, `columns` to a row."""
    rows = (len(panels) + columns - 1) // columns
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{columns * WIDTH}" height="{rows * HEIGHT}" '
             'font-family="sans-serif" font-size="11"><rect width="100%" height="100%" fill="white"/>']
    for k, (title, x_label, curves) in enumerate(panels):
        parts += panel(title, x_label, curves, k % columns * WIDTH, k // columns * HEIGHT)
    path.write_text("\n".join([*parts, "</svg>\n"]), encoding="utf-8")
