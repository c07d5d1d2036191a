// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/ExerciseCard.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <QAction>
#include <QButtonGroup>
#include <QCoreApplication>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/shell/Actions.h"
#include "ui/shell/TabularLabel.h"
#include "ui/shell/Theme.h"
#include "ui/study/HoldGauge.h"
#include "ui/text/Texts.h"

namespace ui::study {
namespace {

using namespace ui::shell;
using namespace core::grading;
using core::terrain::Material;

constexpr int kWidthPx = 460;
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
    setProperty("kind", "card");
    setObjectName(QStringLiteral("exerciseCard"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpace4, kSpace2, kSpace4, kSpace2);
    column->setSpacing(kSpace2);
    auto* head = new QHBoxLayout;
    head->setSpacing(kSpace4);
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    m_title = new QLabel(this);
    m_title->setFont(typeface(kTitle, QFont::DemiBold));
    m_title->setWordWrap(true);
    m_title->setObjectName(QStringLiteral("exerciseTitle"));
    m_advice = new QLabel(this);
    m_advice->setWordWrap(true);
    m_advice->setObjectName(QStringLiteral("exerciseAdvice"));
    words->addWidget(m_title);
    words->addWidget(m_advice);
    head->addLayout(words, 1);
    m_grade = pageButton(grade, "filled", this);
    m_grade->setObjectName(QStringLiteral("exerciseGrade"));
    head->addWidget(m_grade, 0, Qt::AlignVCenter);
    m_hold = makeHold();
    m_choices = makeChoices();
    column->addLayout(head);
    column->addWidget(m_hold);
    column->addWidget(m_choices);
    hide();
}

QWidget* ExerciseCard::makeHold()
{
    auto* whole = new QWidget(this);
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace1);
    auto* figures = new QHBoxLayout;
    m_force = new TabularLabel(whole);
    m_force->setFont(typeface(kFigure, QFont::Medium));
    m_force->setObjectName(QStringLiteral("holdForce"));
    m_time = new TabularLabel(whole);
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
    auto* grid = new QGridLayout(whole);
    grid->setContentsMargins(0, kSpace1, 0, 0);
    grid->setHorizontalSpacing(kSpace2);
    grid->setVerticalSpacing(kSpace1);
    for (std::size_t pad = 0; pad < kPads; ++pad) {
        const int row = static_cast<int>(pad);
        auto* name = new QLabel(padName(pad), whole);
        name->setFont(typeface(kBody, QFont::Medium));
        grid->addWidget(name, row, 0);
        m_pads[pad] = new QButtonGroup(whole);
        for (std::size_t k = 0; k < kTissues.size(); ++k) {
            const QString tissue = text::capitalised(text::materialName(kTissues[k]));
            auto* choice = new QPushButton(tissue, whole);
            choice->setProperty("kind", "segment");
            choice->setCheckable(true);
            choice->setAutoDefault(false);
            // A click leaves the keys with the bur; Tab and the arrows come here.
            choice->setFocusPolicy(Qt::TabFocus);
            //: %1 is "Left", "Middle" or "Right", %2 a tissue
            choice->setAccessibleName(tr("%1: %2").arg(padName(pad), tissue));
            choice->setToolTip(tr("Say that this pad is made of this; you can change it until you are graded"));
            choice->setObjectName(QStringLiteral("pad%1%2").arg(pad).arg(idOf(kTissues[k])));
            m_pads[pad]->addButton(choice, idOf(kTissues[k]));
            grid->addWidget(choice, row, 1 + static_cast<int>(k));
            grid->setColumnStretch(1 + static_cast<int>(k), 1);
        }
        m_truth[pad] = new QLabel(whole);
        m_truth[pad]->setFont(typeface(kBody, QFont::Medium));
        m_truth[pad]->setObjectName(QStringLiteral("padTruth%1").arg(pad));
        grid->addWidget(m_truth[pad], row, 4);
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
        }
        m_pads[pad]->setExclusive(true);
    }
    m_force->setText(text::number(0.0, 2), QStringLiteral("N"));
    showProgress();
}

void ExerciseCard::setPractised(const Practised& practised)
{
    // An answer is shown when it is given, not only when the examiner has come to it.
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

void ExerciseCard::setServo(const core::session::ServoState& servo)
{
    if (std::holds_alternative<ForceToHold>(m_exercise)) {
        const double newtons = servo.touching ? glm::length(servo.forceN) : 0.0;
        m_gauge->setForce(newtons);
        m_force->setText(text::number(newtons, 2), QStringLiteral("N"));
    }
    if (servo.drillOn != m_drillIsOn) {
        m_drillIsOn = servo.drillOn;
        showAdvice();
    }
}

void ExerciseCard::conclude()
{
    m_isConcluded = true;
    if (const auto* pads = std::get_if<PadsToName>(&m_exercise)) {
        const Tones tone = tones(palette());
        for (std::size_t pad = 0; pad < kPads; ++pad) {
            for (QAbstractButton* choice : m_pads[pad]->buttons())
                choice->setEnabled(false);
            const bool isRight = std::get<Named>(m_practised).saidToBe[pad] == pads->madeOf[pad];
            const QString tissue = text::materialName(pads->madeOf[pad]);
            //: Beside what the student took a pad for; %1 is the tissue that it is
            m_truth[pad]->setText(isRight ? tr("✓ right") : tr("✗ it is %1").arg(tissue));
            QPalette colours = palette();
            colours.setColor(QPalette::WindowText, isRight ? palette().color(QPalette::Link) : tone.attentionText);
            m_truth[pad]->setPalette(colours);
            m_truth[pad]->show();
        }
    }
    showProgress();
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
        m_title->setText(m_isConcluded ? tr("This is what they are made of")
                         : isAllDone   ? tr("Every pad has its name")
                                       : tr("What is each pad made of?"));
    }
    m_grade->setVisible(isAllDone && !m_isConcluded);
    setAccessibleName(m_title->text());
    showAdvice();
}

void ExerciseCard::showAdvice()
{
    const bool shallRest = !std::holds_alternative<PadsToName>(m_exercise);
    const bool mustChange = m_drillIsOn == shallRest && !isDone(m_practised);
    QString advice;
    if (m_isConcluded)
        advice = tr("Graded. F2 leads to the next lesson.");
    else if (isDone(m_practised))
        advice = shallRest ? tr("Well done. See how it is marked.") : tr("Sure? Then see how it is marked.");
    else if (mustChange)
        advice = shallRest ? tr("The bur is turning: stop it with the space bar. Here nothing is to be cut.")
                           : tr("Let the bur turn with the space bar: at rest all three feel the same.");
    else if (const auto* held = std::get_if<Held>(&m_practised); held != nullptr && held->longestS > 0.0)
        //: %1 is a time in seconds
        advice = tr("Longest so far: %1 s").arg(text::number(held->longestS, 1));
    else if (shallRest && std::holds_alternative<Touched>(m_practised))
        advice = tr("Any order. Rings become discs.");
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
    emit changed();
}

void ExerciseCard::placeIn(const QRect& area)
{
    const int width = std::min(kWidthPx, area.width() - 2 * kSpace2);
    layout()->activate();  // words that have just changed may take another line
    resize(width, layout()->totalHeightForWidth(width));
    move(area.center().x() - width / 2, area.bottom() - kSpace2 - height());
}

}  // namespace ui::study
