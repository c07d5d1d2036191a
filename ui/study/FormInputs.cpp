// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/FormInputs.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>

#include "ui/shell/Theme.h"

namespace ui::study {
namespace {

using namespace ui::shell;

class FormFilter final : public QObject
{
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() == QEvent::ShortcutOverride) {
            const auto* key = static_cast<QKeyEvent*>(event);
            if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
                event->ignore();
                return true;
            }
        }
        if (event->type() == QEvent::LanguageChange)
            if (auto* number = qobject_cast<QAbstractSpinBox*>(watched))
                number->setLocale(QLocale());  // with the decimal sign of that language
        if (event->type() == QEvent::Wheel && !static_cast<QWidget*>(watched)->hasFocus()) {
            event->ignore();
            return true;
        }
        return QObject::eventFilter(watched, event);
    }
};

}  // namespace

QLabel* formWords(const QString& text, int size, QFont::Weight weight, QPalette::ColorRole role, QWidget* parent)
{
    auto* made = new QLabel(text, parent);
    made->setFont(typeface(size, weight));
    made->setForegroundRole(role);
    made->setWordWrap(true);
    return made;
}

QLabel* faultLabel(QWidget* parent)
{
    auto* made = formWords({}, kSmall, QFont::Medium, QPalette::WindowText, parent);
    QPalette colours = made->palette();
    colours.setColor(QPalette::WindowText, tones(colours).harmText);
    made->setPalette(colours);
    made->hide();
    return made;
}

/// A sign before the words: a fault is not told by colour alone.
void showFault(QLabel* label, const QString& what)
{
    label->setText(what.isEmpty() ? QString() : QStringLiteral("⚠ ") + what);
    label->setVisible(!what.isEmpty());
}

void bindToForm(QWidget* input)
{
    auto* filter = new FormFilter(input);
    input->installEventFilter(filter);
    for (auto* line : input->findChildren<QLineEdit*>())
        line->installEventFilter(filter);
}

QDoubleSpinBox* numberInput(double low, double high, int decimals, const QString& unit, const QString& name,
                            QWidget* parent)
{
    auto* made = new QDoubleSpinBox(parent);
    made->setRange(low, high);
    made->setDecimals(decimals);
    made->setSuffix(unit.isEmpty() ? QString() : unit == u"°" ? unit : QStringLiteral(" ") + unit);
    made->setAccessibleName(name);
    made->setFixedWidth(kInputPx);
    made->setFocusPolicy(Qt::StrongFocus);
    bindToForm(made);
    return made;
}

QComboBox* choiceInput(const QString& name, QWidget* parent)
{
    auto* made = new QComboBox(parent);
    nameInput(made, name);
    made->setFocusPolicy(Qt::StrongFocus);
    bindToForm(made);
    return made;
}

void nameInput(QComboBox* choice, const QString& name)
{
    choice->setAccessibleName(name);
    choice->view()->setAccessibleName(name);
}

}  // namespace ui::study
