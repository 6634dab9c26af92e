"""Pictures of polars: the lines are the polar's own figures, and every kind can be drawn of every yacht."""

from __future__ import annotations

import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings

from seacruise.errors import InputError
from seacruise.export import polar_areas, polar_hulls, polar_lines
from seacruise.export.polar_pictures import (
    COMPARING,
    KINDS,
    polar_picture,
    winds_for,
    write_polar_picture,
)
from seacruise.export.polar_sheet import DARK, FORMS, LIGHT
from seacruise.export.polar_slices import LogPoints, slice_of, target_at, usual_winds
from seacruise.units import MS_PER_KNOT as KN
from seacruise.yacht.polar import Polar
from seacruise.yacht.sails import SailSet
from seacruise.yacht.tacks import TwoSided
from seacruise.yacht.targets import targets
from tests.yacht.polars import NAN, polar_kn, polars, small

BEGINNINGS = {"png": b"\x89PNG\r\n\x1a\n", "pdf": b"%PDF", "svg": b"<?xml"}


def two_sails() -> Polar:
    genoa = polar_kn((6, 10), (45, 90, 120), ((4, 5.5), (5, 6.6), (4.2, 6)), "Genoa")
    gennaker = polar_kn((6, 10), (90, 120, 160), ((5.5, 7), (5.2, 7.2), (3.4, 5.3)), "Gennaker")
    return SailSet("Two sails", (genoa, gennaker)).to_table()


def bent() -> TwoSided:
    starboard = small()
    port = Polar("port", starboard.tws, starboard.twa, 0.9 * starboard.speed_table)
    return TwoSided("Bent mast", port, starboard)


def some_points(n: int = 400, *, both: bool = True) -> LogPoints:
    rng = np.random.default_rng(7)
    tws, twa = rng.uniform(5.0, 17.0, n), rng.uniform(40.0, 170.0, n)
    speed = small().speed(tws * KN, twa) / KN
    return LogPoints(tws, twa * rng.choice((-1.0, 1.0), n) if both else twa, speed, "july.nmea")


def words_of(figure: Any) -> str:
    texts = [text.get_text() for text in figure.texts]
    texts += [t.get_text() for legend in figure.legends for t in (legend.get_title(), *legend.get_texts())]
    for axes in figure.axes:
        texts += [axes.get_title(), axes.get_xlabel(), axes.get_ylabel()]
        texts += [label.get_text() for label in (*axes.get_xticklabels(), *axes.get_yticklabels())]
    return "\n".join(texts).replace("\u200b", "")


# --- slices --------------------------------------------------------------------------------------------


@settings(max_examples=30)
@given(polars())
def test_no_hull_is_within_its_slice_and_no_target_beats_it(polar: Polar) -> None:
    kn = float(polar.tws[-1]) / KN
    cut = slice_of(polar, kn)
    assert (cut.hull_kn >= cut.speed_kn - 1e-9).all()
    made = cut.speed_kn * np.abs(np.cos(np.radians(cut.twa)))
    windward = cut.twa <= 90.0
    assert cut.beat.vmg_kn >= made[windward].max() * (1 - 1e-4) - 1e-9
    assert cut.run.vmg_kn >= made[~windward].max() * (1 - 2e-4) - 1e-9
    for chord in cut.chords:
        assert 0.0 <= chord.course_from <= chord.course_to <= 180.0


def test_the_chords_of_a_slice_are_beat_and_run() -> None:
    cut = slice_of(small(), 10.0)
    beat, run = cut.chords[0], cut.chords[-1]
    assert (beat.course_from, beat.course_to) == (0.0, abs(beat.twa1))
    assert abs(beat.twa1) == pytest.approx(cut.beat.twa, abs=0.3)
    assert beat.twa2 == -beat.twa1
    assert run.course_to == 180.0
    assert abs(run.twa1) == pytest.approx(cut.run.twa, abs=0.3)
    assert cut.ranges == ()


def test_a_mixture_of_two_sails_is_a_chord() -> None:
    cut = slice_of(two_sails(), 10.0)
    assert [part.sail for part in cut.ranges] == ["Genoa", "Gennaker"]
    mixed = next(chord for chord in cut.chords if chord.twa1 != -chord.twa2)
    assert (mixed.sail1, mixed.sail2) == ("Genoa", "Gennaker")
    assert [curve.name for curve in cut.sails] == ["Genoa", "Gennaker"]
    assert np.isnan(cut.sails[1].speed_kn[cut.twa < 89.0]).all()
    assert slice_of(two_sails(), 10.0, with_sails=False).sails == ()


def test_a_run_is_told_at_the_last_figure_where_vmg_is_level_beyond_it() -> None:
    polar = polar_kn((8, 16), (45, 90, 150), ((4, 5), (6, 7), (5.0, 6.5)))
    wind = np.array([8.0, 11.0, 16.0]) * KN
    assert polar.best_vmg(wind, False)[0] == pytest.approx([150.0] * 3, abs=0.5)


def test_a_target_is_that_of_the_yacht_room() -> None:
    expected = targets(small(), (10.0,))[0].beat
    found = target_at(small(), 10.0, expected.twa)
    for name in ("boat_speed_kn", "vmg_kn", "awa", "aws_kn"):
        assert getattr(found, name) == pytest.approx(getattr(expected, name))


def test_points_of_a_log() -> None:
    points = LogPoints(np.array([9.2, 10.9, 12.0]), np.array([45.0, -60.0, 90.0]), np.array([5.0, 6.0, 7.0]))
    assert len(points.near(10.0)) == 2
    assert points.both_tacks
    assert not points.rows(points.twa > 0.0).both_tacks
    with pytest.raises(InputError, match="one wind speed, one angle"):
        LogPoints(np.zeros(3), np.zeros(2), np.zeros(3))
    with pytest.raises(InputError, match="no finite number"):
        LogPoints(np.array([np.nan]), np.zeros(1), np.zeros(1))


def test_usual_winds_are_the_tables_own() -> None:
    assert usual_winds([small()]) == (6.0, 10.0, 16.0)
    many = polar_kn(range(0, 61, 2), (45, 90, 150), np.full((3, 31), 5.0))
    assert usual_winds([many])[-1] == 60.0
    assert len(usual_winds([many])) == 7
    assert usual_winds([polar_kn((1.0,), (45, 90), ((3,), (4,)))]) == (2.0,)


# --- pictures ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("form", FORMS)
def test_every_kind_in_every_form(kind: str, form: str) -> None:
    picture = polar_picture([small()], kind, form=form, points=some_points(60))
    assert picture.startswith(BEGINNINGS[form])
    if form == "svg":
        assert ET.fromstring(picture).tag.endswith("svg")


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(
    "yacht",
    [
        bent(),
        two_sails(),
        polar_kn((8,), (45, 90), ((4,), (6,)), "one wind, no run"),
        polar_kn((0, 8), (0, 90, 180), ((0, 0), (0, 6), (0, 4)), "a column of calm"),
        polar_kn((8, 12), (100, 150), ((5, 6), (4, 5)), "no beat"),
        polar_kn((6, 12), (45, 90), ((NAN, 0.0), (0.0, 0.0)), "never moves"),
        polar_kn((6, 12), (45, 90), ((4, 5), (6, 7)), "_$\\frac{1}{ $ & <name> " + "long " * 60),
    ],
    ids=lambda yacht: yacht.name[:12],
)
def test_every_kind_of_odd_yachts(kind: str, yacht: Polar | TwoSided) -> None:
    assert polar_picture([yacht], kind, dark=True).startswith(BEGINNINGS["png"])


def test_the_lines_of_a_slice_are_the_polars_speeds() -> None:
    polar = small()
    figure = polar_lines.over_the_angle([polar], (6.0, 10.0), points=None, theme=LIGHT)
    curves = [line for line in figure.axes[0].lines if len(np.asarray(line.get_xdata())) > 100]
    assert len(curves) == 4  # of each wind all of it, and what the table has figures for
    for line, kn in ((curves[0], 6.0), (curves[2], 10.0)):
        speed = polar.speed(kn * KN, np.asarray(line.get_xdata())) / KN
        assert np.asarray(line.get_ydata()) == pytest.approx(speed)
    known = np.isfinite(np.asarray(curves[3].get_ydata(), dtype=float))
    assert np.asarray(curves[3].get_xdata())[known][[0, -1]] == pytest.approx([42.0, 165.0])


def test_a_yacht_that_differs_shows_both_tacks() -> None:
    yacht = bent()
    figure = polar_lines.round_the_wind([yacht], (10.0,), points=None, theme=DARK)
    axes: Any = figure.axes[0]
    assert np.degrees(axes.get_xlim()) == pytest.approx([-180.0, 180.0])
    curves = [line for line in axes.lines if len(np.asarray(line.get_xdata())) > 100]
    for line in curves[::2]:
        angle = np.degrees(np.asarray(line.get_xdata()))
        inner = (np.abs(angle) > 0.0) & (np.abs(angle) < 180.0)
        expected = yacht.speed_on(10.0 * KN, angle[inner]) / KN
        assert np.asarray(line.get_ydata())[inner] == pytest.approx(expected)
    alike: Any = polar_lines.round_the_wind([small()], (10.0,), points=None, theme=DARK).axes[0]
    assert np.degrees(alike.get_xlim()) == pytest.approx([0.0, 180.0])


@pytest.mark.parametrize("kind", COMPARING)
def test_compared_yachts_differ_in_their_dashes(kind: str) -> None:
    draw = {"polar": polar_lines.round_the_wind, "flat": polar_lines.over_the_angle}[kind]
    other = Polar("Other", small().tws, small().twa, 0.8 * small().speed_table, source="log of 2025")
    figure = draw([small(), other], (10.0,), points=None, theme=LIGHT)
    curves = [line for line in figure.axes[0].lines if len(np.asarray(line.get_xdata())) > 100]
    assert len({str(line.get_linestyle()) for line in curves}) == 2
    assert len({str(line.get_color()) for line in curves}) == 1
    words = words_of(figure)
    for word in ("Test and Other", "Other: log of 2025", "10 kn", "best VMG", "True wind speed"):
        assert word in words


def test_words_of_the_hull_tell_headings_and_sails() -> None:
    figure = polar_hulls.hulls(two_sails(), (10.0,), points=some_points(), theme=LIGHT)
    words = words_of(figure)
    for word in ("Genoa", "Gennaker", "change of sail", "10 kn of wind", "Courses on two headings", "port"):
        assert word in words
    assert "log points" in words


def test_points_of_both_tacks_open_the_circle_and_are_counted() -> None:
    points = some_points()
    figure = polar_lines.round_the_wind([small()], (6.0, 10.0), points=points, theme=LIGHT)
    near = len(points.near(6.0)) + len(points.near(10.0))
    assert f"{near} of 400" in words_of(figure)
    drawn = sum(
        len(np.asarray(line.get_xdata())) for line in figure.axes[0].lines if line.get_marker() == "."
    )
    assert drawn == near
    one_tack: Any = polar_lines.round_the_wind(
        [small()], (6.0,), points=some_points(both=False), theme=LIGHT
    ).axes[0]
    assert np.degrees(one_tack.get_xlim()) == pytest.approx([0.0, 180.0])


def test_colours_name_their_unit() -> None:
    words = words_of(polar_areas.colours(small(), points=None, theme=LIGHT))
    for word in ("Boat speed [kn]", "True wind speed [kn]", "True wind angle [degrees]", "90°"):
        assert word in words


def test_light_and_dark_and_the_same_again() -> None:
    import io

    from matplotlib.image import imread

    light, dark = (polar_picture([small()], "polar", dark=dark) for dark in (False, True))
    assert light == polar_picture([small()], "polar")
    assert imread(io.BytesIO(light))[0, 0, :3].min() == 1.0
    assert imread(io.BytesIO(dark))[0, 0, :3].max() < 0.2


def test_nothing_of_matplotlib_is_global() -> None:
    program = (
        "import sys, matplotlib; before = matplotlib.rcParams.copy()\n"
        "from seacruise.export.polar_pictures import polar_picture, KINDS\n"
        "from seacruise.resources import resource_path; from seacruise.yacht.files import read_polar\n"
        "polar = read_polar(resource_path('polars') / 'carter-30.csv')\n"
        "assert all(polar_picture([polar], kind) for kind in KINDS)\n"
        "assert 'matplotlib.pyplot' not in sys.modules and matplotlib.rcParams.copy() == before"
    )
    answer = subprocess.run(
        [sys.executable, "-W", "error", "-c", program], capture_output=True, text=True, check=False
    )
    assert answer.returncode == 0, answer.stderr


# --- refusals ------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("yachts", "kind", "winds", "sentence"),
    [
        (1, "pie", (), "no picture 'pie'"),
        (0, "polar", (), "No yacht was named"),
        (2, "hull", (), "shows one yacht, not 2"),
        (2, "surface", (), "use polar or flat"),
        (5, "flat", (), "compare 4 at most"),
        (1, "hull", (6, 8, 10, 12), "4 winds are too many"),
        (1, "polar", range(1, 14), "give 12 at most"),
        (1, "polar", (0,), "out of range"),
    ],
)
def test_what_cannot_be_drawn(yachts: int, kind: str, winds: Any, sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        winds_for([small()] * yachts, kind, [float(kn) for kn in winds])


def test_files(tmp_path: Path) -> None:
    write_polar_picture(tmp_path / "a.PNG", [small()], "flat")
    assert (tmp_path / "a.PNG").read_bytes().startswith(BEGINNINGS["png"])
    with pytest.raises(InputError, match=r"must end in \.png, \.pdf or \.svg"):
        write_polar_picture(tmp_path / "a.gif", [small()], "flat")
    with pytest.raises(InputError, match="no folder"):
        write_polar_picture(tmp_path / "none" / "a.png", [small()], "flat")
    with pytest.raises(InputError, match="no picture format"):
        polar_picture([small()], "flat", form="bmp")
