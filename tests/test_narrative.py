from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime, timedelta
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.along import UPWIND_DEG, upwind_share, weather_along
from seacruise.export.logform import entry_time, log_lines, log_to_text, say
from seacruise.geodesy import great_circle_m
from seacruise.landmarks import Landmark
from seacruise.narrative import Entry, settled, tell
from seacruise.passage import Passage, Place, Track, Waypoint
from seacruise.phrases import TEMPLATES, Amount, Phrase
from seacruise.ports import Port
from seacruise.units import METRES_PER_NM, beaufort
from tests.passages import hand_made_passage, veering_wind

KINDS = (
    "waiting", "departure", "passing", "rounding", "tack", "gybe", "beat", "run", "point-of-sail", "wind-up",
    "wind-down", "strongest-wind", "waves", "current", "sunrise", "sunset", "engine-on", "engine-off",
    "forecast-ends", "arrival",
)  # fmt: skip


def of_kind(entries: tuple[Entry, ...], *kinds: str) -> list[Entry]:
    return [entry for entry in entries if entry.kind in kinds]


def phrases_in(phrase: Phrase) -> list[Phrase]:
    inner = [part for _, part in phrase.parts if isinstance(part, Phrase)]
    return [phrase, *(found for part in inner for found in phrases_in(part))]


def drawn(courses: list[tuple[float, float]], *, twd: float, tws: float = 15.0) -> Passage:
    """Give a passage of courses [degrees] and hours in one steady wind, at six knots from 57 N 19 E."""
    template = hand_made_passage()
    points: list[Waypoint] = []
    columns: list[list[float]] = []
    time, lat, lon = template.departure, 57.0, 19.0
    for number, (course, hours) in enumerate(courses):
        signed = (twd - course + 180.0) % 360.0 - 180.0
        points.append(
            Waypoint(
                lat, lon, time, course_deg=course, leg_nm=6.0 * hours, boat_speed_kn=6.0, tws_kn=tws,
                twd_deg=twd, twa_deg=abs(signed), motor=False, tack="starboard" if signed >= 0.0 else "port",
            )
        )  # fmt: skip
        for _ in range(round(hours * 10)):
            columns.append(
                [time.timestamp(), lat, lon, course, 6.0, tws, twd, abs(signed), 0.0, float(number)]
            )
            time += timedelta(minutes=6)
            lat += 0.6 / 60.0 * np.cos(np.radians(course))
            lon += 0.6 / 60.0 * np.sin(np.radians(course)) / np.cos(np.radians(lat))
    columns.append([time.timestamp(), lat, lon, *columns[-1][3:]])
    points.append(Waypoint(lat, lon, time))
    t, la, lo, co, sp, ws, wd, wa, mo, le = np.array(columns).T
    return replace(
        template,
        waypoints=tuple(points),
        track=Track(t, la, lo, co, sp, ws, wd, wa, mo.astype(bool), le.astype(np.int64)),
        start=Place("Alpha", 57.0, 19.0, 57.0, 19.0, 0.0),
        end=Place("Omega", float(lat), float(lon), float(lat), float(lon), 0.0),
        departure=template.departure,
        arrival=time,
        beyond_forecast_h=0.0,
    )


def plainly(passage: Passage, *landmarks: Landmark, ports: tuple[Port, ...] = ()) -> tuple[Entry, ...]:
    return tell(passage, ports=ports, landmarks=landmarks)


# --- the whole ------------------------------------------------------------------------------------------


def test_a_log_begins_with_leaving_and_ends_with_arriving(passage: Passage) -> None:
    entries = tell(passage)
    assert entries[0].kind == "departure"
    assert entries[-1].kind == "arrival"
    assert say(entries[0].phrase).startswith("Leaves Gdynia; ")
    assert say(entries[-1].phrase).startswith("Arrives in Sandhamn after ")
    assert all(a.time <= b.time for a, b in pairwise(entries))
    assert {entry.kind for entry in entries} <= set(KINDS)


def test_every_entry_lies_on_the_track_at_its_time(passage: Passage) -> None:
    track = passage.track
    for entry in tell(passage):
        lat = np.interp(entry.time.timestamp(), track.time, track.lat)
        lon = np.interp(entry.time.timestamp(), track.time, track.lon)
        assert float(great_circle_m(entry.lat, entry.lon, lat, lon)) < METRES_PER_NM


def test_every_sentence_is_one_of_the_templates_and_has_no_gap_left(passage: Passage) -> None:
    gusty = replace(veering_wind(), gust=np.full(veering_wind().u.shape, 20.0, dtype=np.float32))
    for entry in tell(passage, wind=gusty, wanted=passage.departure - timedelta(hours=5)):
        assert {phrase.text for phrase in phrases_in(entry.phrase)} <= set(TEMPLATES)
        assert "{" not in say(entry.phrase)


def test_a_line_reads_as_a_log_does() -> None:
    mark = Landmark("Hoburgen", "SE", "cape", 1, 57.2, 18.9)
    line = next(
        line for line in log_lines(plainly(drawn([(0.0, 8.0)], twd=130.0), mark)) if "Hoburgen" in line
    )
    assert line == "Sun 08:00  Off Hoburgen, 3.3 nm to port; 15 kn on the starboard quarter."


def test_the_text_has_a_line_for_each_entry(passage: Passage) -> None:
    entries = tell(passage)
    text = log_to_text(entries)
    assert text.splitlines()[0] == "Log (UTC)"
    assert len(text.splitlines()) == len(entries) + 1
    assert entry_time(entries[0]) == "Sun 06:00"


def test_another_language_and_other_units_fill_the_same_gaps() -> None:
    phrase = Phrase("Off {place}, {distance} to port; {how}.", (
        ("place", "Hel"),
        ("distance", Amount("distance", 2.0)),
        ("how", Phrase("{wind} from ahead", (("wind", Amount("wind", 10.0)),))),
    ))  # fmt: skip
    words = {phrase.text: "{how}: {place} ({distance})", "{wind} from ahead": "pod wiatr, {wind}"}

    def show(value: Amount | datetime) -> str:
        return f"{value.value * 2:g} x" if isinstance(value, Amount) else ""

    assert say(phrase, translate=lambda p: words[p.text], show=show) == "pod wiatr, 20 x: Hel (4 x)"
    speed = Phrase("Waves {height}.", (("height", Amount("height", 2.0)),))
    assert say(speed, show=lambda _: "2 ft.") == "Waves 2 ft."


# --- wind -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("twd", "said"),
    [
        (315.0, "close-hauled on port tack"),
        (45.0, "close-hauled on starboard tack"),
        (70.0, "forward of the starboard beam"),
        (270.0, "on the port beam"),
        (130.0, "on the starboard quarter"),
        (200.0, "on the port quarter"),
        (178.0, "from dead astern"),
    ],
)
def test_the_wind_is_named_by_where_it_comes_from(twd: float, said: str) -> None:
    assert said in say(plainly(drawn([(0.0, 2.0)], twd=twd))[0].phrase)


def test_under_engine_and_in_a_calm_other_words_are_used() -> None:
    passage = drawn([(0.0, 2.0)], twd=10.0)
    motor = replace(passage, track=replace(passage.track, motor=np.ones(21, dtype=bool)))
    assert say(plainly(motor)[0].phrase) == "Leaves Alpha under engine; 15 kn from ahead."
    assert say(plainly(drawn([(0.0, 2.0)], twd=10.0, tws=0.5))[0].phrase) == "Leaves Alpha; calm."


def test_a_change_of_force_is_told_once_it_lasts() -> None:
    passage = drawn([(0.0, 6.0)], twd=90.0, tws=9.0)
    tws = passage.track.tws_kn.copy()
    tws[10:14] = 13.0  # 24 minutes of force 4
    tws[30:] = 18.0
    stronger = replace(passage, track=replace(passage.track, tws_kn=tws))
    told = [say(e.phrase) for e in plainly(stronger) if e.kind in {"wind-up", "wind-down", "strongest-wind"}]
    assert told == ["Strongest wind of the passage; 18 kn on the starboard beam."]
    tws[40:] = 23.0
    told = [say(e.phrase) for e in plainly(replace(passage, track=replace(passage.track, tws_kn=tws)))]
    assert "The wind rises to force 5; 18 kn on the starboard beam." in told


def test_strongest_wind_gusts_waves_and_current_are_where_they_are(passage: Passage) -> None:
    wind = veering_wind()
    wind = replace(
        wind, gust=np.hypot(wind.u, wind.v) * np.float32(1.4), wave=np.full(wind.u.shape, 2.5, np.float32)
    )
    entries = tell(passage, wind=wind)
    (strongest,) = of_kind(entries, "strongest-wind")
    at = int(np.argmax(passage.track.tws_kn))
    assert strongest.time.timestamp() == pytest.approx(float(passage.track.time[at]))
    gusts = dict(strongest.phrase.parts)["gusts"]
    assert isinstance(gusts, Amount)
    # Gusts are interpolated as a number, wind by its components.
    assert gusts.value == pytest.approx(1.4 * passage.max_tws_kn, rel=0.02)
    assert [say(e.phrase) for e in of_kind(entries, "waves")] == ["Highest waves of the passage, 2.5 m."]
    flowing = tuple(
        replace(w, current_kn=0.1 * k, current_to_deg=45.0) for k, w in enumerate(passage.waypoints)
    )
    (current,) = of_kind(tell(replace(passage, waypoints=flowing)), "current")
    assert say(current.phrase) == "Strongest current of the passage, 0.7 kn setting 045°."
    assert not of_kind(tell(passage), "waves", "current")


# --- tacks and gybes ------------------------------------------------------------------------------------


def test_one_tack_is_told_with_its_course() -> None:
    entries = plainly(drawn([(45.0, 3.0), (315.0, 3.0)], twd=0.0))
    assert [say(e.phrase) for e in of_kind(entries, "tack")] == [
        "Tacks to 315°; 15 kn, close-hauled on starboard tack."
    ]
    assert not of_kind(entries, "beat", "point-of-sail")


def test_a_beat_of_many_boards_is_one_entry() -> None:
    entries = plainly(drawn([(45.0, 1.0), (315.0, 1.0)] * 4, twd=0.0))
    (beat,) = of_kind(entries, "beat")
    assert say(beat.phrase) == "Begins to beat; 7 tacks until 13:00, 15 kn."
    assert not of_kind(entries, "tack", "point-of-sail")
    turns = dict(beat.phrase.parts)["turns"]
    assert isinstance(turns, Phrase)
    assert turns.count == 7


def test_long_boards_are_told_one_by_one() -> None:
    assert len(of_kind(plainly(drawn([(45.0, 4.0), (315.0, 4.0)] * 3, twd=0.0)), "tack")) == 5


def test_gybes_before_the_wind_are_a_run() -> None:
    entries = plainly(drawn([(150.0, 1.0), (210.0, 1.0)] * 2, twd=0.0))
    assert [say(e.phrase) for e in of_kind(entries, "run")] == [
        "Begins to run before the wind; 3 gybes until 09:00, 15 kn."
    ]
    (gybe,) = of_kind(plainly(drawn([(150.0, 2.0), (210.0, 2.0)], twd=0.0)), "gybe")
    assert say(gybe.phrase) == "Gybes to 210°; 15 kn on the starboard quarter."


@given(st.lists(st.sampled_from([45.0, 90.0, 150.0, 210.0, 270.0, 315.0]), min_size=1, max_size=12))
def test_all_tacks_and_gybes_are_told_however_they_follow_each_other(courses: list[float]) -> None:
    from seacruise.routing.manoeuvres import count_turns

    sides = np.array(courses)
    tacks, gybes = count_turns(sides, np.zeros(sides.size), np.ones(sides.size, dtype=bool))
    told = {"tack": 0, "gybe": 0}
    for entry in plainly(drawn([(course, 1.0) for course in courses], twd=0.0)):
        if entry.kind in {"tack", "gybe"}:
            told[entry.kind] += 1
        elif entry.kind in {"beat", "run"}:
            turns = dict(entry.phrase.parts)["turns"]
            assert isinstance(turns, Phrase)
            told["tack" if entry.kind == "beat" else "gybe"] += turns.count or 0
    assert told == {"tack": tacks, "gybe": gybes}


# --- point of sail, engine, forecast, sun, waiting ------------------------------------------------------


def test_a_change_of_course_and_a_shift_of_wind_are_told_apart() -> None:
    passage = drawn([(0.0, 3.0), (340.0, 3.0)], twd=70.0)
    assert [say(e.phrase) for e in of_kind(plainly(passage), "point-of-sail")] == [
        "Bears away to 340°; 15 kn on the starboard beam."
    ]
    steady = drawn([(0.0, 6.0)], twd=70.0)
    twd = np.where(np.arange(steady.track.time.size) < 30, 70.0, 45.0)
    shifted = replace(steady, track=replace(steady.track, twd_deg=twd, twa_deg=twd))
    assert [say(e.phrase) for e in of_kind(plainly(shifted), "point-of-sail")] == [
        "The wind backs; 15 kn, close-hauled on starboard tack."
    ]


def test_the_engine_is_told_when_it_starts_and_stops() -> None:
    passage = drawn([(0.0, 6.0)], twd=90.0)
    motor = np.zeros(passage.track.time.size, dtype=bool)
    motor[20:40] = True
    entries = plainly(replace(passage, track=replace(passage.track, motor=motor)))
    assert [(e.kind, f"{e.time:%H:%M}") for e in of_kind(entries, "engine-on", "engine-off")] == [
        ("engine-on", "08:00"),
        ("engine-off", "10:00"),
    ]


@pytest.mark.parametrize(("beyond", "word"), [("hold", "is held"), ("fade", "fades")])
def test_the_end_of_the_forecast_is_told(passage: Passage, beyond: str, word: str) -> None:
    end = passage.departure + timedelta(hours=10)
    late = replace(
        passage,
        forecast=replace(passage.forecast, valid_to=end),
        beyond_forecast_h=passage.duration_h - 10.0,
        beyond=beyond,  # type: ignore[arg-type]
    )
    (entry,) = of_kind(tell(late), "forecast-ends")
    assert word in say(entry.phrase)
    assert abs(entry.time - end) <= timedelta(minutes=6)


def test_the_sun_rises_and_sets_by_turns(passage: Passage) -> None:
    kinds = [entry.kind for entry in of_kind(tell(passage), "sunrise", "sunset")]
    assert kinds[:3] == ["sunrise", "sunset", "sunrise"]


def test_waiting_is_told_from_the_departure_that_was_asked_for(passage: Passage) -> None:
    entries = tell(passage, wanted=passage.departure - timedelta(hours=5))
    assert entries[0].kind == "waiting"
    assert say(entries[0].phrase) == "Waits 5 h 00 min in Gdynia, until what is not allowed has passed."
    assert not of_kind(tell(passage, wanted=passage.departure), "waiting")


# --- places ---------------------------------------------------------------------------------------------


def test_a_cape_that_she_turns_around_is_rounded() -> None:
    passage = drawn([(0.0, 3.0), (90.0, 3.0)], twd=200.0)
    cape = Landmark("Cape", "SE", "cape", 1, 57.27, 19.03)
    (entry,) = of_kind(plainly(passage, cape), "rounding", "passing")
    assert entry.kind == "rounding"
    assert "to starboard" in say(entry.phrase)
    outside = Landmark("Cape", "SE", "cape", 1, 57.33, 18.97)
    assert [e.kind for e in of_kind(plainly(passage, outside), "rounding", "passing")] == ["passing"]


def test_places_at_the_ends_and_out_of_reach_are_not_told() -> None:
    passage = drawn([(0.0, 8.0)], twd=200.0)
    for lat, lon in ((57.02, 19.0), (57.79, 19.02), (57.4, 19.6), (56.9, 19.0)):
        assert not of_kind(
            plainly(passage, Landmark("Far", "SE", "cape", 1, lat, lon)), "passing", "rounding"
        )
    port = Port("Haven", "SE", 57.4, 19.05)
    assert len(of_kind(plainly(passage, ports=(port,)), "passing")) == 1
    assert not of_kind(plainly(passage, ports=(replace_port(port, 19.1),)), "passing")


def replace_port(port: Port, lon: float) -> Port:
    return Port(port.name, port.country, port.lat, lon)


def test_a_place_on_the_way_has_no_side() -> None:
    port = Port("Haven", "SE", 57.4, 19.001)
    (entry,) = of_kind(plainly(drawn([(0.0, 8.0)], twd=130.0), ports=(port,)), "passing")
    assert say(entry.phrase) == "Passes close to Haven; 15 kn on the starboard quarter."


def test_of_places_close_together_the_nearest_is_told() -> None:
    passage = drawn([(0.0, 8.0)], twd=200.0)
    near = Landmark("Near", "SE", "light", 1, 57.4, 19.05)
    far = Landmark("Far", "SE", "cape", 1, 57.42, 18.85)
    told = of_kind(plainly(passage, near, far), "passing")
    assert [dict(e.phrase.parts)["place"] for e in told] == ["Near"]


# --- what it is made of ---------------------------------------------------------------------------------


@given(st.lists(st.integers(0, 3), min_size=1, max_size=40), st.integers(1, 6))
def test_what_does_not_last_is_no_news(levels: list[int], holds: int) -> None:
    array = np.array(levels)
    time = np.arange(array.size, dtype=np.float64)
    changes = settled(array, time, float(holds))
    for at, before in changes:
        assert before < at
        assert array[at] != array[before]
        last = min(at + holds, array.size - 1)
        assert (array[at:last] == array[at]).all()
    for (a, _), (b, before) in pairwise(changes):
        assert array[before] == array[a]
        assert b - a >= holds


@pytest.mark.parametrize(
    ("speed", "force"), [(0.4, 0), (1.0, 1), (10.4, 3), (10.6, 4), (27.4, 6), (33.6, 8), (70.0, 12)]
)
def test_forces_begin_at_whole_knots(speed: float, force: int) -> None:
    assert beaufort(speed) == force


def test_weather_along_is_silent_about_what_a_wind_has_not(passage: Passage) -> None:
    for wind in (None, veering_wind()):
        weather = weather_along(passage.track, wind)
        assert weather.gust_kn is None
        assert weather.wave_m is None
        assert weather.current_kn is None


def test_the_part_against_the_wind_is_counted_in_time() -> None:
    half = drawn([(45.0, 2.0), (90.0, 2.0)], twd=0.0)
    assert upwind_share(half.track) == pytest.approx(0.5, abs=0.03)
    assert UPWIND_DEG == 60.0
    assert half.track.time[0] == datetime(2016, 11, 20, 6, tzinfo=UTC).timestamp()
