"""What lies under everything on the chart: depth tints, the coarse coast elsewhere, what is read on it."""

from __future__ import annotations

import math
from itertools import combinations, pairwise

import numpy as np
import pytest
from numpy.typing import NDArray
from PySide6.QtCore import QPoint, QRectF
from PySide6.QtGui import QColor, QImage, QPainter
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from seacruise.desktop.chart.barbs import BarbSprites
from seacruise.desktop.chart.basemap import Extent
from seacruise.desktop.chart.basemap import Painter as CoastPainter
from seacruise.desktop.chart.coarse_layer import is_coarse
from seacruise.desktop.chart.depth_layer import band_name, band_text, strength
from seacruise.desktop.chart.importance import KNOWN, MAIN, importance, short_name
from seacruise.desktop.chart.palette import DAY, NIGHT, PALETTES, Palette, dimmed
from seacruise.desktop.chart.plane import CHARTED, WORLD, point, rectangle
from seacruise.desktop.chart.schemes import SCHEMES, Scheme
from seacruise.desktop.chart.view import ChartView
from seacruise.desktop.window import MainWindow
from seacruise.errors import CancelledError
from seacruise.ports import load_ports
from seacruise.progress import Job
from seacruise.sea.depth import BAND_LIMITS_M

BANDS = range(len(BAND_LIMITS_M) + 1)


def settle(view: ChartView, qtbot: QtBot) -> None:
    view.refresh_coast()
    qtbot.waitUntil(lambda: view.is_settled, timeout=30_000)


def picture_of(area: QRectF, *, depths: bool = True, colours: Palette = DAY) -> tuple[Extent, QImage]:
    scale = 600.0 / max(area.width(), area.height())
    extent = Extent(area.left(), area.top(), scale, 600, 600, 1.0, colours, depths)
    return extent, CoastPainter().paint(extent, None, Job()).image


def colour_at(picture: tuple[Extent, QImage], lat: float, lon: float) -> QColor:
    extent, image = picture
    at = point(lat, lon)
    return image.pixelColor(
        QPoint(int((at.x() - extent.left) * extent.scale), int((at.y() - extent.top) * extent.scale))
    )


# --- depth tint --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("colours", PALETTES.values(), ids=PALETTES.keys())
def test_the_water_is_tinted_by_its_band_and_land_is_not(app: QApplication, colours: Palette) -> None:
    picture = picture_of(rectangle(54.0, 14.0, 59.0, 22.0), colours=colours)
    assert colour_at(picture, 57.30, 20.05) == colours.depths[4], "Gotland Deep"
    assert colour_at(picture, 55.30, 15.80) == colours.depths[2], "Bornholm Basin"
    assert colour_at(picture, 54.15, 14.40) == colours.depths[0], "Oder Bank"
    assert colour_at(picture, 57.40, 18.50) == colours.land, "Gotland"


def test_without_the_tint_water_is_water(app: QApplication) -> None:
    picture = picture_of(rectangle(54.0, 14.0, 59.0, 22.0), depths=False)
    assert colour_at(picture, 57.30, 20.05) == DAY.water


def test_close_to_the_ground_the_tint_gives_way(app: QApplication) -> None:
    assert strength(1 / 1000.0) == 1.0
    assert strength(1 / 50.0) == 0.0
    half = [strength(1.0 / metres) for metres in (100.0, 150.0, 200.0, 250.0)]
    assert half == sorted(half)
    assert 0.0 < half[0] < half[-1] < 1.0
    near = picture_of(rectangle(57.28, 20.0, 57.32, 20.1))
    assert colour_at(near, 57.30, 20.05) == DAY.water


def test_strips_of_the_tint_leave_no_seams(app: QApplication) -> None:
    """Down a meridian over the whole picture no row is of a colour that no band has."""
    extent, image = picture_of(rectangle(56.6, 19.3, 58.0, 20.4))
    assert strength(extent.scale) == 1.0
    known = {colour.rgb() for colour in (*DAY.depths, DAY.land)}
    rows = [image.pixelColor(300, y).rgb() in known for y in range(600)]
    # Where bands meet their colours blend over some rows, and a shore is a line.
    assert sum(rows) > 530


def test_a_picture_nobody_wants_any_more_is_given_up(app: QApplication) -> None:
    job = Job()
    job.cancel.set()
    area = rectangle(54.0, 14.0, 59.0, 22.0)
    extent = Extent(area.left(), area.top(), 600.0 / area.width(), 600, 400, 1.0, depths=True)
    with pytest.raises(CancelledError):
        CoastPainter().paint(extent, None, job)


def test_words_of_the_bands(app: QApplication) -> None:
    assert [band_name(band) for band in BANDS] == ["< 20", "20–50", "50–100", "100–200", "> 200"]
    assert band_text(0) == "tint under about 20 m (coarse, not for navigation)"
    assert band_text(2, brief=True) == "tint about 50–100 m (coarse)"
    assert band_text(4) == "tint over about 200 m (coarse, not for navigation)"


def explains_depths(view: ChartView) -> bool:
    return view.legend.depths_shown


def test_the_switch_the_readout_and_the_field(answered: MainWindow, qtbot: QtBot) -> None:
    window, view = answered, answered.chart.view
    settle(view, qtbot)
    window.status.point(57.3, 20.05)
    assert "tint over about 200 m" in window.status.position.text()
    window.status.point(57.4, 18.5)
    assert "tint" not in window.status.position.text(), "Gotland is not tinted"
    assert explains_depths(view)
    window.menus.layers["field"].setChecked(True)
    assert not explains_depths(view), "one ground at a time"
    settle(view, qtbot)
    window.status.point(57.3, 20.05)
    assert "tint" not in window.status.position.text()
    window.menus.layers["field"].setChecked(False)
    window.menus.layers["depths"].setChecked(False)
    assert not explains_depths(view)
    settle(view, qtbot)
    assert view.coast.band_at(57.3, 20.05) is None


# --- elsewhere ---------------------------------------------------------------------------------------------


def test_other_seas_have_a_coast(app: QApplication) -> None:
    picture = picture_of(rectangle(36.0, -2.0, 45.0, 12.0))
    assert colour_at(picture, 39.6, 3.0) == DAY.land, "Mallorca"
    assert colour_at(picture, 40.2, 9.2) == DAY.land, "Sardinia"
    assert colour_at(picture, 39.0, 6.0) == DAY.uncharted
    assert colour_at(picture, 38.0, 1.5) == DAY.uncharted


def test_the_fine_coast_is_over_the_coarse_one(app: QApplication) -> None:
    """The Sound is 2 nm wide at Helsingør: no coarse coast may be seen in it."""
    picture = picture_of(rectangle(55.9, 12.3, 56.2, 13.0), depths=False)
    assert colour_at(picture, 56.03, 12.65) == DAY.water


@pytest.mark.parametrize(
    ("lat", "lon", "coarse"), [(57.0, 19.0, False), (40.0, 5.0, True), (58.0, 3.0, True)]
)
def test_where_the_coast_is_coarse_it_is_said(view: ChartView, lat: float, lon: float, coarse: bool) -> None:
    view.fit(rectangle(lat - 1.0, lon - 2.0, lat + 1.0, lon + 2.0))
    view.show_place(lat, lon)
    assert is_coarse(view.viewportTransform(), QRectF(view.viewport().rect())) == coarse


def test_the_whole_world_can_be_seen_and_no_more(view: ChartView) -> None:
    view.zoom(1e-6)
    back, _ = view.viewportTransform().inverted()
    seen = back.mapRect(QRectF(view.viewport().rect()))
    assert seen.width() <= WORLD.width() * 1.01
    assert seen.width() > 3 * CHARTED.width()


def test_barbs_ashore_are_fainter(app: QApplication) -> None:
    def ink(sprites: BarbSprites) -> float:
        picture = sprites.sprite(3, 10, side=1, density=1.0)[0].toImage()
        alphas = [
            picture.pixelColor(x, y).alpha() for x in range(picture.width()) for y in range(picture.height())
        ]
        return float(sum(alphas))

    whole, faint = (ink(BarbSprites(DAY.barb, DAY.halo, opacity)) for opacity in (1.0, 0.4))
    assert faint == pytest.approx(0.4 * whole, rel=0.03)


# --- what is read on it, and by whom ------------------------------------------------------------------------

Rgb = NDArray[np.float64]

# Machado, Oliveira and Fernandes 2009, doi:10.1109/TVCG.2009.113: severity 1, for linear RGB.
VISION = {
    "usual": np.eye(3),
    "protanopia": np.array(
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]
    ),
    "deuteranopia": np.array(
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]
    ),
    "tritanopia": np.array(
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]
    ),
}
TO_XYZ = np.array(
    [[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]]
)


def linear(colour: QColor) -> Rgb:
    channels = np.array([colour.redF(), colour.greenF(), colour.blueF()])
    return np.where(channels <= 0.04045, channels / 12.92, ((channels + 0.055) / 1.055) ** 2.4)


def lab(rgb: Rgb) -> Rgb:
    """CIE L*a*b* of linear RGB, for daylight D65."""
    xyz = TO_XYZ @ np.clip(rgb, 0.0, 1.0) / np.array([0.95047, 1.0, 1.08883])
    f = np.where(xyz > 216 / 24389, np.cbrt(xyz), (24389 / 27 * xyz + 16) / 116)
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


def contrast(a: QColor, b: QColor) -> float:
    """Contrast by WCAG 2.2."""
    low, high = sorted(float(TO_XYZ[1] @ linear(colour)) for colour in (a, b))
    return (high + 0.05) / (low + 0.05)


@pytest.mark.parametrize("vision", VISION)
@pytest.mark.parametrize("scheme", SCHEMES.values(), ids=SCHEMES.keys())
@pytest.mark.parametrize("colours", PALETTES.values(), ids=PALETTES.keys())
def test_classes_of_the_route_are_told_apart_by_every_eye(
    app: QApplication, colours: Palette, scheme: Scheme, vision: str
) -> None:
    """Differences in CIELAB: 2.3 is just noticeable side by side; by night all colours are half as bright."""
    seen = [lab(VISION[vision] @ linear(dimmed(colour, colours))) for colour in scheme.colours]
    least = 6.5 if colours is NIGHT else 10.0
    for a, b in combinations(seen, 2):
        assert math.dist(a, b) >= least


@pytest.mark.parametrize("key", ["tws", "twa", "speed"])
@pytest.mark.parametrize("vision", VISION)
def test_ordered_classes_go_one_way_in_lightness(app: QApplication, key: str, vision: str) -> None:
    """So that they are read in their order without any colour, as on a black-and-white print."""
    lightness = [lab(VISION[vision] @ linear(colour))[0] for colour in SCHEMES[key].colours]
    steps = np.diff(lightness)
    assert (np.sign(steps) == np.sign(steps[0])).all()
    assert np.abs(steps).min() >= 3.0


def test_each_class_has_words_besides_its_colour(app: QApplication) -> None:
    for scheme in SCHEMES.values():
        names = scheme.names()
        assert len(names) == len(scheme.colours)
        assert len(set(names)) == len(names)


@pytest.mark.parametrize("colours", PALETTES.values(), ids=PALETTES.keys())
def test_everything_is_read_on_every_tint(app: QApplication, colours: Palette) -> None:
    assert len(colours.depths) == len(BANDS)
    by_night = colours is NIGHT
    for tint in colours.depths:
        assert contrast(colours.ink, tint) >= (4.2 if by_night else 4.5), "names"
        assert contrast(colours.barb, tint) >= (3.0 if by_night else 4.5), "barbs"
        assert contrast(colours.keel, tint) >= (2.3 if by_night else 4.5), "rim of the route"
        assert contrast(colours.magenta, tint) >= 3.0
        assert contrast(colours.isochrone, tint) >= (2.7 if by_night else 3.0)


@pytest.mark.parametrize("colours", PALETTES.values(), ids=PALETTES.keys())
def test_tints_step_evenly_from_shallow_to_deep(app: QApplication, colours: Palette) -> None:
    """By day the deep is lighter, in the dark it is darker, as in IHO S-52; no step jumps."""
    lightness = [float(lab(linear(tint))[0]) for tint in colours.depths]
    steps = [b - a for a, b in pairwise(lightness)]
    assert all(step > 0 for step in steps) if colours is DAY else all(step < 0 for step in steps)
    assert all(1.2 <= abs(step) <= 5.0 for step in steps)


# --- names --------------------------------------------------------------------------------------------------


def test_important_ports_are_ports_and_come_first() -> None:
    names = [port.name for port in load_ports()]
    towns = {short_name(name) for name in names}
    assert towns >= MAIN
    assert towns >= KNOWN
    assert not MAIN & KNOWN
    ranked = sorted(names, key=importance)
    assert {short_name(name) for name in ranked[:20]} <= MAIN
    assert ranked.index("Helsinki") < ranked.index("Helsinki (Katajanokka)") < ranked.index("Ystad")
    assert short_name("Sankt-Peterburg (Kronshtadt)") == "Sankt-Peterburg"


@pytest.mark.parametrize("metres", [2400.0, 900.0, 300.0])
def test_names_of_ports_never_touch_at_any_zoom(view: ChartView, qtbot: QtBot, metres: float) -> None:
    """All names and dots that a frame shows, by the places that they took."""
    view.ports.show_ports(load_ports())
    view.zoom(1.0 / metres / view.transform().m11())
    view.show_place(55.2, 12.0)
    settle(view, qtbot)
    view.grab()
    room, to_pixels = QRectF(view.viewport().rect()), view.viewportTransform()
    taken: list[tuple[float, float, float, float]] = []
    labels = view.ports.labels
    labels.begin(room)
    take = labels.take_box

    def note(box: tuple[float, float, float, float]) -> None:
        taken.append(box)
        take(box)

    image = QImage(view.size(), QImage.Format.Format_ARGB32_Premultiplied)
    painter = QPainter(image)
    labels.take_box = note  # type: ignore[method-assign]
    try:
        view.ports.paint(painter, to_pixels, room)
    finally:
        painter.end()
        labels.take_box = take  # type: ignore[method-assign]
    names, dots = taken[0::2], taken[1::2]
    assert len(names) >= 5
    for a, b in combinations(names, 2):
        assert a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]
    for k, a in enumerate(names):
        for b in dots[:k]:
            assert a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]
