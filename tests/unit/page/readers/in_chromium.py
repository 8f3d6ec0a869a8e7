"""Shows a page in Chromium: compares three frames with our own pictures, and tries keys, mouse and touch."""
import glob
import json
import sys

import pictures
from browser import Browser

folder = sys.argv[1]
url = f"file://{folder}/view.html"
facts = json.load(open(f"{folder}/pictures.json"))
oracle = json.load(open(f"{folder}/oracle.json"))
counts = {frame["number"]: [(frame.get("states") or []).count(state) for state in range(3)] +
          [sum(frame["polygons"])] for frame in oracle["frames"]}


def expect(holds, what):
    if not holds:
        raise AssertionError(what)


def look_alike():
    """Pixels differ where a rounded place moves an outline, and by other roundings of sines and roots."""
    width, height = map(int, facts["size"].split("x"))
    for look in facts["looks"]:
        ours = sorted(glob.glob(f"{folder}/{look}/frames/*.png"))
        expect(len(ours) == len(facts["frames"]) == 3, ours)
        with Browser(url, width, height) as page:
            for frame, file in zip(facts["frames"], ours):
                page.go_to(f"frame={frame}&canvas&look={look}&{facts['camera']}")
                rms, share, most = pictures.difference(page.screenshot(), open(file, "rb").read())
                print(f"frame {frame}, {look}: rms {rms:.2f} of 255, {100 * share:.2f} % of the pixels by more "
                      f"than 8, at most {most}")
                expect(rms < 2.5 and share < 0.005, f"frame {frame} differs from our {look} picture")
            others = pictures.difference(page.screenshot(), open(ours[0], "rb").read())
            expect(others[0] > 5, "the comparison would not notice another frame")
            quiet(page)


def quiet(page):
    said = [line for line in page.said if not line.startswith("asks for file://")]
    expect(not said, said)


def number(page, name):
    return float(page.value(f"document.getElementById('picture').dataset.{name}"))


def shown_counts(page):
    return [int(page.value(f"document.getElementById('{name}').textContent").replace(",", ""))
            for name in ["running", "frozen", "discarded", "polygons"]]


def answer_keys(page):
    numbers = [frame["number"] for frame in oracle["frames"]]
    page.value("document.getElementById('time').focus(); 1")
    page.key("Home")
    expect(number(page, "frame") == numbers[0], "Home is the first frame")
    for _ in range(5):
        page.key("ArrowRight")
    expect(number(page, "frame") == numbers[5], "an arrow is a frame")
    expect(shown_counts(page) == counts[numbers[5]], f"{shown_counts(page)} in frame {numbers[5]}")
    page.key("End")
    expect(number(page, "frame") == numbers[-1], "End is the last frame")
    expect(shown_counts(page) == counts[numbers[-1]], f"{shown_counts(page)} at the end")
    page.key("Home")
    page.value("document.activeElement.blur(); 1")
    page.key(" ", "Space", " ")
    expect(page.value("document.getElementById('play').ariaLabel") == "Pause", "space plays")
    page.until(f"Number(document.getElementById('picture').dataset.frame) > {numbers[2]}")
    page.key(" ", "Space", " ")
    still = number(page, "frame")
    page.settle()
    expect(number(page, "frame") == still, "space stops")


def turn(page):
    canvas = page.value("(({x, y, width, height}) => [x + width / 2, y + height / 2])"
                        "(document.getElementById('picture').getBoundingClientRect())")
    before = [number(page, name) for name in ["azimuth", "elevation", "distance"]]
    page.drag(*canvas, -100, 50)
    page.mouse("mouseWheel", *canvas, deltaX=0, deltaY=-300)
    page.settle()
    after = [number(page, name) for name in ["azimuth", "elevation", "distance"]]
    expect(abs(after[0] - before[0] - 40) < 1e-6 and abs(after[1] - before[1] - 20) < 1e-6, (before, after))
    expect(after[2] < 0.8 * before[2], (before, after))
    page.value("document.getElementById('picture').focus(); 1")
    page.key("ArrowLeft")
    expect(abs(number(page, "azimuth") - after[0] + 5) < 1e-6, "an arrow key turns")
    page.key("+", "Equal", "+")
    expect(number(page, "distance") < after[2], "plus comes closer")
    page.key("0", "Digit0", "0")
    expect([number(page, name) for name in ["azimuth", "elevation", "distance"]] == before, "0 goes back")


def choose(page):
    page.value("document.getElementById('time').focus(); 1")
    page.key("End")
    seen = {page.screenshot()}
    for control, value in [("colour-by", "set"), ("colour-by", "height"), ("cut", "front"), ("look", "1")]:
        page.value(f"(control => {{ control.value = '{value}'; control.dispatchEvent(new Event('change')); }})"
                   f"(document.getElementById('{control}')); 1")
        page.settle()
        shot = page.screenshot()
        expect(shot not in seen, f"{control} {value} changes nothing")
        seen.add(shot)
    expect(page.value("document.querySelectorAll('#errors dd').length") > 0, "no errors are told")


def answer_touch():
    with Browser(url, 390, 844, 2, touch=True) as page:
        wide = page.value("document.documentElement.scrollWidth")
        expect(wide <= 390, f"the page is {wide} wide")
        before = number(page, "distance")
        for kind, apart in [("touchStart", 40), ("touchMove", 60), ("touchMove", 80), ("touchEnd", None)]:
            touches = [] if apart is None else [{"x": 195 - apart, "y": 200, "id": 1},
                                                {"x": 195 + apart, "y": 200, "id": 2}]
            page.call("Input.dispatchTouchEvent", type=kind, touchPoints=touches)
        page.settle()
        expect(abs(number(page, "distance") / before - 0.5) < 0.01, "a pinch comes closer")
        quiet(page)


def say_what_is_missing():
    with Browser(url, before="delete window.DecompressionStream",
                 ready="document.getElementById('notice')?.textContent.includes('DecompressionStream')") as page:
        expect(page.value("document.getElementById('name').textContent") == "torus", "the rest is shown")
    with Browser(url, before="HTMLCanvasElement.prototype.getContext = () => null",
                 ready="document.getElementById('notice')?.textContent.includes('WebGL 2')"):
        pass


def survive_a_lost_context():
    with Browser(url) as page:
        page.go_to("look=Clean")
        before = page.screenshot()
        page.value("window.lose = frostfill.picture.gl.getExtension('WEBGL_lose_context'); lose.loseContext(); 1")
        page.until("!document.getElementById('notice').hidden")
        expect("graphics" in page.value("document.getElementById('notice').textContent"), "the loss is told")
        page.value("frostfill.redraw(); 1")
        expect(pictures.difference(page.screenshot(), before)[1] > 0.01, "a lost context still shows the picture")
        page.value("lose.restoreContext(); 1")
        page.until("document.getElementById('notice').hidden")
        rms, share, most = pictures.difference(page.screenshot(), before)
        # Another context may round an edge otherwise: one pixel of a million differed, in half of the runs.
        expect(share < 1e-5, f"the picture does not come back: rms {rms:.2f}, at most {most}")
        expect(not any("exceptionId" in line for line in page.said), page.said)


look_alike()
with Browser(url) as page:
    answer_keys(page)
    turn(page)
    choose(page)
    quiet(page)
answer_touch()
survive_a_lost_context()
say_what_is_missing()
