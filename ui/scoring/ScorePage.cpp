// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoring/ScorePage.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <QCoreApplication>
#include <QEvent>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/kit/Accessibility.h"
#include "ui/kit/Actions.h"
#include "ui/kit/LineIcon.h"
#include "ui/kit/ScoreBar.h"
#include "ui/kit/ScrollPane.h"
#include "ui/kit/TabularDigitsLabel.h"
#include "ui/kit/Theme.h"
#include "ui/scoring/AdviceWords.h"
#include "ui/scoring/CommentsPanel.h"
#include "ui/scoring/ConductNotes.h"
#include "ui/scoring/CriterionRow.h"
#include "ui/scoring/HeatMap.h"
#include "ui/scoring/ScoreCard.h"
#include "ui/scoring/ScoreHistory.h"
#include "ui/scoring/ScoreLabels.h"
#include "ui/scoring/ScoreWords.h"
#include "ui/scoring/WorstSection.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/LessonTexts.h"
#include "ui/text/PeopleTexts.h"
#include "ui/text/PresetTexts.h"
#include "ui/text/Texts.h"

namespace ui::scoring {
namespace {

using namespace ui::kit;
using namespace ui::scoring;

constexpr int kWidestPx = 1720;
constexpr int kNarrowestBesidePx = 1180;
constexpr int kFormMarginPx = 48;        ///< margin around a form scrolled into view; larger than the fading edge
constexpr int kPictureBelowPx = 320;     ///< height of a picture alone in its rows
constexpr int kPictureBesidePx = 260;    ///< height of a picture on a page that scrolls anyway
constexpr std::size_t kFewCriteria = 5;  ///< number of criteria that leave room for the history below them

QFrame* cardIn(QWidget* parent)
{
    auto* frame = new QFrame(parent);
    frame->setProperty("kind", "card");
    return frame;
}

/// Returns whether a measure is horizontal: a wall, a ridge, an isthmus, the depth of a box. The depth of the cut there
/// says nothing about it.
bool isAcross(std::string_view measure)
{
    return measure.starts_with("wall_") || measure.starts_with("ridge_") || measure.starts_with("oblique_") ||
           measure.starts_with("axial_") || measure.starts_with("isthmus_");
}

}  // namespace

ScorePage::ScorePage(const Actions& actions, QWidget* parent) : Page(actions, parent)
{
    m_block = new QWidget(this);
    m_block->setMaximumWidth(kWidestPx);
    m_block->installEventFilter(this);
    m_cards = new QGridLayout(m_block);
    m_cards->setContentsMargins(0, 0, 0, 0);
    m_cards->setSpacing(kSpace4);
    m_resultCard = makeResult();
    m_criteriaCard = makeCriteria();
    m_placeCard = makePlace();
    m_talkCard = makeTalk();
    m_historyCard = new ScoreHistory(this);
    connect(m_historyCard, &ScoreHistory::keepRequested, this, &ScorePage::keepRequested);
    connect(m_historyCard, &ScoreHistory::told, this,
            [this](const QString& sentence) { say([sentence] { return sentence; }); });
    const auto colour = [this](bool distinct) {
        m_heat->setColours(distinct ? render::Palette::Distinct : render::Palette::Natural);
        m_section->setColours(distinct ? render::Palette::Distinct : render::Palette::Natural);
    };
    colour(actions.distinctColours->isChecked());
    connect(actions.distinctColours, &QAction::toggled, this, colour);
    arrange();

    auto* content = new QWidget(this);
    auto* row = new QHBoxLayout(content);
    row->setContentsMargins(kSpace2, 0, kSpace2, 0);
    row->addStretch(1);
    row->addWidget(m_block, 1000);
    row->addStretch(1);
    m_scroll = new ScrollPane(content, QPalette::Window, this);
    body()->addWidget(m_scroll, 1);
    connect(m_heat, &HeatMap::pinned, this,
            [this](const std::optional<std::array<double, 3>>& place) { m_talk->setPlace(place, true); });
    connect(m_talk, &CommentsPanel::placeRequested, this, &ScorePage::showPin);
    connect(m_talk, &CommentsPanel::formUsed, this, [this](QWidget* form) {
        m_formInUse = form;
        showForm();
    });

    makeButtons(actions);
    body()->addLayout(m_buttons);
    text::bindTranslation(this, [this] {
        retranslateUi();
        updateSaying();
    });
}

/// Makes the row of buttons below the cards.
void ScorePage::makeButtons(const Actions& actions)
{
    m_buttons = new QHBoxLayout;
    m_buttons->setSpacing(kSpace2);
    m_said = scoreLabel({}, kSmall, QFont::Normal, QPalette::PlaceholderText, this);
    m_said->setObjectName(QStringLiteral("scoreSaid"));
    fold(m_said);
    m_said->setContentsMargins(kSpace4, 0, 0, 0);
    m_buttons->addWidget(m_said, 1);
    m_buttons->addWidget(makeReport());
    m_replay = new QPushButton(this);
    m_replay->setObjectName(QStringLiteral("replayScored"));
    m_replay->setAutoDefault(true);
    text::bindTranslation(m_replay, [this] {
        m_replay->setText(tr("Replay"));
        m_replay->setAccessibleName(tr("Replay this attempt"));
    });
    m_replay->hide();
    connect(m_replay, &QPushButton::clicked, this, &ScorePage::replayRequested);
    m_buttons->addWidget(m_replay);
    m_ofTheTable = {pageButton(actions.saveRecording, "", this), pageButton(actions.reload, "", this)};
    for (QPushButton* button : m_ofTheTable)
        m_buttons->addWidget(button);
    m_back = pageButton(actions.back, "filled", this);
    m_buttons->addWidget(m_back);
    m_next = new QPushButton(this);
    m_next->setObjectName(QStringLiteral("nextLesson"));
    m_next->setProperty("kind", "filled");
    m_next->setAutoDefault(true);
    text::bindTranslation(m_next, [this] {
        m_next->setText(tr("Next lesson"));
        m_next->setAccessibleName(m_next->text());
        m_next->setToolTip(text::said(m_nextTitle));
    });
    m_next->hide();
    connect(m_next, &QPushButton::clicked, this, &ScorePage::nextRequested);
    m_buttons->addWidget(m_next);
}

void ScorePage::arrange()
{
    const bool beside = width() >= kNarrowestBesidePx && m_scored;
    for (QWidget* card : {m_resultCard, m_criteriaCard, m_placeCard, static_cast<QWidget*>(m_historyCard), m_talkCard})
        m_cards->removeWidget(card);
    m_cards->addWidget(m_resultCard, 0, 0, 1, 2);
    if (beside && m_talks) {
        // The picture is above the comments, because teachers point at a place in it while they write.
        m_cards->addWidget(m_criteriaCard, 1, 0);
        m_cards->addWidget(m_placeCard, 1, 1);
        m_cards->addWidget(m_historyCard, 2, 0, Qt::AlignTop);
        m_cards->addWidget(m_talkCard, 2, 1);
    } else if (beside) {
        // The pictures take the height that is left beside the criteria, or beside a few criteria and the history.
        const bool areFew = m_criterionCount <= kFewCriteria;
        m_cards->addWidget(m_criteriaCard, 1, 0, areFew ? 1 : 2, 1);
        m_cards->addWidget(m_placeCard, 1, 1, areFew ? 2 : 1, 1);
        m_cards->addWidget(m_historyCard, 2, areFew ? 0 : 1);
    } else {
        m_cards->addWidget(m_criteriaCard, 1, 0, 1, 2);
        m_cards->addWidget(m_placeCard, 2, 0, 1, 2);
        m_cards->addWidget(m_historyCard, 3, 0, 1, 2);
    }
    if (!beside || !m_talks)
        m_cards->addWidget(m_talkCard, 4, 0, 1, 2);
    m_talkCard->setVisible(m_talks);
    m_placeCard->setVisible(m_scored.has_value());
    for (QWidget* picture : {static_cast<QWidget*>(m_heat), static_cast<QWidget*>(m_section)})
        picture->setMinimumHeight(!beside ? kPictureBelowPx : m_talks ? kPictureBesidePx : 0);
    m_cards->setColumnStretch(0, beside ? 4 : 1);
    m_cards->setColumnStretch(1, beside ? 5 : 0);
    m_cards->setRowStretch(1, beside ? 1 : 0);
}

void ScorePage::resizeEvent(QResizeEvent* event)
{
    Page::resizeEvent(event);
    arrange();
}

/// Lets the page scroll by keys while one of the buttons below it has the focus.
void ScorePage::keyPressEvent(QKeyEvent* event)
{
    const bool turns = event->key() == Qt::Key_PageDown || event->key() == Qt::Key_PageUp;
    if (turns && event->modifiers() == Qt::NoModifier)
        QCoreApplication::sendEvent(m_scroll, event);
    else
        Page::keyPressEvent(event);
}

/// Aligns the buttons with the right edge of the cards, which leave room for a scroll bar.
bool ScorePage::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_block && (event->type() == QEvent::Resize || event->type() == QEvent::Move)) {
        const int end = m_block->mapTo(this, QPoint(m_block->width(), 0)).x();
        m_buttons->setContentsMargins(0, 0, std::max(0, body()->contentsRect().right() + 1 - end), 0);
        if (m_formInUse != nullptr && m_formInUse->isAncestorOf(window()->focusWidget()))
            showForm();  // new comments of other users have moved the form
    }
    return Page::eventFilter(watched, event);
}

void ScorePage::showEvent(QShowEvent* event)
{
    Page::showEvent(event);
    (m_next->isHidden() ? m_back : m_next)->setFocus();
}

void ScorePage::setNext(const ::lessons::Lesson* lesson)
{
    const bool isOffered = lesson != nullptr && m_sheet.passed();
    if (isOffered) {
        m_nextTitle = lesson->title;
        m_next->setToolTip(text::said(m_nextTitle));
    }
    m_next->setVisible(isOffered);
    m_back->setVisible(!isOffered);
}

/// Makes the line with the result: points, pass or fail, distance to the pass mark, and prediction.
QWidget* ScorePage::makeResult()
{
    QFrame* frame = cardIn(this);
    auto* row = new QHBoxLayout(frame);
    row->setContentsMargins(kSpace6, kSpace2, kSpace6, kSpace2);
    row->setSpacing(2 * kSpace6);
    m_total = new TabularDigitsLabel(frame);
    m_total->setFont(typeface(kHero, QFont::DemiBold));
    m_total->setObjectName(QStringLiteral("total"));
    row->addWidget(m_total);

    auto* verdictColumn = new QVBoxLayout;
    verdictColumn->setSpacing(kSpace2);
    auto* verdict = new QHBoxLayout;
    verdict->setSpacing(kSpace2);
    m_verdictIcon = new QLabel(frame);
    m_verdict = scoreLabel({}, kTitle, QFont::DemiBold, QPalette::WindowText, frame);
    m_verdict->setObjectName(QStringLiteral("verdict"));
    verdict->addWidget(m_verdictIcon);
    verdict->addWidget(m_verdict, 1);
    verdictColumn->addStretch(1);
    verdictColumn->addLayout(verdict);
    m_bar = new ScoreBar(frame);
    verdictColumn->addWidget(m_bar);
    verdictColumn->addStretch(1);
    row->addLayout(verdictColumn, 2);

    auto* words = new QVBoxLayout;
    words->setSpacing(kSpace1);
    m_expected = scoreLabel({}, kBody, QFont::Normal, QPalette::WindowText, frame);
    fold(m_expected);
    m_expected->setObjectName(QStringLiteral("expectation"));
    words->addStretch(1);
    m_doubt = scoreLabel({}, kBody, QFont::Normal, QPalette::WindowText, frame);
    fold(m_doubt);
    m_doubt->setObjectName(QStringLiteral("doubt"));
    m_doubt->hide();
    words->addWidget(m_doubt);
    words->addWidget(makeAdvice());
    words->addWidget(m_expected);
    m_unrecorded = scoreLabel({}, kBody, QFont::Normal, QPalette::WindowText, frame);
    fold(m_unrecorded);
    m_unrecorded->setObjectName(QStringLiteral("unrecorded"));
    m_unrecorded->hide();
    words->addWidget(m_unrecorded);
    words->addStretch(1);
    row->addLayout(words, 3);
    return frame;
}

QWidget* ScorePage::makeCriteria()
{
    QFrame* frame = cardIn(this);
    auto* column = new QVBoxLayout(frame);
    column->setContentsMargins(kSpace4, kSpace4, kSpace4, kSpace4);
    column->setSpacing(kSpace2);
    QLabel* title = scoreLabel({}, kBody, QFont::DemiBold, QPalette::WindowText, frame);
    text::bindTranslation(title, [title] { title->setText(tr("Lost points")); });
    title->setContentsMargins(kSpace2, 0, 0, 0);
    column->addWidget(title);
    m_criteriaSlot = new QVBoxLayout;
    column->addLayout(m_criteriaSlot);

    m_looking = new QWidget(frame);
    auto* looking = new QVBoxLayout(m_looking);
    looking->setContentsMargins(kSpace2, 0, kSpace2, 0);
    looking->setSpacing(kSpace1);
    QLabel* finding = scoreLabel({}, kSmall, QFont::Normal, QPalette::PlaceholderText, m_looking);
    looking->addWidget(finding);
    m_progress = new QProgressBar(m_looking);
    m_progress->setTextVisible(false);
    text::bindTranslation(finding, [this, finding] {
        finding->setText(tr("Finding the moment of each lost point …"));
        m_progress->setAccessibleName(tr("Finding the moment of each lost point"));
    });
    looking->addWidget(m_progress);
    m_looking->hide();
    column->addWidget(m_looking);

    column->addStretch(1);
    column->addWidget(line(frame));
    m_presetWarning = scoreLabel({}, kSmall, QFont::Normal, QPalette::WindowText, frame);
    fold(m_presetWarning);
    m_presetWarning->setContentsMargins(kSpace2, 0, kSpace2, 0);
    m_presetWarning->setObjectName(QStringLiteral("presetWarning"));
    column->addWidget(m_presetWarning);
    m_detailsButton = new QToolButton(frame);
    m_detailsButton->setObjectName(QStringLiteral("scoreDetails"));
    m_detailsButton->setCheckable(true);
    m_detailsButton->setAutoRaise(true);
    m_detailsButton->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    text::bindTranslation(m_detailsButton, [this] {
        m_detailsButton->setText(tr("Details"));
        m_detailsButton->setToolTip(tr("How the points add up, and by which rules"));
    });
    connect(m_detailsButton, &QToolButton::toggled, this, &ScorePage::showDetails);
    column->addWidget(m_detailsButton, 0, Qt::AlignLeft);
    column->addWidget(makeDetails());
    showDetails(false);
    return frame;
}

/// Makes the box with the most important advice and a button that shows it.
QWidget* ScorePage::makeAdvice()
{
    m_adviceBox = new QWidget(this);
    auto* column = new QVBoxLayout(m_adviceBox);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace1);
    QLabel* title = scoreLabel({}, kSmall, QFont::DemiBold, QPalette::PlaceholderText, m_adviceBox);
    text::bindTranslation(title, [title] { title->setText(tr("Next time")); });
    column->addWidget(title);
    m_advice = scoreLabel({}, kBody, QFont::Medium, QPalette::WindowText, m_adviceBox);
    m_advice->setObjectName(QStringLiteral("advice"));
    fold(m_advice);
    column->addWidget(m_advice);
    m_showMoment = new QPushButton(m_adviceBox);
    m_showMoment->setObjectName(QStringLiteral("showMoment"));
    m_showMoment->setProperty("kind", "chip");
    m_showMoment->setFont(typeface(kSmall, QFont::Medium));
    m_showMoment->setAutoDefault(true);
    text::bindTranslation(m_showMoment,
                          [this] { m_showMoment->setAccessibleName(tr("Show the moment in the replay")); });
    connect(m_showMoment, &QPushButton::clicked, this, [this] { emit momentRequested(m_adviceAtS); });
    column->addWidget(m_showMoment, 0, Qt::AlignLeft);
    return m_adviceBox;
}

/// Makes the collapsible part: how the points add up, the rubric, and the score on other grids.
QWidget* ScorePage::makeDetails()
{
    auto* box = new QWidget(this);
    m_details = box;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace1);
    m_sum = scoreLabel({}, kSmall, QFont::DemiBold, QPalette::WindowText, box);
    fold(m_sum);
    m_sum->setAlignment(Qt::AlignRight);
    m_sum->setContentsMargins(kSpace2, 0, kSpace2, 0);
    m_sum->setObjectName(QStringLiteral("sum"));
    column->addWidget(m_sum);
    m_rubric = scoreLabel({}, kSmall, QFont::Normal, QPalette::PlaceholderText, box);
    fold(m_rubric);
    m_rubric->setContentsMargins(kSpace2, 0, kSpace2, 0);
    m_rubric->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_rubric->setObjectName(QStringLiteral("rubric"));
    column->addWidget(m_rubric);
    m_noise = scoreLabel({}, kSmall, QFont::Normal, QPalette::WindowText, box);
    fold(m_noise);
    m_noise->setAlignment(Qt::AlignRight);
    m_noise->setContentsMargins(kSpace2, 0, kSpace2, 0);
    m_noise->setObjectName(QStringLiteral("noise"));
    column->addWidget(m_noise);
    return box;
}

void ScorePage::showDetails(bool shown)
{
    m_details->setVisible(shown);
    m_detailsButton->setArrowType(shown ? Qt::DownArrow : Qt::RightArrow);
    for (CriterionRow* row : m_rows)
        row->setDetailed(shown);
}

QWidget* ScorePage::makePlace()
{
    QFrame* frame = cardIn(this);
    auto* column = new QVBoxLayout(frame);
    column->setContentsMargins(kSpace4, kSpace4, kSpace4, kSpace4);
    column->setSpacing(kSpace2);
    m_place = scoreLabel({}, kBody, QFont::DemiBold, QPalette::WindowText, frame);
    fold(m_place);
    m_place->setObjectName(QStringLiteral("place"));
    column->addWidget(m_place);
    m_placeAdvice = scoreLabel({}, kBody, QFont::Normal, QPalette::WindowText, frame);
    fold(m_placeAdvice);
    m_placeAdvice->setObjectName(QStringLiteral("placeAdvice"));
    m_placeAdvice->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_placeAdvice->setMinimumHeight(2 * m_placeAdvice->fontMetrics().lineSpacing());  // keeps the pictures in place
    column->addWidget(m_placeAdvice);
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpace2);
    m_heat = new HeatMap(frame);
    m_section = new WorstSection(frame);
    row->addWidget(m_heat, 1);
    row->addWidget(m_section, 1);
    column->addLayout(row, 1);
    m_conduct = new ConductNotes(frame);
    connect(m_conduct, &ConductNotes::momentRequested, this, &ScorePage::momentRequested);
    column->addWidget(m_conduct);
    return frame;
}

QWidget* ScorePage::makeTalk()
{
    QFrame* frame = cardIn(this);
    auto* column = new QVBoxLayout(frame);
    column->setContentsMargins(kSpace6, kSpace4, kSpace6, kSpace4);
    m_talk = new CommentsPanel(frame);
    column->addWidget(m_talk);
    frame->hide();
    return frame;
}

QWidget* ScorePage::makeReport()
{
    auto* button = new QToolButton(this);
    button->setObjectName(QStringLiteral("scoreReport"));
    button->setProperty("kind", "chooser");
    button->setPopupMode(QToolButton::InstantPopup);
    button->setToolButtonStyle(Qt::ToolButtonTextOnly);
    button->setMinimumHeight(36);
    auto* menu = new QMenu(button);
    QAction* pdf = menu->addAction(QString(), this, &ScorePage::pdfRequested);
    QAction* print = menu->addAction(QString(), this, &ScorePage::printRequested);
    button->setMenu(menu);
    text::bindTranslation(button, [button, menu, pdf, print] {
        button->setText(tr("Report"));
        button->setAccessibleName(tr("Save or print the score card"));
        menu->setAccessibleName(button->accessibleName());
        pdf->setText(tr("Save as PDF …"));
        print->setText(tr("Print …"));
    });
    return button;
}

ScoreCard ScorePage::card() const
{
    ScoreCard made;
    made.lesson = m_work();
    made.sheet = m_sheet;
    made.work = m_scored;
    made.moments = m_moments;
    made.history = m_history;
    return made;
}

void ScorePage::say(std::function<QString()> words)
{
    m_saying = std::move(words);
    updateSaying();
    if (!m_said->text().isEmpty())
        announce(*m_said);
}

void ScorePage::updateSaying()
{
    m_said->setText(m_saying ? m_saying() : QString());
    m_said->setToolTip(m_said->text());
}

void ScorePage::setScore(std::function<QString()> work, const ::lessons::ScoreSheet& sheet,
                         const QList<database::AttemptRecord>& history, const std::optional<ScorePrediction>& expected,
                         const std::optional<ScoredWork>& scored)
{
    m_work = std::move(work);
    m_person.clear();
    m_given = history.isEmpty() ? std::nullopt : history.front().givenTenths;
    m_sheet = sheet;
    m_expectation = expected;
    m_isShown = true;
    setNext(nullptr);
    say({});
    m_noiseNow.reset();
    m_historyCard->setClass({});
    m_moments.clear();
    m_criterionCount = sheet.criteria.size();
    m_scored = scored;
    m_heat->setPin({});
    if (m_scored) {
        m_heat->setWork(*m_scored);
        m_section->setWork(*m_scored);
    }
    setMomentsProgress({});
    m_history = history;
    m_historyCard->setKeeping(history.isEmpty() ? Keeping::Nowhere : Keeping::Kept);
    m_chosen.clear();
    retranslateUi();
    m_scroll->verticalScrollBar()->setValue(0);
}

void ScorePage::setPerson(const QString& fullName)
{
    m_person = fullName;
    retranslateUi();
}

void ScorePage::setGiven(std::optional<int> tenths)
{
    if (m_given == tenths)
        return;
    m_given = tenths;
    if (!m_history.isEmpty())
        m_history.front().givenTenths = tenths;
    retranslateUi();
}

QString ScorePage::verdictWords(const ::lessons::ScoreSheet& sheet, std::optional<int> givenTenths,
                                database::Doubt doubt)
{
    if (givenTenths)
        return *givenTenths >= sheet.passMarkTenths ? tr("Passed (teacher's decision)")
                                                    : tr("Not passed (teacher's decision)");
    if (doubt != database::Doubt::None)
        return tr("Does not count");
    if (sheet.passed())
        return tr("Passed");
    const std::optional<int> limit = sheet.limitTenths();
    if (!limit || *limit > sheet.totalTenths)
        return tr("Not passed yet");
    //: %1: points of a score
    return *limit > 0 ? tr("Not passed: limited to %1").arg(text::points(*limit)) : tr("Not passed: critical error");
}

QString ScorePage::sumWords(const ::lessons::ScoreSheet& sheet, std::optional<int> givenTenths)
{
    const QString sum = text::scoreSum(sheet);
    //: %1: a sum of points
    return givenTenths ? tr("Automatic score: %1").arg(sum) : sum;
}

/// Shows everything about the score in the current language.
void ScorePage::retranslateUi()
{
    if (!m_isShown) {
        setTitle(tr("Grade"));
        return;
    }
    //: %1 is a lesson, "Tooth 36" or a file name
    //: %1 is a person, %2 a lesson
    setTitle(m_person.isEmpty() ? tr("Grade: %1").arg(m_work()) : tr("Grade of %1: %2").arg(m_person, m_work()));
    const int total = m_given.value_or(m_sheet.totalTenths);
    m_expected->setVisible(m_expectation.has_value());
    if (m_expectation && !m_person.isEmpty())
        m_expected->setText(tr("The student expected %1 points.").arg(text::points(m_expectation->tenths)));
    else if (m_expectation)
        m_expected->setText(
            (expectationWords(m_expectation->tenths, total) + u' ' + expectedWorstWords(m_expectation->worst, m_sheet))
                .trimmed());
    QString how = m_sheet.rubricId.empty() ? QString() : rubricWords(m_sheet);
    QString preset;
    if (m_scored && m_scored->preset)
        //: %1 is a hardness preset with its version
        preset = tr("Drilled with the hardness preset %1.").arg(text::presetWords(*m_scored->preset));
    // A student who made the tooth softer must not appear to have a better hand.
    const bool isOtherFeel = m_scored && m_scored->preset && m_scored->preset->isChanged;
    m_presetWarning->setVisible(isOtherFeel);
    m_presetWarning->setText(QStringLiteral("⚠ ") + preset);
    if (!isOtherFeel && !preset.isEmpty())
        how += u' ' + preset;
    m_rubric->setText(how);
    m_total->setText(text::points(total), tr("of 100"));
    updateVerdict();
    m_bar->setScore(total, m_sheet.passMarkTenths);
    m_conduct->setVisible(m_scored && m_scored->measured.process);
    if (m_scored && m_scored->measured.process)
        m_conduct->setConduct(*m_scored->measured.process, m_scored->infractions, m_scored->aids);
    arrange();
    fillCriteria();
    updateNoise();
    updateUnrecorded();
    updateHistory();
}

/// Shows whether the attempt has passed, or why it does not count.
void ScorePage::updateVerdict()
{
    const database::Doubt doubt = m_history.isEmpty() ? database::Doubt::None : m_history.front().doubt;
    const bool isInDoubt = doubt != database::Doubt::None && !m_given;
    m_doubt->setVisible(isInDoubt);
    m_doubt->setText(QStringLiteral("⚠ ") + text::doubtWords(doubt));
    const bool passed = m_given ? *m_given >= m_sheet.passMarkTenths : m_sheet.passed() && !isInDoubt;
    m_verdict->setText(verdictWords(m_sheet, m_given, doubt));
    const Tones tone = tones(palette());
    m_verdictIcon->setPixmap(linePixmap(passed ? QStringLiteral("check") : QStringLiteral("cross"),
                                        passed                       ? tone.accent
                                        : m_sheet.failedCritically() ? tone.harm
                                                                     : tone.attention,
                                        26, devicePixelRatioF()));
}

/// Says that an old attempt has no recording. The current attempt can always be shown.
void ScorePage::updateUnrecorded()
{
    m_unrecorded->setVisible(m_talks && !m_scored);
    m_unrecorded->setText(tr("This attempt has no readable recording. It cannot be replayed, and the tooth is not "
                             "shown. The score and the lost points are shown as they were saved."));
}

void ScorePage::setNoise(const ::lessons::GridSensitivity& noise)
{
    m_noiseNow = noise;
    updateNoise();
}

void ScorePage::updateNoise()
{
    m_noise->setVisible(m_noiseNow.has_value());
    if (!m_noiseNow)
        return;
    const ::lessons::GridSensitivity& noise = *m_noiseNow;
    const QString half = text::points(noise.half.totalTenths);
    m_noise->setText(noise.isUncertain() ? tr("Result is close to the pass mark.")
                                         : tr("Result is clear of the pass mark."));
    const QString sums = noise.twice
                             //: %1 and %2 are points; the grid is that on which the tooth is measured
                             ? tr("Score at half the grid: %1, at double the grid: %2.")
                                   .arg(half, text::points(noise.twice->totalTenths))
                             : tr("Score at half the grid: %1.").arg(half);
    m_noise->setToolTip(brokenIntoLines(
        sums + u' ' +
        tr("The tooth is measured again with half and with double the number of grid columns. The result is clear of "
           "the pass mark if all scores lie on the same side of it. This says nothing about another attempt.")));
    QPalette colours = palette();
    if (noise.isUncertain())
        colours.setColor(QPalette::WindowText, tones(palette()).attentionText);
    m_noise->setPalette(colours);
}

void ScorePage::setMomentsProgress(std::optional<double> share)
{
    m_looking->setVisible(share.has_value());
    if (share)
        m_progress->setValue(static_cast<int>(std::lround(100.0 * *share)));
}

void ScorePage::setMoments(const std::vector<std::vector<::lessons::Moment>>& moments)
{
    setMomentsProgress({});
    m_moments = moments;
    updateMoments();
}

void ScorePage::updateMoments()
{
    for (qsizetype k = 0; k < std::min(m_rows.size(), static_cast<qsizetype>(m_moments.size())); ++k)
        m_rows[k]->setMoments(m_moments[static_cast<std::size_t>(k)]);
    updateAdvice();
}

void ScorePage::updateAdvice()
{
    const auto all = ::lessons::adviceOn(m_sheet, m_scored ? m_scored->measured : core::grading::Measured{}, m_moments);
    const auto ofChosen = std::find_if(all.begin(), all.end(), [this](const ::lessons::Advice& advice) {
        return m_sheet.criteria[advice.criterion].id == m_chosen;
    });
    m_placeAdvice->setText(ofChosen == all.end() ? QString()
                                                 : adviceWords(*ofChosen, m_sheet.criteria[ofChosen->criterion]));
    m_adviceBox->setVisible(m_scored && !all.empty());
    if (all.empty())
        return;
    const ::lessons::Advice& first = all.front();
    m_advice->setText(adviceWords(first, m_sheet.criteria[first.criterion]));
    // Something that was never done has no moment. The pictures show where it is missing.
    const bool hasMoment = first.moment && first.moment->kind != ::lessons::Moment::Kind::Never;
    m_showMoment->setVisible(hasMoment);
    if (!hasMoment)
        return;
    m_adviceAtS = first.moment->seconds;
    //: %1: minutes and seconds of the attempt
    m_showMoment->setText(tr("Show it at %1").arg(text::duration(std::floor(m_adviceAtS))));
}

void ScorePage::fillCriteria()
{
    delete m_criteria;
    m_rows.clear();
    m_criteria = new QWidget(this);
    auto* column = new QVBoxLayout(m_criteria);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    const auto advice =
        ::lessons::adviceOn(m_sheet, m_scored ? m_scored->measured : core::grading::Measured{}, m_moments);
    const std::string& advised = advice.empty() ? m_chosen : m_sheet.criteria[advice.front().criterion].id;
    CriterionRow* chosen = nullptr;
    for (const ::lessons::Criterion& criterion : m_sheet.criteria) {
        auto* row = new CriterionRow(criterion, m_sheet.verdict, m_criteria);
        connect(row, &CriterionRow::momentRequested, this, &ScorePage::momentRequested);
        connect(row, &CriterionRow::toggled, this, [this, row](bool on) {
            if (on)
                showPlace(*row);
        });
        if (!m_scored)
            row->bePlain();
        column->addWidget(row);
        m_rows << row;
        // Selects the criterion that the user looked at, otherwise the one that the advice is about.
        if (chosen == nullptr || criterion.id == m_chosen ||
            (chosen->criterion().id != m_chosen && criterion.id == advised))
            chosen = row;
    }
    m_criteriaSlot->addWidget(m_criteria);
    m_sum->setText(sumWords(m_sheet, m_given));
    updateMoments();
    showDetails(m_detailsButton->isChecked());
    if (chosen != nullptr)
        chosen->setChecked(true);
}

/// Shows the worst place for a criterion, with advice. If the criterion has no place, shows the largest deviation from
/// the ideal.
void ScorePage::showPlace(const CriterionRow& row)
{
    m_chosen = row.criterion().id;
    updateAdvice();
    const auto measure = core::grading::findMeasure(row.criterion().measure);
    const auto own = measure ? measure->nodeIn(m_scored->measured) : std::nullopt;
    const auto& practised = m_scored->measured.practised;
    // Shows the place that an exercise left undone. What was cut on the way is about the tooth, not the exercise.
    const bool isDoing = practised && (!measure || core::grading::isOfExercise(*measure));
    const auto node = own ? own : isDoing ? missedNode(*m_scored) : practised ? std::nullopt : farthestOff(*m_scored);
    const QString name = text::criterionName(row.criterion());
    const bool isMet = row.criterion().lostTenths == 0 && !(row.criterion().share > 0.0);
    if (practised && !own) {
        const QString done = isDoing ? practisedWords(*m_scored) : QString();
        m_place->setText(done.isEmpty() ? tr("%1 has no place on the tooth").arg(name) : done);
    } else if (isMet) {
        //: %1 a criterion of a score
        m_place->setText(tr("%1: no points lost").arg(name));
    } else if (!node) {
        m_place->setText(tr("No deviation from the ideal"));
    } else {
        const double above = static_cast<double>(aboveIdeal(*m_scored, *node));
        const QString mm = text::number(std::abs(above), 2);
        const QString off = above < 0.0 ? tr("%1 mm too deep").arg(mm) : tr("%1 mm still to cut").arg(mm);
        //: %1 a criterion of a score
        m_place->setText(own && isAcross(measure->id) ? tr("%1: worst place").arg(name)
                         //: %1 a criterion of a score, %2 the deviation from the ideal there: "0.42 mm too deep"
                         : own ? tr("%1: worst place, %2").arg(name, off)
                               //: The same for a criterion like time, which has no place on the tooth
                               : tr("%1 has no place on the tooth; largest deviation: %2").arg(name, off));
    }
    const core::imaging::SectionPlane plane =
        node ? planeThrough(*m_scored, *node) : core::imaging::SectionPlane{m_scored->tooth->grid().middleMm(), 0.0};
    m_heat->setAccessibleDescription(m_place->text());
    m_heat->setMark(node, plane);
    m_section->setMark(node, plane);
}

void ScorePage::setClass(const ::lessons::ClassStanding& standing)
{
    m_historyCard->setClass(standing);
}

void ScorePage::setHistory(const QList<database::AttemptRecord>& history)
{
    m_history = history;
    if (m_isShown)
        updateVerdict();
    updateHistory();
}

void ScorePage::updateHistory()
{
    const QString work = m_work ? m_work() : QString();
    m_historyCard->setHistory(m_history, m_sheet,
                              m_person.isEmpty() ? work : QStringLiteral("%1, %2").arg(m_person, work));
}

void ScorePage::setTalkVisible(bool visible)
{
    for (QPushButton* button : m_ofTheTable)
        button->setVisible(!visible);
    m_talks = visible;
    m_replay->setVisible(visible && m_scored);
    m_talk->setRecorded(m_scored.has_value());
    updateUnrecorded();
    if (!visible)
        setMayTalk(false);
    arrange();
}

/// Scrolls to the form after it has been laid out, with a margin for the fading edge.
void ScorePage::showForm()
{
    QTimer::singleShot(0, m_formInUse, [this] { m_scroll->ensureWidgetVisible(m_formInUse, 0, kFormMarginPx); });
}

void ScorePage::showTalk()
{
    QTimer::singleShot(0, this, [this] {
        const QPoint corner = m_talkCard->mapTo(m_scroll->widget(), QPoint(0, 0));
        m_scroll->verticalScrollBar()->setValue(corner.y());
    });
}

void ScorePage::setMayTalk(bool may)
{
    m_talk->setMay(may, may);
    m_heat->setPinnable(may);
    m_heat->setPin(may ? m_talk->place() : std::nullopt);
}

/// Shows the place of a comment. Offers it as the place of the next comment as well.
void ScorePage::showPin(const std::optional<std::array<double, 3>>& placeMm)
{
    m_heat->setPin(placeMm);
    m_talk->setPlace(placeMm);
    m_scroll->ensureWidgetVisible(m_heat);
}

void ScorePage::setKeeping(Keeping keeping)
{
    m_historyCard->setKeeping(keeping);
}

}  // namespace ui::scoring
