// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/practice/ExerciseCard.h"
#include "core/servo/ServoState.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include <QAction>
#include <QButtonGroup>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/kit/Accessibility.h"
#include "ui/kit/Actions.h"
#include "ui/kit/TabularDigitsLabel.h"
#include "ui/kit/Theme.h"
#include "ui/practice/HoldGauge.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/Texts.h"

namespace ui::practice {
namespace {

using namespace ui::kit;
using namespace core::grading;
using core::terrain::Material;

constexpr int kWidestCardPx = 760;
constexpr int kNarrowWordsPx = 150;
constexpr std::array kTissues{Material::Enamel, Material::Dentin, Material::Caries};

int idOf(Material material)
{
    return static_cast<int>(material);
}

}  // namespace

QString padName(std::size_t pad)
{
    //: Three pads of a practice block, side by side
    static constexpr std::array kNames{QT_TRANSLATE_NOOP("Pad", "Left"), QT_TRANSLATE_NOOP("Pad", "Middle"),
                                       QT_TRANSLATE_NOOP("Pad", "Right")};
    return QCoreApplication::translate("Pad", kNames.at(pad));
}

ExerciseCard::ExerciseCard(QAction* grade, QWidget* parent) : QFrame(parent)
{
    setProperty("kind", "bar");
    setObjectName(QStringLiteral("exerciseCard"));
    auto* block = new QWidget(this);
    block->setMaximumWidth(kWidestCardPx);
    auto* outer = new QHBoxLayout(this);
    outer->setContentsMargins(kSpace4, kSpace2, kSpace4, kSpace2);
    outer->addWidget(block, 1000);
    outer->addStretch(1);
    auto* row = new QHBoxLayout(block);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kSpace4);
    auto* words = new QVBoxLayout;
    words->setSpacing(kSpace1);
    m_title = new QLabel(block);
    m_title->setFont(typeface(kTitle, QFont::DemiBold));
    m_title->setObjectName(QStringLiteral("exerciseTitle"));
    m_advice = new QLabel(block);
    m_advice->setObjectName(QStringLiteral("exerciseAdvice"));
    words->addStretch(1);
    for (QLabel* line : {m_title, m_advice}) {
        line->setWordWrap(true);
        line->setMinimumWidth(kNarrowWordsPx);
        words->addWidget(line);
    }
    // Reserves two lines for advice, because progress must not move the tooth.
    m_advice->setMinimumHeight(m_advice->fontMetrics().size(0, QStringLiteral("M\nM")).height());
    m_grade = pageButton(grade, "filled", block);
    m_grade->setObjectName(QStringLiteral("exerciseGrade"));
    words->addWidget(m_grade, 0, Qt::AlignLeft);
    words->addStretch(1);
    row->addLayout(words, 1);
    m_hold = makeHold();
    m_choices = makeChoices();
    row->addWidget(m_hold, 1);
    row->addWidget(m_choices);
    text::bindTranslation(this, [this] {
        if (m_practised.index() != m_exercise.index())
            return;  // the exercise has not begun
        sayTruth();
        showProgress();
    });
    hide();
}

QWidget* ExerciseCard::makeHold()
{
    auto* whole = new QWidget(this);
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace1);
    auto* figures = new QHBoxLayout;
    m_force = new TabularDigitsLabel(whole);
    m_force->setFont(typeface(kFigure, QFont::Medium));
    m_force->setObjectName(QStringLiteral("holdForce"));
    m_time = new TabularDigitsLabel(whole);
    m_time->setFont(typeface(kFigure, QFont::Medium));
    m_time->setAlignment(Qt::AlignRight);
    m_time->setObjectName(QStringLiteral("holdTime"));
    figures->addWidget(m_force, 1);
    figures->addWidget(m_time, 1);
    m_gauge = new HoldGauge(whole);
    column->addLayout(figures);
    column->addWidget(m_gauge);
    return whole;
}

QWidget* ExerciseCard::makeChoices()
{
    auto* whole = new QWidget(this);
    auto* names = new QVBoxLayout;
    auto* rows = new QVBoxLayout;
    auto* both = new QHBoxLayout(whole);
    both->setContentsMargins(0, 0, 0, 0);
    both->setSpacing(kSpace2);
    both->addLayout(names);
    both->addLayout(rows);
    for (QVBoxLayout* column : {names, rows})
        column->setSpacing(kSpace1);
    for (std::size_t pad = 0; pad < kPads; ++pad) {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace2);
        rows->addLayout(row);
        auto* name = new QLabel(whole);
        text::bindTranslation(name, [name, pad] { name->setText(padName(pad)); });
        name->setFont(typeface(kBody, QFont::Medium));
        names->addWidget(name);
        m_pads[pad] = new QButtonGroup(whole);
        for (std::size_t k = 0; k < kTissues.size(); ++k) {
            auto* choice = new QPushButton(whole);
            choice->setProperty("kind", "segment");
            choice->setCheckable(true);
            choice->setAutoDefault(false);
            // A click leaves the focus on the tooth view. Tab and the arrow keys reach the choices.
            choice->setFocusPolicy(Qt::TabFocus);
            text::bindTranslation(choice, [choice, pad, k] {
                choice->setText(text::capitalised(text::materialName(kTissues[k])));
                //: %1 is "Left", "Middle" or "Right", %2 a tissue
                choice->setAccessibleName(tr("%1: %2").arg(padName(pad), choice->text()));
                choice->setToolTip(tr("Choose this material for the pad; you can change it until you are graded"));
            });
            choice->setObjectName(QStringLiteral("pad%1%2").arg(pad).arg(idOf(kTissues[k])));
            m_pads[pad]->addButton(choice, idOf(kTissues[k]));
            row->addWidget(choice, 1);
        }
        m_truth[pad] = new QLabel(whole);
        m_truth[pad]->setFont(typeface(kBody, QFont::Medium));
        m_truth[pad]->setObjectName(QStringLiteral("padTruth%1").arg(pad));
        row->addWidget(m_truth[pad], 1);
        connect(m_pads[pad], &QButtonGroup::idClicked, this, [this, pad](int tissue) {
            m_hasChosen = true;
            std::get<Named>(m_practised).saidToBe[pad] = static_cast<Material>(tissue);
            showProgress();
            emit answered(pad, static_cast<Material>(tissue));
        });
    }
    return whole;
}

void ExerciseCard::begin(const Exercise& exercise)
{
    m_exercise = exercise;
    m_isConcluded = false;
    m_hasChosen = false;
    if (const auto* points = std::get_if<PointsToTouch>(&exercise))
        m_practised = Touched{std::vector<std::optional<double>>(points->pointsMm.size())};
    else if (std::holds_alternative<ForceToHold>(exercise))
        m_practised = Held{};
    else
        m_practised = Named{};
    m_hold->setVisible(std::holds_alternative<ForceToHold>(exercise));
    m_choices->setVisible(std::holds_alternative<PadsToName>(exercise));
    if (const auto* hold = std::get_if<ForceToHold>(&exercise))
        m_gauge->setAsked(*hold);
    for (std::size_t pad = 0; pad < kPads; ++pad) {
        m_truth[pad]->hide();
        m_pads[pad]->setExclusive(false);
        for (QAbstractButton* choice : m_pads[pad]->buttons()) {
            choice->setChecked(false);
            choice->setEnabled(true);
            choice->show();
        }
        m_pads[pad]->setExclusive(true);
    }
    m_force->setText(text::number(0.0, 2), QStringLiteral("N"));
    showProgress();
}

void ExerciseCard::setPractised(const Practised& practised)
{
    // An answer is shown as soon as it is given, without waiting for the examiner's result.
    if (practised.index() != m_exercise.index() || m_isConcluded || m_hasChosen)
        return;
    m_practised = practised;
    if (const auto* named = std::get_if<Named>(&practised))
        for (std::size_t pad = 0; pad < kPads; ++pad)
            if (named->saidToBe[pad])
                if (QAbstractButton* choice = m_pads[pad]->button(idOf(*named->saidToBe[pad])))
                    choice->setChecked(true);
    showProgress();
}

void ExerciseCard::setServo(const core::servo::ServoState& servo)
{
    if (std::holds_alternative<ForceToHold>(m_exercise)) {
        const double newtons = servo.touching ? glm::length(servo.forceN) : 0.0;
        m_gauge->setForce(newtons);
        m_force->setText(text::number(newtons, 2), QStringLiteral("N"));
    }
    if (const bool isOn = servo.drillSwitchedOn || servo.drillOn; isOn != m_drillIsOn) {
        m_drillIsOn = isOn;
        showAdvice();
    }
}

void ExerciseCard::conclude()
{
    m_isConcluded = true;
    if (std::holds_alternative<PadsToName>(m_exercise))
        for (QButtonGroup* pad : m_pads)
            // Hides the answers that were not chosen, to make room for the truth.
            for (QAbstractButton* choice : pad->buttons()) {
                choice->setEnabled(false);
                choice->setVisible(choice->isChecked());
            }
    sayTruth();
    showProgress();
}

/// Shows the true tissue of each pad after the work has been graded.
void ExerciseCard::sayTruth()
{
    int widest = 0;
    if (const auto* pads = std::get_if<PadsToName>(&m_exercise); pads != nullptr && m_isConcluded) {
        const Tones tone = tones(palette());
        for (std::size_t pad = 0; pad < kPads; ++pad) {
            const bool isRight = std::get<Named>(m_practised).saidToBe[pad] == pads->madeOf[pad];
            const QString tissue = text::materialName(pads->madeOf[pad]);
            //: Beside what the student took a pad for; %1 is the tissue that it is
            m_truth[pad]->setText(isRight ? tr("✓ right") : tr("✗ it is %1").arg(tissue));
            QPalette colours = palette();
            colours.setColor(QPalette::WindowText, isRight ? palette().color(QPalette::Link) : tone.attentionText);
            m_truth[pad]->setPalette(colours);
            m_truth[pad]->show();
            widest = std::max(widest, m_truth[pad]->sizeHint().width());
        }
        for (QLabel* truth : m_truth)
            truth->setMinimumWidth(widest);
    }
}

void ExerciseCard::showProgress()
{
    const bool isAllDone = isDone(m_practised);
    if (const auto* touched = std::get_if<Touched>(&m_practised)) {
        const auto count = static_cast<int>(touched->count());
        const auto all = static_cast<int>(touched->atS.size());
        m_title->setText(isAllDone ? tr("All %n points touched", nullptr, all)
                                   //: Progress of an exercise: so many points of so many
                                   : tr("%1 of %2 points touched").arg(count).arg(all));
    } else if (const auto* held = std::get_if<Held>(&m_practised)) {
        const auto& asked = std::get<ForceToHold>(m_exercise);
        //: %1 is a time in seconds
        m_title->setText(
            isAllDone ? tr("Held for %1 s").arg(text::number(asked.seconds, 0))
                      //: %1 is a force in newtons, %2 a time in seconds
                      : tr("Hold %1 N for %2 s").arg(text::number(asked.forceN, 1), text::number(asked.seconds, 0)));
        //: Behind the seconds that a force has been held: of how many
        m_time->setText(text::number(isAllDone ? held->longestS : held->nowS, 1),
                        tr("of %1 s").arg(text::number(asked.seconds, 0)));
    } else {
        m_title->setText(m_isConcluded ? tr("The materials of the pads")
                         : isAllDone   ? tr("Every pad has an answer")
                                       : tr("What is each pad made of?"));
    }
    m_grade->setVisible(isAllDone && !m_isConcluded);
    if (accessibleName() != m_title->text()) {
        setAccessibleName(m_title->text());
        announce(*m_title);
    }
    showAdvice();
}

void ExerciseCard::showAdvice()
{
    const bool shallRest = !std::holds_alternative<PadsToName>(m_exercise);
    const bool mustChange = m_drillIsOn == shallRest && !isDone(m_practised);
    QString advice;
    if (m_isConcluded)
        advice = tr("Graded. Press F2 for the next lesson.");
    else if (isDone(m_practised))
        advice = shallRest ? tr("Well done. Press G for your grade.") : tr("Sure? Then press G for your grade.");
    else if (mustChange)
        advice = shallRest ? tr("The bur is turning. Stop it with the space bar: this exercise needs no cutting.")
                           : tr("Start the bur with the space bar: while it is stopped, all three feel the same.");
    else if (const auto* held = std::get_if<Held>(&m_practised); held != nullptr && held->longestS > 0.0)
        //: %1 is a time in seconds
        advice = tr("Longest so far: %1 s").arg(text::number(held->longestS, 1));
    else if (shallRest && std::holds_alternative<Touched>(m_practised))
        advice = tr("Any order. A ring becomes a disc when touched.");
    else if (shallRest)
        advice = tr("Anywhere on the tooth.");
    else
        advice = tr("Press on each for a second, and compare.");
    if (m_advice->text() == advice)
        return;
    m_advice->setText(advice);
    QPalette colours = palette();
    colours.setColor(QPalette::WindowText, mustChange && !m_isConcluded ? tones(palette()).attentionText
                                                                        : palette().color(QPalette::PlaceholderText));
    m_advice->setPalette(colours);
}

}  // namespace ui::practice
