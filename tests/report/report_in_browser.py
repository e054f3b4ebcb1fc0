#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Uses a report as a reader does, in headless Chromium, through the WebDriver protocol (W3C WebDriver, level 2).

    report_in_browser.py REPORT.html [--screenshots FOLDER]

Exit codes: 0 all well, 1 something is wrong (said on standard error), 77 there is no browser here. With
LIXEL_REQUIRE_BROWSER=1 in the environment a missing browser is wrong too.
"""
import argparse
import base64
import http.client
import os
import pathlib
import re
import shutil
import sys
import time

from web_driver import Browser, check

SKIPPED = 77

# Reads a canvas through a copy: reading the page's own makes the browser complain on its console.
PIXELS = ("const pixels = canvas => { const copy = new OffscreenCanvas(canvas.width, canvas.height)"
          ".getContext('2d', {willReadFrequently: true}); copy.drawImage(canvas, 0, 0);"
          " return copy.getImageData(0, 0, canvas.width, canvas.height).data; };")


def pictures_appear(page):
    page.wait_for("the pictures are drawn", PIXELS + "const all = [...document.querySelectorAll('.pane canvas')];"
                  " return all.length > 3 && all.every(canvas => pixels(canvas)[3] === 255)")


def differences_become_whole_pictures(page):
    """A picture that is stored as its difference from another one has no holes."""
    holes = page.run(PIXELS + "return (async () => { let holes = 0; for (const row of shown.group) {"
                     " const data = pixels(await picture(row, 'shaded'));"
                     " for (let i = 3; i < data.length; i += 4) holes += data[i] !== 255; } return holes; })()")
    check(holes == 0, f"the pictures have no holes: {holes}")


def split_of(page):
    return page.run("return parseFloat(document.getElementById('divider').style.left)")


def slider_moves(page):
    check(split_of(page) == 50, "the divider starts in the middle")
    page.drag("#divider", -150, 0)
    dragged = split_of(page)
    check(5 < dragged < 45, f"dragging the divider to the left moves it there: {dragged}")
    page.run("document.getElementById('split').focus()")
    page.type("#split", "\ue010")  # End
    check(split_of(page) == 100, "the bar moves the divider by keys")
    clip = page.run("return getComputedStyle(document.getElementById('pane-right')).clipPath")
    check("100%" in clip, f"the right picture is hidden behind the left one: {clip}")
    page.run("setSplit(50)")


def techniques_change(page):
    name = "return document.getElementById('tag-right').textContent"
    before = page.run(name)
    page.click(".tile [data-side=right][aria-pressed=false]")
    check(page.run(name) != before, "a tile's button puts its picture on the right")
    left = page.run("return document.getElementById('tag-left').textContent")
    page.click("#swap")
    check(page.run(name) == left, "swapping turns left and right")
    page.click("#swap")


def red_pixels(page):
    """Of the right picture, once it is drawn: the page draws when it has decoded what it needs."""
    return page.run(PIXELS + "return (async () => { await redraw(); let red = 0;"
                    "const d = pixels(document.querySelector('#pane-right canvas'));"
                    "for (let i = 0; i < d.length; i += 4) red += d[i] > 200 && d[i + 1] < 60 && d[i + 2] < 80;"
                    "return red; })()")


def error_overlay_toggles(page):
    """A scene may be red itself: the overlay makes more of it."""
    page.run("showPair(shown.group[0], shown.group.at(-1))")
    at_first = red_pixels(page)
    page.click("#show-error")
    without = red_pixels(page)
    check(at_first > without, f"the error is shown in red at first: {at_first} red pixels, {without} without it")
    page.click("#show-error")
    check(red_pixels(page) == at_first, "with the overlay it is red again")


def maps_show_with_their_legends(page):
    """Footprint and density, one at a time; both look other than the picture, and than each other."""
    page.run("showPair(shown.group.at(-1), shown.group.find(row => row.density_lixels_per_pixel))")
    drawn = (PIXELS + "return (async () => { await redraw();"
             " return pixels(document.querySelector('#pane-right canvas')).join(); })()")
    seen = {page.run(drawn)}
    for name, words in (("footprint", "pixels a lixel"), ("density", "lixels a pixel")):
        page.click(f"#show-{name}")
        check(page.run("return document.querySelectorAll('#legend .ramp').length") == 1, "one map is shown at a time")
        check(page.run("return document.querySelectorAll('#legend .ramp i').length") > 10, f"the {name} has a legend")
        check(words in page.run("return document.getElementById('legend').innerText"), f"which says: {words}")
        seen.add(page.run(drawn))
    check(len(seen) == 3, "each map is drawn over the picture")
    page.click("#show-density")
    check(page.run("return document.querySelectorAll('#legend .ramp').length") == 0, "the legend goes with its map")


def zoom_works(page):
    scale = "return zoom.scale"
    page.run("document.getElementById('stage').scrollIntoView({block: 'center'})")
    page.wheel("#stage", 60, 40, -480)
    check(page.run(scale) > 2, "the wheel enlarges")
    moved = page.run("return zoom.x")
    page.drag("#tag-left", 40, 30)  # the tag lets the pointer through to the picture
    check(page.run("return zoom.x") != moved, "dragging moves the picture")
    for _ in range(4):
        page.click("#zoom-in")
    rendering = page.run("return getComputedStyle(document.querySelector('#pane-left canvas')).imageRendering")
    check(rendering == "pixelated", "enlarged pixels stay squares")
    same = page.run("return new Set([...document.querySelectorAll('.pane canvas')].map(c => c.style.transform)).size")
    check(same == 1, "all pictures move together")
    before = page.run(scale)
    page.type("#stage", "-")
    check(page.run(scale) < before, "the minus key makes it smaller")
    page.click("#zoom-fit")
    check(page.run("return zoom.scale === 1 && zoom.x === 0 && zoom.y === 0"), "Fit shows all")


def next_view_opens(page):
    if page.run("return document.getElementById('group-field').hidden"):
        return
    page.click("#group-on")
    pictures_appear(page)
    check(page.run("return document.getElementById('group').selectedIndex") == 1, "the next view is shown")
    page.click("#rows-table tbody tr td button")
    pictures_appear(page)


def is_path(page):
    return page.run("return run.results.some(row => row.temporal)")


def tables_sort(page):
    for start in ("Misclassified", *(["Flips"] if is_path(page) else [])):
        table_sorts_by(page, start)


def table_sorts_by(page, start):
    heading = ("[...document.querySelectorAll('#rows-table thead th')]"
               ".findIndex(h => h.textContent.startsWith('%s'))" % start)
    values = ("const at = %s; return [...document.querySelectorAll('#rows-table tbody tr')]"
              ".map(r => Number(r.cells[at].textContent))" % heading)
    index = page.run("return " + heading) + 1
    state = f"return document.querySelector('#rows-table thead th:nth-child({index})').ariaSort"
    check(page.run(state) == "none", "a table starts unsorted")
    for order, key in (("descending", lambda v: -v), ("ascending", lambda v: v)):
        page.click(f"#rows-table thead th:nth-child({index}) button")
        seen = page.run(values)
        check(page.run(state) == order, f"the heading says {order}")
        check(seen == sorted(seen, key=key) and len(set(seen)) > 1, f"the rows are {order}: {seen}")
    sorted_headings = page.run("return document.querySelectorAll('#rows-table th:not([aria-sort=none])').length")
    check(sorted_headings == 1, "one heading is sorted at a time")


def charts_show(page):
    page.run("scrollTo(0, 0)")
    bars = page.run("return [...document.querySelectorAll('#charts svg')].map(s => s.querySelectorAll('rect').length)")
    if page.run("return Boolean(run.study?.lookups)"):
        check(bars == [], f"lookups have charts of their own: {bars}")
        return
    expected = 3 if is_path(page) else 2  # error, cost, and flips
    check(len(bars) == expected and min(bars) > 1, f"error and cost have bars, along a path flips too: {bars}")


def flips_show(page):
    if not is_path(page):
        return
    svg = "document.querySelector('#charts .chart:last-child svg')"
    columns = page.run(f"return {svg}.querySelectorAll('rect.flips').length")
    expected = page.run("return summary.filter(row => row.technique !== 'exact')"
                        ".reduce((sum, row) => sum + row.pairs.length, 0)")
    check(columns == expected > 0, f"each pair of frames has its column: {columns} of {expected}")
    highest = page.run(f"return Math.max(...[...{svg}.querySelectorAll('rect.flips')]"
                       ".map(r => r.height.baseVal.value))")
    check(highest == 38, f"the highest column fills its strip: {highest}")
    told = page.run("return document.getElementById('summary-note').textContent")
    check("9 frames from 0.5 s to 4.5 s" in told, f"the path is told: {told}")


def experiment_shows(page):
    """The paper's numbers, and its figures with what is enlarged."""
    if page.run("return !run.reproduction"):
        return
    said = page.run("return document.getElementById('claims-table').innerText")
    for part in ("Discs cast <round> shadows.", "1.5 (corners a shadow)", "no", "yes", "All discs are round.",
                 "not decided by this quick run"):
        check(part in said, f"the page's claims have {part}")
    told = page.run("return document.getElementById('numbers-table').innerText")
    missing = page.run("return [...run.reproduction.numbers, ...run.reproduction.timing.numbers]"
                       ".map(number => number.key).filter(key => !arguments[0].includes(key))", told)
    check(missing == [], f"each number is shown: {missing}")
    tables = page.run("return [...document.querySelectorAll('#reproduced-tables tbody tr')].map(row => row.innerText)")
    check(len(tables) == page.run("return run.reproduction.tables.reduce((n, table) => n + table.rows.length, 0)"),
          f"each row of the tables is shown: {tables}")
    if tables:
        check(re.search(r"2.000 \(1.600\)\s\+150\.0.% \(\+150\.0.%\)\s\u221225\.0.%$", tables[0]),
              f"percent more than the first, the paper's beside ours: {tables[0]}")
    drawn = page.run("return document.querySelectorAll('#reproduced-charts polyline').length")
    check(drawn == page.run("return [...run.reproduction.charts, ...run.reproduction.timing.charts]"
                            ".reduce((n, chart) => n + chart.lines.length, 0)"), f"each line of the charts is drawn: {drawn}")
    for kind, count in (("figures", "2 * run.reproduction.figures.reduce((n, f) => n + f.techniques.length, 0)"),
                        ("plates", "run.reproduction.plates.reduce((n, row) => n + row.plates.length, 0)")):
        page.wait_for(f"the {kind} are drawn", PIXELS + "const all = [...document.querySelectorAll('"
                      + {"figures": ".panel", "plates": ".plate"}[kind] + f" canvas')]; return all.length === {count}"
                      " && all.every(canvas => pixels(canvas)[3] === 255)")
    same = page.run(PIXELS + "return (async () => { const at = run.reproduction.figures[0].enlarged;"
                    "const row = run.results.find(row => row.technique === run.reproduction.figures[0].techniques[0]"
                    " && row.view === run.reproduction.figures[0].view);"
                    "const whole = await picture(row, 'shaded'), data = pixels(whole);"
                    "const shown = pixels(document.querySelector('.panel .enlarged'));"
                    "return [0, 1, 2].every(c => shown[c] === data[4 * (at.top * whole.width + at.left) + c]); })()")
    check(same, "what is enlarged is that part of the picture")
    marked = page.run("return [...document.querySelectorAll('.figure')].map(figure => { const canvas ="
                      " figure.querySelector('canvas'), data = canvas.getContext('2d')"
                      ".getImageData(0, 0, canvas.width, canvas.height).data; let count = 0;"
                      " for (let i = 0; i < data.length; i += 4)"
                      "   count += data[i] === 255 && data[i + 1] === 0 && data[i + 2] === 200; return count; })")
    check(marked[0] == 0 < marked[1], f"a figure of boundaries has them marked: {marked}")
    page.click(".figure:nth-of-type(2) button")
    shown = page.run("return document.getElementById('tag-right').textContent")
    check(shown.endswith("exact · gl"), f"a figure's pictures can be compared: {shown}")


def lookups_show(page):
    """A chart for each error and cost that there is; what is best is joined by a line and named."""
    if page.run("return !run.study?.lookups"):
        return
    charts = page.run("return [...document.querySelectorAll('#curves figure')].map(f => [f.querySelector('figcaption').textContent,"
                      " f.querySelectorAll('circle').length,"
                      " [...f.querySelectorAll('.name')].map(name => name.textContent).join(' ')])")
    check(len(charts) == 8, f"four errors against bytes and against time: {charts}")
    check(charts[0][1:] == [4, "bilinear untimed"], f"every lookup has its dot, the best their names: {charts[0]}")
    check(charts[1][1:] == [3, "pcf(1) bilinear"], f"only what is timed stands against time: {charts[1]}")
    check(charts[4][1] == 3, f"only filters stand against what they filter: {charts[4]}")
    none = page.run("const dots = [...document.querySelectorAll('#curves figure:nth-child(7) circle')];"
                    "return [Math.max(...dots.map(c => c.cy.baseVal.value)),"
                    " dots.filter(c => c.textContent.includes(': 0,')).map(c => c.cy.baseVal.value)]")
    check(len(none[1]) == 2 and set(none[1]) == {none[0]}, f"no bleeding lies lowest: {none}")
    rows = page.run("return [...document.querySelectorAll('#study tbody tr')].map(row => row.innerText)")
    check(len(rows) == 4 and rows[0].endswith("filtered / bytes, misclassified / time"), f"each has its row: {rows}")


def budgets_show(page):
    """A chart for planes and one for the rest, with a dot for each point."""
    if page.run("return !run.study?.curves"):
        return
    dots, expected = page.run("return [document.querySelectorAll('#curves circle').length,"
                              " run.study.curves.reduce((sum, curve) => sum + curve.points.length, 0)]")
    check(dots == expected > 0, f"each point has its dot: {dots} of {expected}")
    none = page.run("const at = c => c.cy.baseVal.value; const dots = [...document.querySelectorAll('#curves circle')];"
                    "return dots.filter(dot => dot.textContent.endsWith(' 0 %'))"
                    ".every(dot => [...dot.parentNode.querySelectorAll('circle')].every(c => at(c) <= at(dot)))")
    check(none, "no error lies lowest")


def plots_show(page):
    """A dot for each point of every line, and titles that say what it is; choosing one value leaves fewer rows in them."""
    dots = "return [...document.querySelectorAll('.charts svg')].map(svg => svg.querySelectorAll('circle').length)"
    page.wait_for("the plots are drawn", "return document.querySelectorAll('.charts circle').length > 10")
    seen = page.run(dots)
    # All that a sweep may have; of a bench four quantities by two axes.
    check(len(seen) == 8 and min(seen) >= 3, f"every plot has its lines: {seen}")
    titles = page.run("return [...document.querySelectorAll('.charts circle title')].map(t => t.textContent)")
    check(all(re.search(r"[\d\u2013]", title) for title in titles), f"a dot says its value: {titles[:3]}")
    outside = page.run("return [...document.querySelectorAll('.charts svg')].filter(svg => { const b = svg.viewBox.baseVal;"
                       " return [...svg.querySelectorAll('circle')].some(c => !(c.cx.baseVal.value >= 0"
                       " && c.cx.baseVal.value <= b.width && c.cy.baseVal.value >= 0 && c.cy.baseVal.value <= b.height)); })"
                       ".length")
    check(outside == 0, f"no dot lies outside its plot: {outside}")


def sweep_is_chosen_from(page):
    if page.run("return !run.sweep"):
        return
    zero = page.run("return [...document.querySelectorAll('#plots circle')].some(c => c.textContent.endsWith(': 0 %'))")
    check(zero, "no error at all is drawn too")
    before = page.run("return document.querySelectorAll('#plots figure').length")
    page.run("const s = document.getElementById('choose-size'); s.selectedIndex = 1; s.dispatchEvent(new Event('change'))")
    after = page.run("return [...document.querySelectorAll('#plots figcaption')].map(c => c.textContent)")
    check(len(after) == before - 2 and not any("by pixels" in title for title in after),
          f"of one size there is no growth with pixels: {after}")
    told = page.run("return document.getElementById('plots').innerText")
    check("some technique refused" in told, f"what is left out is told: {told}")
    page.run("const s = document.getElementById('choose-size'); s.selectedIndex = 0; s.dispatchEvent(new Event('change'))")
    text = page.run("return document.getElementById('sweep-question').textContent")
    check(text == "Does <b>everything</b> grow?", f"text stays text: {text}")


def bench_has_exponents(page):
    if page.run("return !run.axes"):
        return
    cells = page.run("return [...document.querySelectorAll('#axes tbody tr:first-child')].map(row => row.innerText)")
    check(all("0.50" in cell and "1.00" in cell for cell in cells), f"exponents stand in the table: {cells}")
    check(page.run("return document.getElementById('skipped-table').innerText").count("3 years") == 2, "what is left out says why")


def command_stands_there(page):
    shown = page.run("return document.getElementById('command').textContent")
    check(shown.startswith("lixel "), f"the command is shown: {shown}")
    page.click("#copy")
    page.wait_for("the copy button answers", "return document.getElementById('copy').textContent !== 'Copy'")


def refusals_are_told(page):
    if page.run("return !run.results"):
        return
    told = page.run("return run.results.filter(r => r.refused).every(r => "
                    "document.getElementById('refused').innerText.includes(r.refused.message))")
    check(told, "each refusal is shown with its message")


def fits_every_width(page):
    for width in (1600, 1000, 700, 360):
        page.look_like(width, 800, "light")
        time.sleep(0.2)
        wide = page.run("return document.documentElement.scrollWidth")
        check(wide <= width, f"at {width} pixels nothing sticks out: {wide}")
    page.look_like(1400, 1000, "light")


def needs_nothing_from_outside(page):
    fetched = page.run("return performance.getEntriesByType('resource').map(e => e.name)"
                       ".filter(name => !name.startsWith('data:'))")
    check(fetched == [], f"nothing is fetched: {fetched}")


def console_is_quiet(page):
    told = page.call("POST", "/se/log", {"type": "browser"})
    check(told == [], f"the console is empty: {told}")


STEPS = [
    pictures_appear, differences_become_whole_pictures, slider_moves, techniques_change, error_overlay_toggles,
    maps_show_with_their_legends, zoom_works, next_view_opens, tables_sort, charts_show, flips_show, experiment_shows,
    budgets_show, lookups_show,
    command_stands_there, refusals_are_told, fits_every_width, needs_nothing_from_outside, console_is_quiet,
]
STEPS_OF_PLOTS = [  # pages of sweeps and benches, which have no pictures
    plots_show, sweep_is_chosen_from, bench_has_exponents, command_stands_there, refusals_are_told, fits_every_width,
    needs_nothing_from_outside, console_is_quiet,
]


def has_pictures(page):
    return page.run("return document.getElementById('pictures') !== null")


def take_screenshots(page, folder):
    folder.mkdir(parents=True, exist_ok=True)

    def shoot(name, whole=True):
        time.sleep(0.4)
        area = page.run("const page = document.documentElement;"
                        "return {x: 0, y: 0, width: page.scrollWidth, height: page.scrollHeight}")
        clip = {"clip": {**area, "scale": 1}, "captureBeyondViewport": True} if whole else {}
        picture = page.devtools("Page.captureScreenshot", format="png", **clip)
        (folder / f"{name}.png").write_bytes(base64.b64decode(picture["data"]))

    for name, width, theme in (("wide", 1400, "light"), ("dark", 1400, "dark"), ("phone", 390, "light")):
        page.look_like(width, 900, theme)
        page.call("POST", "/refresh", {})
        if has_pictures(page):
            pictures_appear(page)
        shoot(name)
    if not has_pictures(page):
        return
    page.look_like(1400, 1000, "light")
    page.click("#show-density")
    page.run("zoomBy(6, 0.45, 0.6); document.getElementById('pictures').scrollIntoView()")
    shoot("zoomed", whole=False)


def main():
    parser = argparse.ArgumentParser(description="Uses a report as a reader does, in headless Chromium.")
    parser.add_argument("report", type=pathlib.Path)
    parser.add_argument("--screenshots", type=pathlib.Path, metavar="FOLDER", help="pictures of the page, to look at")
    arguments = parser.parse_args()

    driver = shutil.which("chromedriver")
    chromium = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if not driver or not chromium:
        print("there is no chromium with chromedriver here: the report was not opened", file=sys.stderr)
        return 1 if os.environ.get("LIXEL_REQUIRE_BROWSER") == "1" else SKIPPED

    try:
        with Browser(driver, chromium) as page:
            page.call("POST", "/url", {"url": arguments.report.resolve().as_uri()})
            for step in STEPS if has_pictures(page) else STEPS_OF_PLOTS:
                print(step.__name__.replace("_", " "), flush=True)
                step(page)
            if arguments.screenshots:
                take_screenshots(page, arguments.screenshots)
    except (AssertionError, RuntimeError) as wrong:
        print(f"wrong: {wrong}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
