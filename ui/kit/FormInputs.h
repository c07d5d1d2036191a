// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QPalette>
#include <QString>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;
class QWidget;

/// Widgets for the forms of the lesson editor. Ui thread.
namespace ui::kit {

/// Returns a word-wrapping label.
[[nodiscard]] QLabel* formWords(const QString& text, int size, QFont::Weight weight, QPalette::ColorRole role,
                                QWidget* parent);

/// Returns a hidden label for the error of the input beside it.
[[nodiscard]] QLabel* faultLabel(QWidget* parent);
/// Shows an error and its icon, or hides the label.
/// @param what  empty: no error
void showFault(QLabel* label, const QString& what);

/// Disables undo and redo in an input, because the page has its own undo history. The mouse wheel scrolls the form
/// unless the input has the focus.
void bindToForm(QWidget* input);

/// Returns a number input that accepts both a point and a comma as the decimal sign.
/// @param unit  shown after the number; may be empty
/// @param name  for screen readers
[[nodiscard]] QDoubleSpinBox* numberInput(double low, double high, int decimals, const QString& unit,
                                          const QString& name, QWidget* parent);
/// Sets the number of an input. Does nothing if the input has this number already, because the user may be typing
/// decimals.
void showNumber(QDoubleSpinBox& input, double number);
/// Returns an input for a whole number. A number beyond the range can be typed, but leaving the input restores the
/// previous number.
[[nodiscard]] QSpinBox* countInput(int low, int high, QWidget* parent);
[[nodiscard]] QComboBox* choiceInput(const QString& name, QWidget* parent);
/// Sets the accessible name of a combo box and of its list.
void nameInput(QComboBox* choice, const QString& name);

inline constexpr int kInputPx = 112;

}  // namespace ui::kit
