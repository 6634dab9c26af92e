"""The Storm Glass key: typed once, kept by the system, tested when asked, and never shown whole."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QLineEdit, QPushButton, QVBoxLayout, QWidget

from seacruise.desktop.banner import text_label
from seacruise.desktop.jobs import JobRunner
from seacruise.desktop.language import sentence
from seacruise.desktop.pages.flow import FlowLayout
from seacruise.desktop.pages.weather_model import KeyState, ask_with_key, keep_key, remove_key
from seacruise.errors import WeatherError
from seacruise.weather.cache import Quota

if TYPE_CHECKING:
    from collections.abc import Callable

    from seacruise.desktop.jobs import Work
    from seacruise.errors import SeaCruiseError
    from seacruise.settings import Settings


class KeyBox(QWidget):
    """Field and buttons for the key.

    Signals: ``changed()`` when a key was kept or removed, ``tested(error or None)`` when the service has
    answered, or not.
    """

    changed = Signal()
    tested = Signal(object)

    def __init__(self, settings: Settings, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._settings = settings
        self.state = KeyState()
        self.jobs = JobRunner("key", self)
        self.jobs.finished.connect(self._finished)
        self.jobs.failed.connect(self._failed)
        self.where = text_label("", "", self)
        self.answer = text_label("", "hint", self)
        self.answer.hide()
        self.field = QLineEdit(self)
        self.field.setEchoMode(QLineEdit.EchoMode.Password)
        self.field.setPlaceholderText(self.tr("Paste your key here"))
        self.field.setAccessibleName(self.tr("Storm Glass key"))
        self.field.setMaxLength(400)
        self.field.returnPressed.connect(self.keep)
        self.field.textChanged.connect(self._show_buttons)
        self.keep_button = self._button(self.tr("Keep the key"), self.keep)
        self.test_button = self._button(self.tr("Test it (one request)"), self.test)
        self.remove_button = self._button(self.tr("Remove it"), self.remove)
        self._entry = QWidget(self)
        entry = QHBoxLayout(self._entry)
        entry.setContentsMargins(0, 0, 0, 0)
        entry.setSpacing(8)
        entry.addWidget(self.field, 1)
        entry.addWidget(self.keep_button)
        buttons = QWidget(self)
        flow = FlowLayout(buttons)
        flow.addWidget(self.test_button)
        flow.addWidget(self.remove_button)
        self._buttons = buttons
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 2, 0, 2)
        layout.setSpacing(6)
        for widget in (self.where, self._entry, buttons, self.answer):
            layout.addWidget(widget)
        self.show_state(self.state)

    def _button(self, text: str, do: Callable[[], None]) -> QPushButton:
        button = QPushButton(text, self)
        button.clicked.connect(do)
        return button

    # --- what it does -------------------------------------------------------------------------------

    def keep(self) -> None:
        """Keep what was typed; the field is emptied at once."""
        text = self.field.text()
        if not text.strip() or self.jobs.is_running:
            return
        self.field.clear()
        self._run(lambda _job: keep_key(self._settings, text), self.tr("Keeping the key…"))

    def remove(self) -> None:
        """Forget the key."""
        self._run(lambda _job: remove_key(self._settings), self.tr("Removing the key…"))

    def test(self) -> None:
        """Ask the service with it, once."""
        self._run(partial(ask_with_key, self._settings), self.tr("Asking Storm Glass…"))

    def _run(self, work: Work, message: str) -> None:
        if self.jobs.is_running:
            return
        self._say(message)
        self.jobs.run_job(work)
        self._show_buttons()

    def _finished(self, _generation: int, result: object) -> None:
        if isinstance(result, Quota):
            self._say(
                self.tr("Storm Glass accepts the key: {left} of {daily} requests left today.").format(
                    left=result.left, daily=result.daily
                ),
                "good",
            )
            self.tested.emit(None)
        elif isinstance(result, KeyState):
            self._say("")
            self.show_state(result)
            self.changed.emit()
        self._show_buttons()

    def _failed(self, _generation: int, error: SeaCruiseError) -> None:
        typed = self.state.place in {"keychain", "session"}
        refused = isinstance(error, WeatherError) and error.reason == "bad-key" and typed
        # The service's own sentence speaks of the environment, where this key is not from.
        own = self.tr("Storm Glass does not accept this key; copy it again from your page there.")
        self._say(own if refused else sentence(str(error)), "fault")
        self._show_buttons()
        self.tested.emit(error)

    # --- what it shows ------------------------------------------------------------------------------

    def show_state(self, state: KeyState) -> None:
        """Show where the key is from."""
        self.state = state
        self.where.setText(self._sentence(state))
        self._entry.setVisible(state.place != "environment")
        self.field.setPlaceholderText(
            self.tr("Paste another key here") if state.place else self.tr("Paste your key here")
        )
        self._show_buttons()

    def _sentence(self, state: KeyState) -> str:
        lasting = (
            self.tr("The system's keychain will keep it.")
            if state.can_last
            else self.tr("It is kept until SeaCruise closes: this system has no keychain that it can use.")
        )
        return {
            "": self.tr("No key yet; a free one allows ten requests a day. {lasting}"),
            "environment": self.tr("Key {shown} is from STORMGLASS_API_KEY, which comes before any other."),
            "keychain": self.tr("Key {shown} is kept in the system's keychain."),
            "session": self.tr("Key {shown}. {lasting}"),
        }[state.place].format(shown=state.shown, lasting=lasting)

    def _show_buttons(self) -> None:
        idle, place = not self.jobs.is_running, self.state.place
        self.keep_button.setEnabled(idle and bool(self.field.text().strip()))
        self.test_button.setEnabled(idle)
        self.remove_button.setEnabled(idle)
        self.test_button.setVisible(bool(place))
        self.remove_button.setVisible(place in {"keychain", "session"})
        self._buttons.setVisible(bool(place))

    def _say(self, text: str, name: str = "hint") -> None:
        self.answer.setText(text)
        self.answer.setObjectName(name)
        self.answer.style().polish(self.answer)
        self.answer.setVisible(bool(text))

    def shut_down(self) -> None:
        """End the worker."""
        self.jobs.shut_down(patience_s=0.2)
