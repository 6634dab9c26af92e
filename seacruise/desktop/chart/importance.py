"""Which ports are named first where there is not room for all, and how they are called from afar."""

from __future__ import annotations

from typing import Final

MAIN: Final = frozenset(
    (
        *("København", "Stockholm", "Helsinki", "Tallinn", "Rīga", "Gdańsk", "Gdynia", "Klaipėda", "Kiel"),
        *("Göteborg", "Visby", "Turku", "Mariehamn", "Szczecin", "Lübeck", "Warnemünde", "Aarhus"),
        *("Kalmar", "Rønne", "Oulu", "Luleå", "Umeå", "Vaasa", "Sundsvall", "Skagen", "Sankt-Peterburg"),
    )
)
"""Capitals, great ports, and where everybody has been."""

KNOWN: Final = frozenset(
    (
        *("Karlskrona", "Sassnitz", "Stralsund", "Świnoujście", "Kołobrzeg", "Hel", "Łeba", "Ustka", "Gävle"),
        *("Ventspils", "Liepāja", "Pärnu", "Kuressaare", "Haapsalu", "Hanko", "Kotka", "Rauma", "Pori"),
        *(
            "Sandhamn",
            "Nynäshamn",
            "Oskarshamn",
            "Västervik",
            "Norrköping",
            "Ystad",
            "Trelleborg",
            "Halmstad",
        ),
        *("Helsingborg", "Helsingør", "Varberg", "Frederikshavn", "Aalborg", "Fredericia", "Svendborg"),
        *(
            "Malmö",
            "Flensburg",
            "Travemünde",
            "Wismar",
            "Heiligenhafen",
            "Gedser",
            "Nexø",
            "Baltiysk",
            "Vyborg",
        ),
    )
)


def short_name(name: str) -> str:
    """Leave out what tells a harbour from others of its town: of no use from afar."""
    return name.partition(" (")[0]


def importance(name: str) -> tuple[int, bool]:
    """Key by which ports are sorted, the more important before the less; a town before its other harbours."""
    town = short_name(name)
    return 0 if town in MAIN else 1 if town in KNOWN else 2, town != name
