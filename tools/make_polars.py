"""Make polars/*.csv from ORC certificates: ``python tools/make_polars.py DATA``, DATA holding ``polars/orc``.

A certificate gives speeds at eight angles, and at every wind speed the beat and run angle with the VMG
there; boat speed at those is ``vmg / |cos(angle)|``.
"""

from __future__ import annotations

import json
import math
import sys
from pathlib import Path
from typing import Any

# Certificate file: the name a sailor would type.
YACHTS = {
    "albin-express": "Albin Express",
    "albin-nova": "Albin Nova",
    "arcona-340": "Arcona 340",
    "arcona-370": "Arcona 370",
    "arcona-400": "Arcona 400",
    "bavaria-36": "Bavaria 36",
    "bavaria-40-cruiser": "Bavaria 40 Cruiser",
    "bavaria-40-cruiser_nospi": "Bavaria 40 Cruiser (no spinnaker)",
    "bavaria-46-cruiser": "Bavaria 46 Cruiser",
    "bavaria-46-cruiser_nospi": "Bavaria 46 Cruiser (no spinnaker)",
    "bavaria-c45": "Bavaria C45",
    "bavaria-c45_nospi": "Bavaria C45 (no spinnaker)",
    "bavaria-c50": "Bavaria C50",
    "bavaria-c50_nospi": "Bavaria C50 (no spinnaker)",
    "bavaria-cr-41": "Bavaria Cruiser 41",
    "bavaria-cruiser-34": "Bavaria Cruiser 34",
    "carter-30": "Carter 30",
    "comfortina-32": "Comfortina 32",
    "conrad-25r": "Conrad 25RT",
    "cookson-50": "Cookson 50",
    "dehler-29": "Dehler 29",
    "dehler-34": "Dehler 34",
    "dehler-38": "Dehler 38",
    "dehler-42": "Dehler 42",
    "delphia-37": "Delphia 37",
    "delphia-40": "Delphia 40",
    "delphia-47": "Delphia 47",
    "delphia-47_nospi": "Delphia 47 (no spinnaker)",
    "dufour-34": "Dufour 34",
    "dufour-375-gl": "Dufour 375 Grand Large",
    "dufour-40": "Dufour 40",
    "dufour-460-gl": "Dufour 460 Grand Large",
    "edel-660": "Edel 660",
    "elan-333": "Elan 333",
    "elan-350": "Elan 350",
    "first-31.7": "First 31.7",
    "first-36.7": "First 36.7",
    "first-40.7": "First 40.7",
    "folkboat": "Nordic Folkboat",
    "grand-soleil-40": "Grand Soleil 40",
    "h-boat": "H-boat",
    "hallberg-rassy-340": "Hallberg-Rassy 340",
    "hallberg-rassy-36": "Hallberg-Rassy 36",
    "hallberg-rassy-40": "Hallberg-Rassy 40",
    "hallberg-rassy-412": "Hallberg-Rassy 412",
    "hallberg-rassy-412_nospi": "Hallberg-Rassy 412 (no spinnaker)",
    "hanse-315": "Hanse 315",
    "hanse-348": "Hanse 348",
    "hanse-370": "Hanse 370",
    "hanse-388": "Hanse 388",
    "hanse-400": "Hanse 400",
    "hanse-418": "Hanse 418",
    "hanse-418_nospi": "Hanse 418 (no spinnaker)",
    "if-boat": "IF-boat",
    "maxi-77": "Maxi 77",
    "najad": "Najad 320",
    "oceanis-38.1": "Oceanis 38.1",
    "oceanis-38.1_nospi": "Oceanis 38.1 (no spinnaker)",
    "oceanis-393": "Oceanis 393",
    "oceanis-40.1": "Oceanis 40.1",
    "oceanis-45": "Oceanis 45",
    "oceanis-45_nospi": "Oceanis 45 (no spinnaker)",
    "omega-36": "Omega 36",
    "sun-odyssey-349": "Sun Odyssey 349",
    "sun-odyssey-36i": "Sun Odyssey 36i",
    "sun-odyssey-37": "Sun Odyssey 37",
    "sun-odyssey-410": "Sun Odyssey 410",
    "sun-odyssey-410_nospi": "Sun Odyssey 410 (no spinnaker)",
    "sun-odyssey-509": "Sun Odyssey 509",
    "x-332": "X-332",
    "x-37": "X-37",
    "x-43": "X-43",
    "xc-38": "Xc 38",
}


def house_format(certificate: dict[str, Any], name: str) -> str:
    """Write a certificate as text; a beat or run row has a figure at its own wind speeds only."""
    vpp, boat = certificate["vpp"], certificate["boat"]
    winds = vpp["speeds"]
    rows: dict[float, dict[int, float]] = {a: dict(enumerate(vpp[str(a)])) for a in vpp["angles"]}
    for kind in ("beat", "run"):
        for k, (angle, vmg) in enumerate(zip(vpp[f"{kind}_angle"], vpp[f"{kind}_vmg"], strict=True)):
            speed = round(vmg / abs(math.cos(math.radians(angle))), 4)
            rows.setdefault(angle, {}).setdefault(k, speed)
    certified = f"ORC certificate {certificate['sailnumber']}: {boat['type']}, {boat['year']}"
    lines = [
        f"# source: {certified}; collected by jieter/orc-data (MIT)",
        f"# name: {name}",
        ";".join(["twa/tws", *(f"{tws:g}" for tws in winds)]),
    ]
    for angle, speeds in sorted(rows.items()):
        cells = (f"{speeds[k]:g}" if k in speeds else "" for k in range(len(winds)))
        lines.append(";".join([f"{angle:g}", *cells]))
    return "\n".join(lines) + "\n"


def main(data: Path) -> None:
    """Write all polars."""
    folder = Path(__file__).resolve().parent.parent / "polars"
    for slug, name in YACHTS.items():
        certificate = json.loads((data / "polars/orc/json" / f"{slug}.json").read_text(encoding="utf-8"))
        (folder / f"{slug.replace('_nospi', '-no-spinnaker')}.csv").write_text(
            house_format(certificate, name), encoding="utf-8", newline="\n"
        )
    print(f"{len(YACHTS)} polars in {folder}")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
