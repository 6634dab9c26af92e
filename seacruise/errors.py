"""One small tree of errors: each says what was wrong, where, and what to do.

Every error carries a sentence for the sailor (``str(error)``), a ``reason`` code for programs and the
exit code of the command line. Nothing else may reach a user.
"""

from __future__ import annotations


class SeaCruiseError(Exception):
    """Base of everything SeaCruise raises on purpose.

    Parameters
    ----------
    sentence
        What was wrong, where, and what to do about it, in plain words.
    reason
        Short code of the cause, e.g. ``"becalmed"`` or ``"quota"``; stable, for scripts.
    """

    exit_code = 1
    default_reason = "error"

    def __init__(self, sentence: str, *, reason: str | None = None) -> None:
        super().__init__(sentence)
        self.reason = reason or self.default_reason


class InputError(SeaCruiseError):
    """The request itself is wrong: an unknown port, a broken polar file, a date out of range."""

    exit_code = 2
    default_reason = "bad-input"


class NoPassageError(SeaCruiseError):
    """There is no passage; ``reason`` says why and ``place`` where the trouble is, when known.

    Reasons: ``becalmed``, ``no-water-path``, ``wind-limit``, ``dead-angle``, ``outside-forecast``.
    """

    exit_code = 3
    default_reason = "no-passage"

    def __init__(
        self, sentence: str, *, reason: str | None = None, place: tuple[float, float] | None = None
    ) -> None:
        super().__init__(sentence, reason=reason)
        self.place = place


class WeatherError(SeaCruiseError):
    """A weather service failed; a file that cannot be used is an `InputError`.

    Reasons: ``no-network``, ``no-key``, ``bad-key``, ``quota``, ``bad-response``, ``timeout``.
    """

    exit_code = 4
    default_reason = "bad-response"


class CancelledError(SeaCruiseError):
    """The sailor pressed Cancel (or Ctrl+C); nothing was lost."""

    exit_code = 130
    default_reason = "cancelled"

    def __init__(self, sentence: str = "Cancelled.") -> None:
        super().__init__(sentence)
