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
#include <QStyledItemDelegate>

#include "ui/shell/Theme.h"

namespace ui::study {
namespace {

using namespace ui::shell;

constexpr int kEntryPx = 24;

/// That of the window's language, but a point or a comma never stands between thousands.
QLocale formLocale()
{
    QLocale locale;
    locale.setNumberOptions(locale.numberOptions() | QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
    return locale;
}

/// A point and a comma are both the decimal sign, in every language: who types 0.25 in German means a quarter.
class NumberInput final : public QDoubleSpinBox
{
public:
    using QDoubleSpinBox::QDoubleSpinBox;

    QValidator::State validate(QString& text, int& at) const override
    {
        const qsizetype end = text.size() - (text.endsWith(suffix()) ? suffix().size() : 0);
        QString number = text.left(end);
        for (const char sign : {'.', ','})
            number.replace(QLatin1Char(sign), locale().decimalPoint());
        text.replace(0, end, number);
        return QDoubleSpinBox::validate(text, at);
    }
};

/// Entries of a list, far enough apart to be hit.
class EntryDelegate final : public QStyledItemDelegate
{
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        return QStyledItemDelegate::sizeHint(option, index).expandedTo({0, kEntryPx});
    }
};

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
                number->setLocale(formLocale());  // with the decimal sign of that language
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
    if (auto* number = qobject_cast<QAbstractSpinBox*>(input))
        number->setLocale(formLocale());
    auto* filter = new FormFilter(input);
    input->installEventFilter(filter);
    for (auto* line : input->findChildren<QLineEdit*>())
        line->installEventFilter(filter);
}

QDoubleSpinBox* numberInput(double low, double high, int decimals, const QString& unit, const QString& name,
                            QWidget* parent)
{
    auto* made = new NumberInput(parent);
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
    // A list below, as high as its entries: Fusion's menu in its place cuts the last one off behind an arrow.
    made->setStyleSheet(QStringLiteral("combobox-popup: 0"));
    made->setItemDelegate(new EntryDelegate(made));
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
