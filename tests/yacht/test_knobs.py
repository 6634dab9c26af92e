"""What night and sea take off the polar."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from seacruise.errors import InputError
from seacruise.yacht.knobs import LEAST_SHARE, night_share, sea_state_share


@pytest.mark.parametrize(
    ("altitude", "share"), [(40.0, 1.0), (-0.833, 1.0), (-6.0, 0.9), (-40.0, 0.9), (-3.4165, 0.95)]
)
def test_the_night_falls_with_the_sun(altitude: float, share: float) -> None:
    assert float(night_share(altitude, at_night=0.9)) == pytest.approx(share)


@pytest.mark.parametrize(
    ("height", "twa", "share"),
    [
        (0.0, 0.0, 1.0),
        (0.5, 40.0, 1.0),
        (1.5, 0.0, 0.92),
        (1.5, 90.0, 0.98),
        (3.0, 180.0, 1.0),
        (20.0, 0.0, 0.4),
    ],
)
def test_the_sea_takes_most_from_ahead(height: float, twa: float, share: float) -> None:
    assert float(sea_state_share(height, twa)) == pytest.approx(share)


def test_a_longer_yacht_loses_less() -> None:
    assert float(sea_state_share(2.5, 0.0, length_m=20.0)) == pytest.approx(0.92)


@given(st.floats(0, 15), st.floats(0, 15), st.floats(-360, 360))
def test_more_sea_never_makes_her_faster(a: float, b: float, twa: float) -> None:
    low, high = sorted((a, b))
    assert LEAST_SHARE <= float(sea_state_share(high, twa)) <= float(sea_state_share(low, twa)) <= 1.0
    assert float(sea_state_share(a, twa)) == float(sea_state_share(a, -twa))


def test_shares_broadcast_and_unknown_stays_unknown() -> None:
    assert sea_state_share(np.ones((3, 1)), np.ones(4)).shape == (3, 4)
    assert np.isnan(sea_state_share(np.nan, 40.0))
    assert np.isnan(night_share(np.nan, at_night=0.9))


@pytest.mark.parametrize("share", [0.0, -1.0, 1.1, np.nan])
def test_a_share_is_a_share(share: float) -> None:
    with pytest.raises(InputError, match="share of speed at night"):
        night_share(0.0, at_night=share)


@pytest.mark.parametrize(("knob", "value"), [("per_metre", 2.0), ("per_metre", np.nan), ("length_m", 1.0)])
def test_knobs_have_limits(knob: str, value: float) -> None:
    with pytest.raises(InputError, match="out of range"):
        sea_state_share(1.0, 0.0, **{knob: value})
