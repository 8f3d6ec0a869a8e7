"""Lets the page decode its frames in any order, and compares every number with oracle.json."""
import json
import random
import sys

from browser import Browser

folder = sys.argv[1]
oracle = json.load(open(f"{folder}/oracle.json"))
ASKED = """(film => { film.seek(%d); const n = film.spheres; return {
    places: Array.from(film.places.subarray(0, 3 * n)), radii: Array.from(film.values.radius.subarray(0, n)),
    states: Array.from(film.states.subarray(0, n)), groups: Array.from(film.values.group.subarray(0, n)),
    speeds: Array.from(film.values.speed.subarray(0, n)),
    contacts: Array.from(film.values.contacts.subarray(0, n)), polygons: Array.from(film.polygons),
    time: film.times[%d] }; })(frostfill.film)"""

order = list(range(len(oracle["frames"])))
random.Random(1).shuffle(order)
with Browser(f"file://{folder}/view.html") as page:
    facts = page.value("JSON.parse(document.getElementById('facts').textContent)")
    film = facts["film"]
    for index in order:
        frame, shown = oracle["frames"][index], page.value(ASKED % (index, index))
        waiting = frame.get("waiting") or []
        states = [3 if waits else state for waits, state in zip(waiting, frame.get("states") or [])]
        assert shown["states"] == states, index
        assert shown["groups"] == (frame.get("groups") or []), index
        assert shown["contacts"] == (frame.get("contacts") or []), index
        assert shown["polygons"] == frame["polygons"] and shown["time"] == frame["time"], index
        for i, centre in enumerate(frame.get("centres") or []):
            for axis in range(3):
                place = facts["origin"][axis] + film["step"] * shown["places"][3 * i + axis]
                assert abs(place - centre[axis]) <= film["step"] / 2 * (1 + 1e-9), (index, i)
            assert abs(shown["radii"][i] * film["radius_step"] - frame["radii"][i]) <= film["radius_step"] / 2
            speed = 0 if waiting[i] else min(frame["speeds"][i], film["fastest"])
            assert abs(shown["speeds"][i] / 255 * film["fastest"] - speed) <= film["fastest"] / 509, (index, i)
    said = [line for line in page.said if not line.startswith("asks for file://")]
    assert not said, said
print(f"{len(order)} frames in any order")
