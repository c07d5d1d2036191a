// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/practice/LessonStrip.h"

#include <utility>

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "ui/kit/Accessibility.h"
#include "ui/kit/LineIcon.h"
#include "ui/kit/TabularDigitsLabel.h"
#include "ui/kit/Theme.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/LessonTexts.h"
#include "ui/text/Texts.h"

namespace ui::practice {
namespace {

using namespace ui::kit;

constexpr double kSecondsAMinute = 60.0;
constexpr double kSoonS = 60.0;
constexpr double kSomeMm3 = 0.01;        ///< more than the bur removes by accident
constexpr double kDecayLeftMost = 0.01;  ///< share of the lesion that may be left

using core::guidance::Landmark;

/// Returns for each value of lessons::Reached, in their order, whether it has been reached.
std::array<bool, ::lessons::kReachedCount> reachedOn(const core::terrain::PerMaterial& wholeMm3,
                                                     const core::terrain::PerMaterial& removedMm3, bool isDeep)
{
    constexpr auto kCaries = static_cast<std::size_t>(core::terrain::Material::Caries);
    constexpr auto kDentin = static_cast<std::size_t>(core::terrain::Material::Dentin);
    const double decay = wholeMm3[kCaries];
    return {removedMm3[kCaries] > kSomeMm3, removedMm3[kDentin] > kSomeMm3,
            decay > 0.0 && decay - removedMm3[kCaries] <= kDecayLeftMost * decay, isDeep};
}

QString landmarkName(Landmark landmark)
{
    switch (landmark) {
    case Landmark::CentralPit:
        return QCoreApplication::translate("Landmark", "central pit");
    case Landmark::MesialPit:
        return QCoreApplication::translate("Landmark", "mesial pit");
    case Landmark::DistalPit:
        return QCoreApplication::translate("Landmark", "distal pit");
    case Landmark::MesialRidge:
        return QCoreApplication::translate("Landmark", "mesial marginal ridge");
    case Landmark::DistalRidge:
        return QCoreApplication::translate("Landmark", "distal marginal ridge");
    case Landmark::RidgesToKeep:
    case Landmark::RidgesToCut:
        break;
    }
    return {};
}

}  // namespace

LessonStrip::LessonStrip(QWidget* parent) : QFrame(parent)
{
    setProperty("kind", "bar");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kSpace4, kSpace1, kSpace4, kSpace1);
    row->setSpacing(kSpace2);
    const auto arrow = [this](const QString& drawing, const char* words) {
        auto* button = new QToolButton(this);
        button->setIcon(lineIcon(drawing, roomPalette()));
        button->setIconSize({16, 16});
        button->setAutoRaise(true);
        text::bindTranslation(button, [button, words] {
            button->setToolTip(tr(words));
            button->setAccessibleName(tr(words));
        });
        button->setFocusPolicy(Qt::TabFocus);
        return button;
    };
    m_before = arrow(QStringLiteral("back"), QT_TR_NOOP("Previous step"));
    m_next = arrow(QStringLiteral("forward"), QT_TR_NOOP("Next step"));
    m_number = new QLabel(this);
    m_number->setForegroundRole(QPalette::PlaceholderText);
    m_text = new QLabel(this);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    m_text->setFont(typeface(kBody, QFont::Medium));
    m_text->setObjectName(QStringLiteral("lessonStep"));
    // Reserves two lines, so that the tooth does not move when a longer step is shown.
    m_text->setMinimumHeight(m_text->fontMetrics().size(0, QStringLiteral("M\nM")).height());
    m_hint = new QPushButton(this);
    text::bindTranslation(m_hint, [this] { m_hint->setText(tr("Hint")); });
    m_hint->setProperty("kind", "segment");
    m_hint->setCheckable(true);
    text::bindTranslation(m_hint, [this] { m_hint->setToolTip(tr("Show a hint for this step")); });
    m_hint->setFocusPolicy(Qt::TabFocus);
    m_hint->setObjectName(QStringLiteral("lessonHint"));
    m_time = new TabularDigitsLabel(this);
    m_time->setFont(typeface(kTitle, QFont::Medium));
    m_time->setObjectName(QStringLiteral("lessonTime"));
    row->addWidget(m_before);
    row->addWidget(m_number);
    row->addWidget(m_next);
    row->addSpacing(kSpace2);
    row->addWidget(m_text, 1);
    row->addWidget(m_hint);
    row->addSpacing(kSpace4);
    row->addWidget(m_time);
    connect(m_before, &QToolButton::clicked, this, [this] { goTo(m_step - 1); });
    connect(m_next, &QToolButton::clicked, this, [this] { goTo(m_step + 1); });
    connect(m_hint, &QPushButton::clicked, this, [this] {
        showStep();
        announce(*m_text);
    });
    text::bindTranslation(this, [this] {
        showStep();
        setTime(m_workedS);
    });
}

void LessonStrip::setLesson(const ::lessons::Lesson& lesson)
{
    m_lesson = lesson;
    m_isPractice = false;
    m_step = 0;
    m_reached = {};
    m_isConcluded = false;
    m_hint->setChecked(false);
    showStep();
    setTime(0.0);
}

void LessonStrip::setPractice()
{
    ::lessons::Lesson practice;
    practice.steps.resize(2);
    practice.steps.front().doneWhen = ::lessons::Reached::DecayRemoved;
    setLesson(practice);
    m_isPractice = true;
    showStep();
}

void LessonStrip::markPlaces(tooth::ExerciseMarks& marks, const core::terrain::ToothAnatomy& tooth,
                             const std::vector<float>& ideal) const
{
    if (m_lesson.steps.empty() || !m_lesson.steps[m_step].mark)
        return;
    for (const auto& [landmark, placeMm] : core::guidance::findLandmark(*m_lesson.steps[m_step].mark, tooth, ideal))
        marks.points.push_back({placeMm, 0.0, false, landmarkName(landmark)});
}

void LessonStrip::follow(const core::terrain::PerMaterial& wholeMm3, const core::terrain::PerMaterial& removedMm3,
                         bool isDeep)
{
    auto reached = reachedOn(wholeMm3, removedMm3, isDeep);
    if (std::exchange(m_reached, reached) == reached || m_isConcluded)
        return;
    std::size_t step = m_step;
    while (step + 1 < m_lesson.steps.size() && m_lesson.steps[step].doneWhen &&
           reached.at(static_cast<std::size_t>(*m_lesson.steps[step].doneWhen))) {
        // The depth has been reached in one place. The next step that asks for depth is about another place.
        reached.at(static_cast<std::size_t>(::lessons::Reached::Depth)) = false;
        ++step;
    }
    if (step != m_step)
        goTo(step);
}

QString LessonStrip::stepWords() const
{
    if (!m_isPractice)
        return m_lesson.steps.empty() ? text::said(m_lesson.goal) : text::said(m_lesson.steps[m_step].text);
    return m_step == 0 ? tr("Remove the brown decay. Stop when the floor is firm dentin.")
                       : tr("The decay is out. Press G for the score.");
}

/// Goes to a step. The hint of each step is hidden at first.
void LessonStrip::goTo(std::size_t step)
{
    m_step = step;
    m_hint->setChecked(false);
    showStep();
    announce(*m_text);
}

void LessonStrip::showStep()
{
    const std::size_t count = m_isConcluded ? 0 : m_lesson.steps.size();
    for (QWidget* part :
         {static_cast<QWidget*>(m_before), static_cast<QWidget*>(m_next), static_cast<QWidget*>(m_number)})
        part->setVisible(count > 1);
    // At the first and the last step one arrow is disabled. If it has the focus, the other arrow takes it.
    const bool hadKeys = m_before->hasFocus() || m_next->hasFocus();
    m_before->setEnabled(m_step > 0);
    m_next->setEnabled(m_step + 1 < count);
    if (hadKeys && !m_before->hasFocus() && !m_next->hasFocus())
        (m_before->isEnabled() ? m_before : m_next)->setFocus();
    //: A step of the work, and how many there are
    m_number->setText(tr("%1 of %2").arg(m_step + 1).arg(count));
    const bool hasHint = count > 0 && !m_lesson.steps[m_step].hint.empty();
    m_hint->setVisible(hasHint);
    const bool showsHint = hasHint && m_hint->isChecked();
    const QString over =
        m_ending == Ending::Refused ? text::begunElsewhereWords()
        : m_mayBeginAgain
            ? tr("The exam is over and cutting is disabled. Press G for the score or R for another attempt.")
            : tr("The exam is over and cutting is disabled. Press G for the score.");
    m_text->setText(showsHint ? text::said(m_lesson.steps[m_step].hint) : m_isConcluded ? over : stepWords());
    m_text->setToolTip(m_isPractice ? QString()
                                    : QStringLiteral("<p>%1</p>").arg(text::said(m_lesson.goal).toHtmlEscaped()));
    for (QWidget* control :
         {static_cast<QWidget*>(m_before), static_cast<QWidget*>(m_next), static_cast<QWidget*>(m_hint)})
        control->setAccessibleDescription(m_text->text());
    emit stepShown();
}

void LessonStrip::setMayBeginAgain(bool may)
{
    if (std::exchange(m_mayBeginAgain, may) != may)
        showStep();
}

void LessonStrip::conclude(Ending ending)
{
    m_isConcluded = true;
    m_ending = ending;
    showStep();
}

void LessonStrip::setTime(double workedS)
{
    m_workedS = workedS;
    if (m_isConcluded)
        return;
    const double limitS = m_lesson.minutes * kSecondsAMinute;
    if (limitS <= 0.0) {
        m_time->setText(text::duration(workedS));
        m_time->setToolTip(tr("Working time"));
        return;
    }
    const double leftS = limitS - workedS;
    const Tones tone = tones(roomPalette());
    m_time->setText(leftS >= 0.0    ? text::duration(leftS)
                    : m_lesson.exam ? text::duration(0.0)
                                    : QChar(0x2212) + text::duration(-leftS));
    m_time->setColour(leftS < 0.0 ? tone.harmText : leftS < kSoonS ? tone.attentionText : QColor());
    m_time->setToolTip(tr("Remaining time of %1").arg(text::timeWords(m_lesson)));
}

}  // namespace ui::practice
