"""Where the pages are: below the chart, one at a time, in place of the table of legs."""

from __future__ import annotations

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
        self.tabs = QTabBar(self)
        self.tabs.setDrawBase(False)
        self.tabs.setExpanding(False)
        self.tabs.setAccessibleName(self.tr("Pages"))
        self.stack = QStackedWidget(self)
        self.tabs.currentChanged.connect(self.stack.setCurrentIndex)
        self._headings = QStackedWidget(self)
        self.tabs.currentChanged.connect(self._headings.setCurrentIndex)
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

    def add(self, page: QWidget, title: str) -> None:
        """Take a page in; the tab has its title."""
        heading: QWidget = QWidget()
        if isinstance(page, Page):
            page.title.hide()
            heading = page.heading
        self._headings.addWidget(heading)
        self.stack.addWidget(page)
        self.tabs.addTab(title)

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

    def close_pages(self) -> None:
        """Give the room back to the chart."""
        if self.is_open:
            self.hide()
            self.turned.emit()
            # Else the table of legs, hidden meanwhile, would come back with no height at all.
            sizes = [size or _LEGS_PX for size in self._sizes_before]
            self._splitter.setSizes(sizes)
