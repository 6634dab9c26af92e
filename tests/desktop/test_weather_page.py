"""The weather page: sources and what is kept of them, the key, files, a mean, and no connection."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel, QLineEdit, QWidget
from pytestqt.qtbot import QtBot

from seacruise.desktop.pages import weather_model
from seacruise.desktop.pages.weather_model import FileInfo, Mix, kept_of, load_state, look_into
from seacruise.desktop.pages.weather_page import ORDER, WeatherPage
from seacruise.errors import InputError, WeatherError
from seacruise.keychain import KeyChain
from seacruise.progress import Job
from seacruise.resources import resource_path
from seacruise.settings import Settings
from seacruise.weather import metno
from seacruise.weather.openmeteo import _service as service_name
from seacruise.weather.openmeteo_client import ENSEMBLE, FORECAST, MARINE
from seacruise.weather.practice import practice_wind
from seacruise.weather.sample import sample_wind
from seacruise.weather.source import CachedInfo
from seacruise.weather.stormglass import service_of
from tests.faultserver import FaultServer

KEY = "4d1f-SECRET-8a2c-0123456789"
NOW = datetime(2026, 11, 21, 9, 30, tzinfo=UTC)
SAMPLE = str(resource_path("assets/wind/sample.nc"))
MakePage = Callable[..., WeatherPage]


@pytest.fixture
def keyless(settings: Settings) -> Settings:
    return replace(settings, keys=KeyChain(lambda: None))


@pytest.fixture
def make_page(app: QApplication, qtbot: QtBot, keyless: Settings) -> Iterator[MakePage]:
    pages: list[WeatherPage] = []

    def make(settings: Settings = keyless, **more: Any) -> WeatherPage:
        page = WeatherPage(settings, **more)
        pages.append(page)
        qtbot.addWidget(page)
        page.resize(900, 900)
        page.show()
        with qtbot.waitSignal(page.loaded, timeout=20_000):
            page.load()
        return page

    yield make
    for page in pages:
        page.shut_down()


@pytest.fixture
def page(make_page: MakePage) -> WeatherPage:
    return make_page()


def said(widget: QWidget) -> str:
    return "\n".join(label.text() for label in widget.findChildren(QLabel) if label.isVisible())


# ------------------------------------------------------------------------------------------- sources


def test_every_source_is_there_with_what_it_gives_and_its_terms(page: WeatherPage) -> None:
    assert set(page.cards) == set(ORDER)
    assert "CC BY 4.0" in said(page.cards["open-meteo"])
    assert "non-commercial" in said(page.cards["open-meteo"])
    assert "Gives wind, gusts, waves, current" in said(page.cards["open-meteo"])
    assert "members of an ensemble" in said(page.cards["open-meteo-ensemble"])
    assert "MET Norway (CC BY 4.0)" in said(page.cards["metno"])
    assert "not a forecast" in said(page.cards["practice"])
    assert page.cards["stormglass"].status.text() == "needs a key"
    assert "Needs a key" in said(page.cards["stormglass"])
    assert "Nothing kept yet" in said(page.cards["metno"])


def test_what_they_are_said_to_give_is_what_they_give() -> None:
    for name, wind in (("practice", practice_wind(NOW)), ("sample", sample_wind())):
        brings = [part for part in ("gust", "wave", "current") if getattr(wind, part) is not None]
        assert weather_model.GIVES[name] == ("wind",), name
        assert not brings, name


def test_what_is_kept_is_added_up() -> None:
    cached = [
        CachedInfo(service_of("sg"), "57.000,18.000", 5.0),
        CachedInfo(service_of("sg"), "57.250,18.000", 3.0),
        CachedInfo(service_name(FORECAST), "143 places", 0.5),
        CachedInfo(service_name(MARINE), "120 places", 0.6),
        CachedInfo(service_name(ENSEMBLE), "40 places", 2.0),
        CachedInfo(metno._KEPT_AS, "36 places", -0.1),
    ]
    found = {name: kept_of(name, cached) for name in ORDER}
    assert {name: (kept.places, kept.age_h) for name, kept in found.items() if kept} == {
        "stormglass": (2, 3.0),
        "open-meteo": (143, 0.5),
        "open-meteo-ensemble": (40, 2.0),
        "metno": (36, 0.0),
    }


def test_quota_and_age_are_shown(make_page: MakePage, keyless: Settings) -> None:
    def load(settings: Settings, now: datetime) -> weather_model.WeatherState:
        state = load_state(replace(settings, stormglass_key=KEY), now)
        kept = weather_model.Kept(9, 3.2)
        return replace(state, sources=tuple(replace(one, kept=kept) for one in state.sources))

    page = make_page(load=load)
    text = said(page.cards["stormglass"])
    assert "10 of 10 requests left today" in text
    assert "answers for 9 places, the latest 3 h old" in text
    assert "SECRET" not in said(page)


def test_a_source_is_chosen_by_key(page: WeatherPage, qtbot: QtBot) -> None:
    with qtbot.waitSignal(page.source_chosen, timeout=5000) as caught:
        QTest.keyClick(page.cards["metno"].use_button, Qt.Key.Key_Space)
    assert caught.args == ["metno"]
    assert page.cards["metno"].use_button.text() == "In use"
    assert page.cards["auto"].use_button.text() == "Use"
    assert "MET Norway" in page.chosen.text()


def test_every_control_has_a_name(page: WeatherPage) -> None:
    for card in page.cards.values():
        assert card.use_button.accessibleName() != "Use"
    for field in page.findChildren(QLineEdit):
        parent = field.parent()
        assert field.accessibleName() or (isinstance(parent, QWidget) and parent.accessibleName())


# -------------------------------------------------------------------------------------- no connection


def test_without_a_connection_it_says_so_until_there_is_one(page: WeatherPage) -> None:
    page.show_trouble(WeatherError("Open-Meteo cannot be reached.", reason="no-network"))
    assert page.is_offline
    assert [page.banner.title if page.banner else ""] == ["No connection"]
    assert page.cards["open-meteo"].status.text() == "not reached"
    assert page.cards["practice"].status.text() == "ready"
    page.show_trouble(WeatherError("The quota is spent.", reason="quota"))
    assert page.is_offline, "another trouble says nothing about the connection"
    page.show_reached()
    assert page.banner is None
    assert page.cards["open-meteo"].status.text() == "ready"


def test_a_service_that_is_silent_is_not_a_missing_network(page: WeatherPage) -> None:
    page.show_trouble(WeatherError("Storm Glass does not answer.", reason="timeout"))
    assert not page.is_offline
    assert page.banner is not None
    assert "does not answer" in page.banner.title
    assert page.cards["metno"].status.text() == "ready"


# ------------------------------------------------------------------------------------------- the key


def test_a_key_is_kept_tested_and_removed_and_never_shown_whole(
    make_page: MakePage, keyless: Settings, qtbot: QtBot, tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    with FaultServer("good") as server:
        page = make_page(replace(keyless, stormglass_url=server.url))
        box = page.key_box
        assert box.field.echoMode() is QLineEdit.EchoMode.Password
        assert not box.keep_button.isEnabled()
        box.field.setText(f"  {KEY} ")
        with qtbot.waitSignals([page.key_changed, page.loaded], timeout=20_000):
            QTest.keyClick(box.field, Qt.Key.Key_Return)
        assert box.field.text() == ""
        assert "…6789" in box.where.text()
        assert "until SeaCruise closes" in box.where.text()
        assert page.cards["stormglass"].status.text() == "ready"
        assert server.requests == [], "nothing is sent before it is asked for"
        with qtbot.waitSignals([box.tested, page.loaded], timeout=20_000):
            box.test_button.click()
        assert len(server.requests) == 1
        assert "accepts the key: 9 of 10" in box.answer.text()
        assert "SECRET" not in said(page)
        with qtbot.waitSignals([page.key_changed, page.loaded], timeout=20_000):
            box.remove_button.click()
        assert "No key yet" in box.where.text()
        assert not box.test_button.isVisible()
    assert "SECRET" not in caplog.text
    for path in tmp_path.rglob("*"):
        assert not path.is_file() or b"SECRET" not in path.read_bytes(), path


def test_a_key_that_is_refused_says_why(make_page: MakePage, keyless: Settings, qtbot: QtBot) -> None:
    with FaultServer("401") as server:
        page = make_page(replace(keyless, stormglass_url=server.url))
        box = page.key_box
        box.field.setText("two words")
        with qtbot.waitSignal(box.tested, timeout=20_000):
            box.keep()
        assert "has characters that no key has" in box.answer.text()
        assert box.state.place == ""
        box.field.setText(KEY)
        with qtbot.waitSignal(page.key_changed, timeout=20_000):
            box.keep()
        with qtbot.waitSignal(box.tested, timeout=20_000):
            box.test()
        assert "does not accept this key" in box.answer.text()
        assert not page.is_offline


def test_the_key_of_the_environment_is_left_alone(make_page: MakePage, keyless: Settings) -> None:
    page = make_page(replace(keyless, stormglass_key=KEY))
    assert "…6789 is from STORMGLASS_API_KEY" in page.key_box.where.text()
    assert not page.key_box.field.isVisible()
    assert not page.key_box.remove_button.isVisible()
    assert page.key_box.test_button.isVisible()


def test_the_keychain_is_never_asked_by_the_windows_thread(
    app: QApplication, qtbot: QtBot, settings: Settings
) -> None:
    threads: list[bool] = []

    def find() -> None:
        threads.append(threading.current_thread() is threading.main_thread())

    page = WeatherPage(replace(settings, keys=KeyChain(find)))
    qtbot.addWidget(page)
    with qtbot.waitSignal(page.loaded, timeout=20_000):
        page.load()
    page.shut_down()
    assert threads == [False]


# --------------------------------------------------------------------------------------------- files


def drop(page: WeatherPage, *paths: str) -> None:
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(path) for path in paths])
    keys = (Qt.DropAction.CopyAction, data, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier)
    enter = QDragEnterEvent(QPoint(5, 5), *keys)
    page.dragEnterEvent(enter)
    assert enter.isAccepted()
    page.dropEvent(QDropEvent(QPointF(5, 5), *keys))


def test_files_that_are_dropped_are_read_and_shown(page: WeatherPage, qtbot: QtBot, tmp_path: Path) -> None:
    broken = tmp_path / "broken.grb"
    broken.write_bytes(b"GRIB\x00" * 9)
    with qtbot.waitSignals([page.file_read, page.file_read], timeout=60_000):
        drop(page, SAMPLE, str(broken))
    good, bad = page.files[SAMPLE], page.files[str(broken)]
    assert "Sun 20 Nov 2016 00:00 – Tue 22 Nov 2016 00:00 UTC" in said(good)
    assert "52.0 to 67.0 N, 7.0 to 32.0 E" in said(good)
    assert "Gives wind" in said(good)
    assert bad.status.text() == "cannot be used"
    assert "broken.grb" in bad.remark.text()
    assert not bad.use_button.isVisible()
    with qtbot.waitSignal(page.source_chosen, timeout=5000) as caught:
        good.use_button.click()
    assert caught.args == [SAMPLE]
    bad.remove_button.click()
    assert list(page.files) == [SAMPLE]


def test_a_file_that_the_form_has_is_looked_into(page: WeatherPage, qtbot: QtBot) -> None:
    with qtbot.waitSignal(page.file_read, timeout=60_000):
        page.show_choice((SAMPLE, "metno"), (3.0, 1.0))
    card = page.files[SAMPLE]
    assert card.in_mean
    assert card.weight == 3.0
    assert page.mean_button.text() == "The mean is in use"
    page.show_choice((SAMPLE,))
    assert card.use_button.text() == "In use"
    assert list(page.files) == [SAMPLE]


def test_a_file_taken_off_while_it_is_read_costs_nothing(make_page: MakePage, qtbot: QtBot) -> None:
    gate = threading.Event()

    def read(path: Path, job: Job, around: Sequence[tuple[float, float]]) -> FileInfo:
        while path.name == "slow.grb" and not gate.wait(0.005):
            job.check()
        raise InputError(f"{path.name} is none.")

    page = make_page(read=read)
    page.add_files(["slow.grb", "next.grb"])
    with qtbot.waitSignal(page.file_read, timeout=20_000) as caught:
        page.remove_file("slow.grb")
    assert caught.args == ["next.grb"]
    assert list(page.files) == ["next.grb"]


def test_a_file_with_gaps_may_do_for_the_passage(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[tuple[Any, ...]] = []

    def read(path: Path, *, around: tuple[Any, ...] = (), job: Job) -> Any:
        asked.append(around)
        if not around:
            raise InputError("its wind is missing over 74% of its area")
        return sample_wind()

    monkeypatch.setattr("seacruise.weather.isolated.read_isolated", read)
    with pytest.raises(InputError, match="74%"):
        look_into(Path("a.grb"), Job())
    ends = ((54.5, 18.6), (57.6, 18.3))
    assert look_into(Path("a.grb"), Job(), ends).first == sample_wind().forecast.valid_from
    assert asked == [(), (), ends]


# --------------------------------------------------------------------------------- a mean, and after


def test_a_mean_takes_two_and_their_weights(page: WeatherPage, qtbot: QtBot) -> None:
    assert not page.mean_button.isEnabled()
    assert not page.cards["practice"].mixing.isVisible()
    page.cards["open-meteo"].mix_box.click()
    assert not page.mean_button.isEnabled()
    page.cards["metno"].mix_box.click()
    page.cards["open-meteo"].weight_box.setValue(3.0)
    assert "Open-Meteo 75 %, MET Norway 25 %" in page.mean_text.text()
    with qtbot.waitSignal(page.mean_chosen, timeout=5000) as caught:
        page.mean_button.click()
    assert caught.args == [("open-meteo", "metno"), (3.0, 1.0)]
    assert "the mean of Open-Meteo (3), MET Norway (1)" in page.chosen.text()
    assert page.mean_button.text() == "The mean is in use"
    page.cards["metno"].weight_box.setValue(3.0)
    assert page.mix.weights == ()
    assert page.mean_button.text() == "Use the mean"
    page.choose("auto")
    assert page.cards["auto"].use_button.text() == "In use"


def test_the_forms_choice_is_shown(page: WeatherPage) -> None:
    page.show_choice(("metno", "stormglass"), (2.0, 1.0))
    assert page.cards["metno"].in_mean
    assert page.cards["metno"].weight == 2.0
    assert page.cards["stormglass"].in_mean
    assert all(card.use_button.text() == "Use" for card in page.cards.values())
    page.show_choice(("some/folder/file.grb",))
    assert "file.grb" in page.chosen.text()


def test_shares_are_of_one() -> None:
    mix = Mix((("a", 2.0), ("b", 1.0), ("c", 1.0)))
    assert mix.shares() == (0.5, 0.25, 0.25)
    assert (mix.names, mix.weights, mix.is_mean) == (("a", "b", "c"), (2.0, 1.0, 1.0), True)
    assert Mix((("a", 2.0), ("b", 2.0))).weights == ()


@pytest.mark.parametrize("mode", ["hold", "fade", "refuse"])
def test_what_is_done_after_the_forecast(page: WeatherPage, qtbot: QtBot, mode: str) -> None:
    box = page.beyond_box
    at = box.findData(mode)
    with qtbot.waitSignal(page.beyond_chosen, timeout=5000) as caught:
        box.setCurrentIndex(at)
        box.activated.emit(at)
    assert caught.args == [mode]
    assert page.beyond_text.text()
