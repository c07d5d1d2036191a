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

/// What the forms of the lesson editor are made of. Ui thread.
namespace ui::kit {

/// Words that fold.
[[nodiscard]] QLabel* formWords(const QString& text, int size, QFont::Weight weight, QPalette::ColorRole role,
                                QWidget* parent);

/// A place for what is wrong, beside the input it is about; hidden while there is nothing.
[[nodiscard]] QLabel* faultLabel(QWidget* parent);
/// @param what  empty: nothing any more
void showFault(QLabel* label, const QString& what);

/// Undo and redo in this input are the page's, which knows all steps; and a wheel over it scrolls the form unless
/// somebody has chosen it.
void bindToForm(QWidget* input);

/// A point and a comma are its decimal sign alike.
/// @param unit  behind the number; may be empty
/// @param name  for who hears it
[[nodiscard]] QDoubleSpinBox* numberInput(double low, double high, int decimals, const QString& unit,
                                          const QString& name, QWidget* parent);
/// Has it show a number. Where that is the one it has, it is left alone: somebody may be about to type its decimals.
void showNumber(QDoubleSpinBox& input, double number);
/// A whole number. One that is beyond the range can be typed, and is not taken: what was there before comes back.
[[nodiscard]] QSpinBox* countInput(int low, int high, QWidget* parent);
[[nodiscard]] QComboBox* choiceInput(const QString& name, QWidget* parent);
/// Names it, and the list that it opens.
void nameInput(QComboBox* choice, const QString& name);

inline constexpr int kInputPx = 112;

}  // namespace ui::kit
