// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/FormInputs.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPointer>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStyledItemDelegate>
#include <QTimer>

#include "ui/kit/Accessibility.h"
#include "ui/kit/Theme.h"

namespace ui::kit {
namespace {

using namespace ui::kit;

constexpr int kEntryPx = 24;
constexpr int kNotePx = 280;
constexpr int kNoteMs = 8000;

struct Words
{
    Q_DECLARE_TR_FUNCTIONS(ui::kit::FormInputs)
};

/// Returns the locale of the window's language without group separators.
QLocale formLocale()
{
    QLocale locale;
    locale.setNumberOptions(locale.numberOptions() | QLocale::OmitGroupSeparator | QLocale::RejectGroupSeparator);
    return locale;
}

/// A number input in which a point and a comma are both decimal signs in every language: 0.25 typed in German is a
/// quarter. A number beyond the range can be typed, but neither it nor a part of it becomes the value: 99 is not read
/// as 9. The value does not change, and a note below explains why.
class NumberInput final : public QDoubleSpinBox
{
public:
    explicit NumberInput(QWidget* parent) : QDoubleSpinBox(parent)
    {
        // Emitted before the typed text becomes the value. textChanged is emitted after that.
        connect(lineEdit(), &QLineEdit::textEdited, this, [this] {
            if (!std::exchange(m_isTyping, true))
                m_before = value();
            m_isTaking = true;
        });
        connect(lineEdit(), &QLineEdit::textChanged, this, &NumberInput::weigh);
        connect(this, &QDoubleSpinBox::valueChanged, this, [this] {
            if (!m_isTaking && value() != m_before)
                forgetTyping();
        });
        connect(this, &QDoubleSpinBox::editingFinished, this, [this] {
            m_isTyping = false;
            if (std::exchange(m_isRefused, false))
                //: %1: a number that was there before another was typed
                note(rangeSentence() + u' ' + Words::tr("%1 stays.").arg(text()));
        });
    }
    ~NumberInput() override { delete m_note; }

    QValidator::State validate(QString& text, int& at) const override
    {
        const qsizetype end = text.size() - (text.endsWith(suffix()) ? suffix().size() : 0);
        QString number = text.left(end);
        for (const char sign : {'.', ','})
            number.replace(QLatin1Char(sign), locale().decimalPoint());
        text.replace(0, end, number);
        const auto typed = typedIn(text);
        const bool isHalf = typed && decimals() == 0 && number.contains(locale().decimalPoint());
        return isHalf || (typed && !fits(*typed)) ? QValidator::Intermediate : QDoubleSpinBox::validate(text, at);
    }

protected:
    void focusOutEvent(QFocusEvent* event) override
    {
        if (m_isRefused)
            interpretText();
        QDoubleSpinBox::focusOutEvent(event);
    }

    void hideEvent(QHideEvent* event) override
    {
        if (m_note)
            m_note->deleteLater();  // not at once: QWidget may be iterating over its children
        QDoubleSpinBox::hideEvent(event);
    }

private:
    /// Returns the typed number, or nothing if the text is not a number yet.
    [[nodiscard]] std::optional<double> typedIn(const QString& text) const
    {
        const QString number = (text.endsWith(suffix()) ? text.chopped(suffix().size()) : text).trimmed();
        const bool isPlain = std::all_of(number.begin(), number.end(), [this](QChar c) {
            return c.isDigit() || c == u'-' || locale().decimalPoint() == c;
        });
        bool isNumber = false;
        const double typed = locale().toDouble(number, &isNumber);
        return isPlain && isNumber ? std::optional(typed) : std::nullopt;
    }

    [[nodiscard]] bool fits(double typed) const
    {
        return typed >= minimum() && typed <= maximum() && (decimals() > 0 || typed == std::floor(typed));
    }

    /// Checks the typed text. Refuses a number that does not fit, and explains why if more digits cannot make it fit.
    void weigh()
    {
        m_isTaking = false;
        const bool isTyping = m_isTyping;
        const QString text = lineEdit()->text();
        const auto typed = typedIn(text);
        delete m_note;
        m_isRefused = false;
        if (!isTyping || !typed || fits(*typed))
            return;
        const int at = lineEdit()->cursorPosition();
        setValue(m_before);
        m_isTyping = true;
        m_isRefused = true;
        const QSignalBlocker quiet(lineEdit());
        lineEdit()->setText(text);
        lineEdit()->setCursorPosition(at);
        // A number that is too close to 0 may fit after more digits, as the 1 of 15. One that is too far from 0 cannot.
        const bool mayYetFit = (*typed >= 0.0 && *typed < minimum()) || (*typed <= 0.0 && *typed > maximum());
        if (!mayYetFit)
            note(rangeSentence());
    }

    /// Ends the check of typed text after the value was set otherwise, for example by the arrow buttons.
    void forgetTyping()
    {
        m_isTyping = false;
        m_isRefused = false;
        delete m_note;
    }

    [[nodiscard]] QString rangeSentence() const
    {
        const QString low = locale().toString(minimum(), 'f', QLocale::FloatingPointShortest);
        const QString high = locale().toString(maximum(), 'f', QLocale::FloatingPointShortest) + suffix();
        //: %1 and %2: the least and the greatest number, %2 with a unit
        return decimals() == 0 ? Words::tr("Only whole numbers from %1 to %2 can be entered here.").arg(low, high)
                               : Words::tr("Only %1 to %2 can be entered here.").arg(low, high);
    }

    /// Shows a note over the widgets below for a while, because forms have no room for it.
    void note(const QString& words)
    {
        if (!m_note) {
            m_note = faultLabel(window());
            m_note->setObjectName(QStringLiteral("numberNote"));
            m_note->setAutoFillBackground(true);
            m_note->setBackgroundRole(QPalette::Base);
            m_note->setFrameShape(QFrame::StyledPanel);
            m_note->setMargin(kSpace2);
            m_note->setFixedWidth(kNotePx);
            m_note->setTextFormat(Qt::PlainText);
        }
        showFault(m_note, words);
        m_note->adjustSize();
        const QWidget& whole = *window();
        const QPoint beside = mapTo(&whole, QPoint(width() + kSpace1, 0));
        const QPoint below = mapTo(&whole, QPoint(0, height() + kSpace1));
        const bool hasRoom = below.y() + m_note->height() <= whole.height();
        if (beside.x() + m_note->width() <= whole.width() && beside.y() + m_note->height() <= whole.height())
            m_note->move(beside);
        else
            m_note->move(std::clamp(below.x(), 0, std::max(0, whole.width() - m_note->width())),
                         hasRoom ? below.y() : below.y() - height() - 2 * kSpace1 - m_note->height());
        m_note->raise();
        announce(*m_note);
        QTimer::singleShot(kNoteMs, m_note, [shown = m_note, words] {
            if (shown && shown->text().endsWith(words))
                shown->deleteLater();
        });
    }

    double m_before = 0.0;  ///< the value when typing began
    bool m_isTyping = false;
    bool m_isTaking = false;   ///< the text is being changed just now
    bool m_isRefused = false;  ///< the present text was refused
    QPointer<QLabel> m_note;
};

/// Paints the entries of a list, high enough to click.
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
                number->setLocale(formLocale());  // uses the decimal sign of that language
        if (event->type() == QEvent::Wheel && !static_cast<QWidget*>(watched)->hasFocus()) {
            event->ignore();
            return true;
        }
        return QObject::eventFilter(watched, event);
    }
};

class CountInput final : public QSpinBox
{
public:
    using QSpinBox::QSpinBox;
    QValidator::State validate(QString& text, int& at) const override
    {
        const QValidator::State state = QSpinBox::validate(text, at);
        const qsizetype begin = text.startsWith(prefix()) ? prefix().size() : 0;
        const qsizetype end = text.size() - (text.endsWith(suffix()) ? suffix().size() : 0);
        const QString number = text.mid(begin, end - begin).trimmed();
        const bool isNumber = std::all_of(number.begin(), number.end(), [](QChar c) { return c.isDigit(); });
        return state == QValidator::Invalid && isNumber ? QValidator::Intermediate : state;
    }
};

}  // namespace

void showNumber(QDoubleSpinBox& input, double number)
{
    if (std::abs(input.value() - number) >= 0.5 * std::pow(10.0, -input.decimals()))
        input.setValue(number);
}

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

/// Shows an error with a warning sign before the text, so that it is not marked by colour alone.
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

QSpinBox* countInput(int low, int high, QWidget* parent)
{
    auto* input = new CountInput(parent);
    input->setRange(low, high);
    input->setKeyboardTracking(false);  // otherwise typing 9999 would set 9 and 99 as well
    bindToForm(input);
    return input;
}

QComboBox* choiceInput(const QString& name, QWidget* parent)
{
    auto* made = new QComboBox(parent);
    // Shows a list below the field, as high as its entries. Fusion's menu in its place would hide the last one behind
    // an arrow.
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

}  // namespace ui::kit
