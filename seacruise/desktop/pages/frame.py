"""Where the pages are: below the chart, one at a time, in place of the table of legs."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from PySide6.QtCore import QSize, Signal
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QSplitter,
    QStackedWidget,
    QTabBar,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from seacruise.desktop.pages.page import Page

_LEGS_PX: Final = 176
_LEAST_PX: Final = 430
_CHART_PX: Final = 230
_SHARE: Final = 0.52
"""Part of the height that pages take of the chart."""


class PagesFrame(QFrame):
    """A tab a page, and a button that closes them all; ``turned()`` when it was opened or closed."""

    turned = Signal()

    def __init__(self, splitter: QSplitter) -> None:
        super().__init__()
        self.setObjectName("legs")
        self._splitter = splitter
        self._sizes_before: list[int] = []
        self._pages: list[Callable[[], QWidget]] = []
        self.tabs = QTabBar(self)
        self.tabs.setDrawBase(False)
        self.tabs.setExpanding(False)
        self.tabs.setAccessibleName(self.tr("Pages"))
        self.stack = QStackedWidget(self)
        self.tabs.currentChanged.connect(self.stack.setCurrentIndex)
        self._headings = QStackedWidget(self)
        self.tabs.currentChanged.connect(self._headings.setCurrentIndex)
        self.tabs.currentChanged.connect(self._have_page)
        self.close_button = QToolButton(self)
        self.close_button.setText("✕")
        self.close_button.setIconSize(QSize(12, 12))
        self.close_button.setToolTip(self.tr("Close the pages"))
        self.close_button.setAccessibleName(self.tr("Close the pages"))
        self.close_button.clicked.connect(self.close_pages)
        head = QHBoxLayout()
        head.setContentsMargins(12, 4, 8, 0)
        head.setSpacing(14)
        head.addWidget(self.tabs)
        head.addWidget(self._headings, 1)
        head.addWidget(self.close_button)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 1, 0, 0)
        layout.setSpacing(0)
        layout.addLayout(head)
        layout.addWidget(self.stack, 1)
        splitter.addWidget(self)
        splitter.setCollapsible(splitter.indexOf(self), False)
        self.hide()

    def offer(self, title: str, page: Callable[[], QWidget]) -> None:
        """Add a tab; what it shows is asked for when it is first seen, and given by `take_in` then."""
        self._pages.append(page)
        self._headings.addWidget(QWidget())
        self.stack.addWidget(QWidget())
        self.tabs.addTab(title)

    def take_in(self, number: int, page: QWidget) -> None:
        """Show a page where the tab of that number has none yet."""
        heading: QWidget = QWidget()
        if isinstance(page, Page):
            page.title.hide()
            heading = page.heading
        for stack, widget in ((self._headings, heading), (self.stack, page)):
            shown = stack.currentIndex()
            stack.insertWidget(number, widget)
            if (empty := stack.widget(number + 1)) is not None:
                stack.removeWidget(empty)
                empty.deleteLater()
            stack.setCurrentIndex(shown)

    def _have_page(self, number: int) -> QWidget | None:
        return self._pages[number]() if self.is_open else None

    @property
    def is_open(self) -> bool:
        """Whether pages are shown."""
        return not self.isHidden()

    def open_page(self, page: QWidget) -> None:
        """Show a page and give it the keyboard."""
        self.tabs.setCurrentIndex(self.stack.indexOf(page))
        if not self.is_open:
            self._sizes_before = self._splitter.sizes()
            self.show()
            self.turned.emit()
            whole = self._splitter.height()
            sizes = [0] * self._splitter.count()
            sizes[-1] = max(round(_SHARE * whole), min(_LEAST_PX, whole - _CHART_PX))
            sizes[0] = whole - sizes[-1]
            self._splitter.setSizes(sizes)
        page.setFocus()

    def take_over(self, other: PagesFrame) -> None:
        """Show the page that another window shows, as high; in a window that is laid out."""
        self.tabs.setCurrentIndex(other.tabs.currentIndex())
        if not other.is_open:
            return
        self.open_page(self._pages[self.tabs.currentIndex()]())
        self._splitter.setSizes(other.sizes)
        self._sizes_before = list(other.sizes_before)

    @property
    def sizes(self) -> list[int]:
        """Heights of what is in the splitter, pages last."""
        return self._splitter.sizes()

    @property
    def sizes_before(self) -> tuple[int, ...]:
        """Heights before the pages were opened."""
        return tuple(self._sizes_before)

    def close_pages(self) -> None:
        """Give the room back to the chart."""
        if self.is_open:
            self.hide()
            self.turned.emit()
            # Else the table of legs, hidden meanwhile, would come back with no height at all.
            sizes = [size or _LEGS_PX for size in self._sizes_before]
            self._splitter.setSizes(sizes)
