"""What is filled in somewhere, filled in again in its twin: a window made anew in another language."""

from __future__ import annotations

from PySide6.QtWidgets import QAbstractButton, QAbstractSlider, QComboBox, QDoubleSpinBox, QLineEdit, QWidget


def copy_fields(source: QWidget, target: QWidget) -> None:
    """Fill the fields of a part of a window in as those of its twin are.

    Fields are the attributes of both that can be typed into, chosen from or switched; whoever listens to
    those of the target hears of it.
    """
    for name, field in vars(source).items():
        twin = vars(target).get(name)
        if isinstance(field, QWidget) and isinstance(twin, type(field)):
            copy_field(field, twin)


def copy_field(field: QWidget, twin: QWidget) -> None:
    """Fill one field in as its twin is; what is no field is passed over."""
    if isinstance(field, QLineEdit) and isinstance(twin, QLineEdit):
        twin.setText(field.text())
    elif isinstance(field, QDoubleSpinBox) and isinstance(twin, QDoubleSpinBox):
        twin.setValue(field.value())
    elif isinstance(field, QComboBox) and isinstance(twin, QComboBox):
        # Their words are in two languages; the same place means the same.
        if field.count() == twin.count():
            twin.setCurrentIndex(field.currentIndex())
    elif isinstance(field, QAbstractSlider) and isinstance(twin, QAbstractSlider):
        twin.setValue(field.value())
    elif isinstance(field, QAbstractButton) and isinstance(twin, QAbstractButton) and field.isCheckable():
        twin.setChecked(field.isChecked())
