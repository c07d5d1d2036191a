// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/people/AssignTerms.h"

#include <QAbstractItemView>
#include <QCalendarWidget>
#include <QCheckBox>
#include <QDateEdit>
#include <QEvent>
#include <QFocusEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QSpinBox>
#include <QStringList>
#include <QTimer>
#include <QToolButton>

#include "ui/kit/FormInputs.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/PeopleTexts.h"

namespace ui::people {
namespace {

constexpr int kDaysGiven = 7;  ///< default number of days until the due date
constexpr int kMostAttempts = 99;
constexpr int kInputHighPx = 30;

}  // namespace

AssignTerms::AssignTerms(QWidget* parent)
    : QWidget(parent), m_isDue(new QCheckBox(this)), m_day(new QDateEdit(this)), m_limitWord(new QLabel(this)),
      m_limit(kit::countInput(0, kMostAttempts, this)), m_note(new QLabel(this))
{
    m_isDue->setObjectName(QStringLiteral("isDue"));
    m_isDue->setChecked(true);
    m_day->setObjectName(QStringLiteral("dueDay"));
    m_day->setCalendarPopup(true);
    m_day->installEventFilter(this);
    m_day->setDate(QDate::currentDate().addDays(kDaysGiven));
    m_limit->setObjectName(QStringLiteral("attemptLimit"));
    m_limitWord->setBuddy(m_limit);
    for (QWidget* input : {static_cast<QWidget*>(m_day), static_cast<QWidget*>(m_limit)}) {
        input->setMinimumHeight(kInputHighPx);
        input->setFocusPolicy(Qt::StrongFocus);
    }
    kit::bindToForm(m_day);
    m_note->setObjectName(QStringLiteral("termsNote"));
    m_note->setTextFormat(Qt::PlainText);
    m_note->setFont(kit::typeface(kit::kSmall));
    m_note->setWordWrap(true);
    connect(m_isDue, &QCheckBox::toggled, m_day, &QWidget::setEnabled);
    const auto takeDue = [this] {
        m_isDueChanged = true;
        updateNote();
    };
    connect(m_isDue, &QCheckBox::toggled, this, takeDue);
    connect(m_day, &QDateEdit::dateChanged, this, takeDue);
    connect(m_limit, &QSpinBox::valueChanged, this, [this] { m_isLimitChanged = true; });
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kit::kSpace2);
    grid->setVerticalSpacing(kit::kSpace1);
    grid->addWidget(m_isDue, 0, 0);
    grid->addWidget(m_day, 0, 1);
    grid->addWidget(m_limitWord, 1, 0);
    grid->addWidget(m_limit, 1, 1);
    grid->addWidget(m_note, 2, 0, 1, 2);
    grid->setColumnStretch(1, 1);
    text::bindTranslation(this, [this] { retell(); });
}

void AssignTerms::setTerms(const Terms& terms, int lessons)
{
    const QDate day = text::dueDay(terms.dueUtc);
    m_isDue->setChecked(day.isValid());
    if (day.isValid())
        m_day->setDate(day);
    m_limit->setValue(terms.attemptLimit);
    m_lessons = lessons;
    m_isDueChanged = false;
    m_isLimitChanged = false;
    updateNote();
}

void AssignTerms::reset()
{
    setTerms({text::endOfDay(QDate::currentDate().addDays(kDaysGiven)), 0});
}

AssignTerms::Terms AssignTerms::terms() const
{
    return {m_isDue->isChecked() ? text::endOfDay(m_day->date()) : std::string(), m_limit->value()};
}

AssignTerms::Terms AssignTerms::changed(const Terms& before) const
{
    const Terms now = terms();
    return {m_isDueChanged ? now.dueUtc : before.dueUtc, m_isLimitChanged ? now.attemptLimit : before.attemptLimit};
}

/// Explains terms with consequences that the teacher may not expect.
void AssignTerms::updateNote()
{
    QStringList notes;
    if (m_isDue->isChecked() && m_day->date() < QDate::currentDate())
        notes << tr("This day is over: whoever has not passed is late at once.");
    if (m_lessons > 1)
        notes << tr("Each lesson keeps what you do not change here.");
    m_note->setText(notes.join(u'\n'));
    m_note->setVisible(!notes.isEmpty());
}

void AssignTerms::retell()
{
    //: A date follows
    m_isDue->setText(tr("Due on"));
    m_isDue->setAccessibleName(tr("There is a day when it is due"));
    m_day->setAccessibleName(tr("Day when it is due"));
    m_day->setToolTip(tr("Until the end of this day"));
    m_day->setLocale(QLocale());
    QString format = QLocale().dateFormat(QLocale::ShortFormat);
    if (!format.contains(QStringLiteral("yyyy")))
        format.replace(QStringLiteral("yy"), QStringLiteral("yyyy"));
    m_day->setDisplayFormat(format);
    //: How often a lesson may be tried; a number follows
    m_limitWord->setText(tr("Attempts"));
    m_limit->setAccessibleName(tr("Attempts at most"));
    m_limit->setSpecialValueText(tr("no limit"));
    updateNote();
}

/// Names the months and days of the calendar in the current language.
void AssignTerms::sayCalendar()
{
    QCalendarWidget* calendar = m_day->calendarWidget();
    calendar->setLocale(QLocale());
    calendar->setFirstDayOfWeek(QLocale().firstDayOfWeek());
    calendar->setVerticalHeaderFormat(QCalendarWidget::NoVerticalHeader);
    calendar->setAccessibleName(m_day->accessibleName());
    for (auto* days : calendar->findChildren<QAbstractItemView*>())
        days->setAccessibleName(m_day->accessibleName());
    for (auto* button : calendar->findChildren<QToolButton*>())
        if (button->objectName() == u"qt_calendar_prevmonth")
            button->setAccessibleName(tr("The month before"));
        else if (button->objectName() == u"qt_calendar_nextmonth")
            button->setAccessibleName(tr("The next month"));
}

/// Translates the calendar, which Qt creates when it is first opened. Also lets the user type a whole date, whether
/// they entered the field with the mouse or have selected all of it. Without this the digits would go into the month or
/// year under the pointer.
bool AssignTerms::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::KeyPress)
        sayCalendar();
    const auto fromTheFirst = [this] { m_day->setSelectedSection(m_day->sectionAt(0)); };
    if (event->type() == QEvent::KeyPress) {
        const auto* text = m_day->findChild<QLineEdit*>(QStringLiteral("qt_spinbox_lineedit"));
        const QString typed = dynamic_cast<QKeyEvent*>(event)->text();
        const bool isDigit = !typed.isEmpty() && typed.at(0).isDigit();
        if (isDigit && text->selectedText() == text->text())
            fromTheFirst();
        // After the last digit of a section Qt moves on to the next section by itself. A separator typed then would
        // skip that one.
        if (!isDigit && m_day->currentSectionIndex() > 0 && !typed.isEmpty() && typed.at(0).isPrint() &&
            text->selectedText() == m_day->sectionText(m_day->currentSection()))
            return true;
    }
    if (event->type() == QEvent::FocusIn && dynamic_cast<QFocusEvent*>(event)->reason() == Qt::MouseFocusReason)
        QTimer::singleShot(0, m_day, fromTheFirst);  // after the mouse press that gave the focus
    return QWidget::eventFilter(watched, event);
}

}  // namespace ui::people
