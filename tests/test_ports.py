"""Ports: the shipped file, faults in one's own, and finding a port as it is typed."""

from __future__ import annotations

import csv
import tempfile
from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise import resources
from seacruise.errors import InputError
from seacruise.geodesy import great_circle_m
from seacruise.ports import Port, find_port, load_ports, parse_position, search_ports
from seacruise.resources import resource_path
from seacruise.text import fold, folds
from seacruise.units import METRES_PER_NM

PORTS = load_ports()
HEADER = "name,country,lat,lon\n"


def read(tmp_path: Path, content: str | bytes) -> tuple[Port, ...]:
    path = tmp_path / "ports.csv"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return load_ports(path)


# --- the shipped file ----------------------------------------------------------------------------------


def test_the_shipped_file_has_the_header_as_promised() -> None:
    data = resource_path("ports.csv").read_bytes()
    assert data.startswith(b"name,country,lat,lon\n")
    rows = list(csv.reader(data.decode("utf-8").splitlines()))
    assert len(rows) == len(PORTS) + 1 > 150


def test_the_whole_baltic_is_covered() -> None:
    assert {port.country for port in PORTS} == {"SE", "DK", "DE", "PL", "FI", "EE", "LV", "AX", "LT", "RU"}
    assert all(53.3 < port.lat < 66.0 and 9.0 < port.lon < 30.5 for port in PORTS)
    assert min(p.lat for p in PORTS) < 53.5
    assert max(p.lat for p in PORTS) > 65.5


def test_no_two_ports_are_the_same_place() -> None:
    for k, a in enumerate(PORTS):
        for b in PORTS[k + 1 :]:
            assert great_circle_m(a.lat, a.lon, b.lat, b.lon) > 0.25 * METRES_PER_NM, (a, b)


def test_ports_lie_where_the_world_port_index_has_them(shared_data: Path) -> None:
    """The same name, reduced to letters, is never another town; a big town's harbours lie miles apart."""
    with (shared_data / "ports/wpi_baltic.csv").open(encoding="utf-8-sig", newline="") as file:
        index = {
            fold(r["Main Port Name"]): (float(r["Latitude"]), float(r["Longitude"]))
            for r in csv.DictReader(file)
        }
    # Marstal and Pori stand in the index with positions of other places, miles inland.
    wrong_there = {"marstal", "pori", "farosund", "porvoo"}
    checked = 0
    for port in PORTS:
        for key in set(folds(port.name)) & set(index) - wrong_there:
            off = float(great_circle_m(port.lat, port.lon, *index[key])) / METRES_PER_NM
            assert off < 5.0, port
            checked += 1
    assert checked > 70


# --- finding -------------------------------------------------------------------------------------------


TOWNS = """
    Gdynia Stockholm Karlskrona Świnoujście Klaipėda Kiel Helsinki Visby Rønne Travemünde Tallinn Szczecin
    Rīga Gdańsk København Göteborg Flensburg Kołobrzeg Ventspils Liepāja Mariehamn Turku Kalmar Ystad
    Sassnitz Aarhus
"""


@pytest.mark.parametrize("name", TOWNS.split())
def test_towns_are_found_by_their_own_name(name: str) -> None:
    assert find_port(name, PORTS).name == name


@pytest.mark.parametrize(
    ("typed", "name"),
    [
        ("Swinoujscie", "Świnoujście"),
        ("swinoujscie ", "Świnoujście"),
        ("GDANSK", "Gdańsk"),
        ("Ronne", "Rønne"),
        ("Roenne", "Rønne"),
        ("Arhus", "Aarhus"),
        ("Århus", "Aarhus"),
        ("A\u030arhus", "Aarhus"),
        ("Travemuende", "Travemünde"),
        ("Travemunde", "Travemünde"),
        ("Grossenbrode", "Großenbrode"),
        ("aeroskobing", "Ærøskøbing"),
        ("Ærøskøbing", "Ærøskøbing"),
        ("Riga", "Rīga"),
        ("Klaipeda", "Klaipėda"),
        ("leba", "Łeba"),
        ("Copenhagen", "København"),
        ("Kobenhavn", "København"),
        ("Gothenburg", "Göteborg"),
        ("Åbo", "Turku"),
        ("Greifswald Wieck", "Greifswald-Wieck"),
        ("warnem", "Warnemünde"),
        ("gdansk gorki", "Gdańsk (Górki Zachodnie)"),
        ("Margretheholm", "København (Margretheholm)"),
        ("St Petersburg", "Sankt-Peterburg (Kronshtadt)"),
        ("Utö", "Utö (Finland)"),
    ],
)
def test_ports_are_found_as_typed(typed: str, name: str) -> None:
    assert find_port(typed, PORTS).name == name


def test_a_plain_town_name_finds_the_first_of_its_harbours() -> None:
    ports = (Port("Åby (Norra)", "SE", 57.0, 17.0), Port("Åby (Södra)", "SE", 56.9, 17.0))
    assert find_port("Åby", ports) == ports[0]
    assert find_port("Aaby", ports) == ports[0]
    assert find_port("aby sodra", ports) == ports[1]


@pytest.mark.parametrize(
    ("typed", "sentence"),
    [
        ("", "No port was named"),
        ("Stokholm", "There is no port 'Stokholm': did you mean Stockholm"),
        ("Gdyna", "did you mean Gdynia"),
        ("Hels", "More than one port fits 'Hels'"),
        ("Atlantis", "There is no port 'Atlantis'"),
        ("🚤", "There is no port '🚤'; see the list"),
        ("-", "There is no port '-'; see the list"),
        ("91,18", "is not on the earth"),
        ("54.5,181", "is not on the earth"),
        ("54°61'N 018°33'E", "60 minutes or seconds"),
        ("54.5", "There is no port"),
    ],
)
def test_what_is_no_port_is_told_with_the_closest(typed: str, sentence: str) -> None:
    with pytest.raises(InputError) as caught:
        find_port(typed, PORTS)
    assert sentence in str(caught.value)


@pytest.mark.parametrize(
    "typed",
    [
        "54.5,18.75",
        " 54.5 , 18.75 ",
        "54.5 18.75",
        "+54.5;18.75",
        "54.5°, 18.75°",
        "54.5N 18.75E",
        "54.5 N, 18.75 E",
        "54°30.0'N 018°45.0'E",
        "54°30,0′N, 018°45,0′E",
        "54 30.0 N 18 45.0 E",
        "N54°30' E018°45'",
        "N 54°30'00\" E 018°45'00\"",
        "54°30'00\"N 18°45'00\"E",
        "18°45'E 54°30'N",
    ],
)
def test_positions_are_read_as_sailors_write_them(typed: str) -> None:
    port = find_port(typed, PORTS)
    assert (port.lat, port.lon) == pytest.approx((54.5, 18.75))
    assert port.name == "54°30.0'N 018°45.0'E"
    assert not port.country


def test_the_southern_and_western_hemispheres_are_negative() -> None:
    assert parse_position("33°51'S 151°12'W") == pytest.approx((-33.85, -151.2))
    assert parse_position("-33.85,-151.2") == pytest.approx((-33.85, -151.2))


@pytest.mark.parametrize("text", ["54°30'N 55°30'N", "54°30'N", "N54 18", "Gdynia 54", "5 6 7 8 9 N 1 E"])
def test_what_is_not_quite_a_position_is_none(text: str) -> None:
    assert parse_position(text) is None


def test_search_ranks_what_is_typed_so_far() -> None:
    assert [port.name for port in search_ports("gd", PORTS)][:2] == ["Gdynia", "Gdańsk"]
    assert search_ports("kiel", PORTS)[0].name == "Kiel"
    assert {p.name for p in search_ports("kiel", PORTS)} >= {"Kiel", "Kiel (Schilksee)"}
    assert search_ports("schilk", PORTS)[0].name == "Kiel (Schilksee)"
    assert search_ports("copen", PORTS)[0].name == "København"
    assert len(search_ports("", PORTS, 7)) == 7
    assert search_ports("?!", PORTS) == []
    assert search_ports("xyzzy", PORTS) == []


@given(st.text(max_size=30))
def test_whatever_is_typed_only_input_errors_come(text: str) -> None:
    with suppress(InputError):
        find_port(text, PORTS)
    search_ports(text, PORTS)


@given(st.sampled_from(PORTS), st.integers(1, 20))
def test_every_name_is_found_and_every_beginning_lists_it(port: Port, length: int) -> None:
    assert find_port(port.name, PORTS) == port
    assert find_port(fold(port.name), PORTS) == port
    beginning = port.name[:length].strip(" (")
    assert port in search_ports(beginning, PORTS, len(PORTS))


@given(st.floats(-90, 90), st.floats(-180, 180))
def test_any_position_is_understood(lat: float, lon: float) -> None:
    port = find_port(f"{lat:.6f},{lon:.6f}", ())
    assert (port.lat, port.lon) == pytest.approx((lat, lon), abs=1e-6)


# --- faults of the file --------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("content", "sentence"),
    [
        pytest.param("", "is empty", id="empty"),
        pytest.param("port,lat,lon\n", "line 1: the header must be name,country,lat,lon", id="wrong header"),
        pytest.param(HEADER, "has a header but no ports", id="header only"),
        pytest.param(
            HEADER + "A,PL,54,18\nB,PL,55,18\nA,PL,54,18\n", "line 4: A is already in line 2", id="duplicate"
        ),
        pytest.param(
            HEADER + "A,PL,18.5,54.5\n", "line 2: A at lat 18.5, lon 54.5 is far from PL", id="swapped"
        ),
        pytest.param(
            HEADER + "A,,118.5,54.5\n", "lat 118.5 is not within -90 and 90 (lat and lon", id="swapped east"
        ),
        pytest.param(
            HEADER + "A,PL,54°31'N,18.5\n", 'lat "54°31\'N" is in degrees and minutes', id="DMS text"
        ),
        pytest.param(
            HEADER + "A,PL,54 31,18.5\n", "lat '54 31' is in degrees and minutes", id="degrees minutes"
        ),
        pytest.param(HEADER + "A,PL,54.5,181\n", "line 2: lon 181 is not within", id="out of range"),
        pytest.param(HEADER + "A,PL,nan,18\n", "lat 'nan' is not a number", id="nan"),
        pytest.param(HEADER + "A,PL,north,18\n", "lat 'north' is not a number", id="text"),
        pytest.param(HEADER + "A,PL,,18\n", "line 2: lat is missing", id="no latitude"),
        pytest.param(HEADER + "A,PL,54\n", "line 2: 3 values where", id="too few"),
        pytest.param(HEADER + "A, B,PL,54,18\n", "line 2: 5 values where", id="comma in the name"),
        pytest.param(HEADER + ",PL,54,18\n", "line 2: the name is missing", id="no name"),
        pytest.param(HEADER + "A,Poland,54,18\n", "country 'Poland' is not a code", id="country"),
        pytest.param(HEADER + '"A,PL,54,18\n', "check the quotation marks", id="open quote"),
        pytest.param(b"\x00\x01\x02", "is not a text file", id="binary"),
    ],
)
def test_what_is_wrong_with_ports_is_said_with_the_line(
    tmp_path: Path, content: str | bytes, sentence: str
) -> None:
    with pytest.raises(InputError) as caught:
        read(tmp_path, content)
    assert sentence in str(caught.value)
    assert "ports.csv" in str(caught.value)


def test_a_missing_file_is_told(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"There is no list of ports"):
        load_ports(tmp_path / "none.csv")


def test_trailing_commas_blank_lines_and_a_mark_do_no_harm(tmp_path: Path) -> None:
    text = "\ufeffName, Country,LAT,lon\r\n\r\nŁódź  Port,pl,54.5,18.5,,\r\n,,,\r\n"
    assert read(tmp_path, text) == (Port("Łódź Port", "PL", 54.5, 18.5),)


def test_a_name_with_a_comma_stands_in_quotes(tmp_path: Path) -> None:
    assert read(tmp_path, HEADER + '"Utö, Gruvbryggan",SE,58.9,18.3\n')[0].name == "Utö, Gruvbryggan"


def test_ports_elsewhere_in_the_world_are_welcome(tmp_path: Path) -> None:
    assert read(tmp_path, HEADER + "Sydney,AU,-33.85,151.2\n")[0].lat == -33.85


def test_100000_rows_are_read_and_searched(tmp_path: Path) -> None:
    rows = "".join(f"Port {k},SE,{55 + k * 1e-4:.4f},18\n" for k in range(100_000))
    ports = read(tmp_path, HEADER + rows)
    assert len(ports) == 100_000
    assert find_port("port 99999", ports) == ports[-1]


@given(st.binary(max_size=300))
def test_hostile_files_raise_nothing_but_input_errors(content: bytes) -> None:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "ports.csv"
        for data in (content, HEADER.encode() + content, HEADER.encode() + b"A,PL,54,18\n" + content):
            path.write_bytes(data)
            with suppress(InputError):
                load_ports(path)


# --- where the files lie ---------------------------------------------------------------------------------


def test_the_wheels_own_files_come_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(resources, "_PACKAGE", tmp_path / "seacruise")
    (tmp_path / "ports.csv").write_text("checkout")
    (tmp_path / "seacruise/_data").mkdir(parents=True)
    assert resource_path("ports.csv") == tmp_path / "ports.csv"
    (tmp_path / "seacruise/_data/ports.csv").write_text("wheel")
    assert resource_path("ports.csv").read_text() == "wheel"
    with pytest.raises(InputError, match="polars is missing; install it again"):
        resource_path("polars")
