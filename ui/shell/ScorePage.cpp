// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/ScorePage.h"

#include <algorithm>
#include <cstdlib>

#include <QDateTime>
#include <QFrame>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/shell/Actions.h"
#include "ui/shell/HistoryChart.h"
#include "ui/shell/LineIcon.h"
#include "ui/shell/PictureFrame.h"
#include "ui/shell/ScoreBar.h"
#include "ui/shell/ScrollPane.h"
#include "ui/shell/TabularLabel.h"
#include "ui/shell/Theme.h"
#include "ui/text/Texts.h"

namespace ui::shell {
namespace {

constexpr int kResultWidthPx = 320;
constexpr int kWidestPx = 1160;
constexpr int kNarrowestBesidePx = 940;
constexpr qsizetype kListed = 5;
constexpr std::size_t kShownHash = 12;
constexpr qsizetype kCharted = 12;

QFrame* card(QWidget* parent)
{
    auto* frame = new QFrame(parent);
    frame->setProperty("kind", "card");
    return frame;
}

QLabel* label(const QString& words, int size, QFont::Weight weight, QPalette::ColorRole role, QWidget* parent)
{
    auto* made = new QLabel(words, parent);
    made->setFont(typeface(size, weight));
    made->setForegroundRole(role);
    return made;
}

QString signedPoints(int lostTenths)
{
    return lostTenths == 0 ? QStringLiteral("0") : QChar(0x2212) + text::points(lostTenths);
}

QString expectation(int expectedTenths, int totalTenths)
{
    const int gap = expectedTenths - totalTenths;
    const QString expected = text::points(expectedTenths);
    if (gap == 0)
        return ScorePage::tr("You expected %1 points: exactly so.").arg(expected);
    return (gap > 0 ? ScorePage::tr("You expected %1 points: %2 too many.")
                    : ScorePage::tr("You expected %1 points: %2 too few."))
        .arg(expected, text::points(std::abs(gap)));
}

/// Which rule marked, so that nobody need guess: name, version and the beginning of the hash.
QString rubricWords(const lessons::ScoreSheet& sheet)
{
    const QString name = QString::fromStdString(lessons::inLanguage(sheet.rubricTitle, QLocale().name().toStdString()));
    //: %1 is the name of a rubric, %2 its version, %3 the beginning of its hash
    return ScorePage::tr("Marked by \"%1\", version %2, content %3. Undercuts and walls past 90° are not measured: the "
                         "model is a height field.")
        .arg(name)
        .arg(sheet.rubricVersion)
        .arg(QString::fromStdString(sheet.rubricHash.substr(0, kShownHash)));
}

}  // namespace

ScorePage::ScorePage(const Actions& actions, QWidget* parent) : Page(actions, tr("Grade"), parent)
{
    auto* block = new QWidget(this);
    block->setMaximumWidth(kWidestPx);
    m_cards = new QGridLayout(block);
    m_cards->setContentsMargins(0, 0, 0, 0);
    m_cards->setSpacing(kSpace4);
    m_cards->setColumnStretch(1, 1);
    m_resultCard = makeResult();
    m_criteriaCard = makeCriteria();
    m_historyCard = makeHistory();
    arrange(true);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(kSpace2);
    buttons->addStretch(1);
    buttons->addWidget(pageButton(actions.saveRecording, "", this));
    buttons->addWidget(pageButton(actions.reload, "", this));
    m_back = pageButton(actions.back, "filled", this);
    buttons->addWidget(m_back);
    m_cards->addLayout(buttons, 3, 0, 1, 2);

    auto* content = new QWidget(this);
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(kSpace6, 0, kSpace6, kSpace2);
    column->addStretch(1);
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(block, 1000);
    row->addStretch(1);
    column->addLayout(row);
    column->addStretch(2);

    body()->addWidget(new ScrollPane(content, QPalette::Window, this), 1);
}

void ScorePage::arrange(bool beside)
{
    for (QWidget* card : {m_resultCard, m_criteriaCard, m_historyCard})
        m_cards->removeWidget(card);
    if (beside) {
        m_cards->addWidget(m_resultCard, 0, 0, 2, 1);
        m_cards->addWidget(m_criteriaCard, 0, 1);
        m_cards->addWidget(m_historyCard, 1, 1);
    } else {
        m_cards->addWidget(m_resultCard, 0, 0, 1, 2);
        m_cards->addWidget(m_criteriaCard, 1, 0, 1, 2);
        m_cards->addWidget(m_historyCard, 2, 0, 1, 2);
    }
    m_cards->setRowStretch(1, beside ? 1 : 0);
    m_result->setDirection(beside ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    m_resultCard->setMinimumWidth(beside ? kResultWidthPx : 0);
    m_resultCard->setMaximumWidth(beside ? kResultWidthPx : QWIDGETSIZE_MAX);
}

void ScorePage::resizeEvent(QResizeEvent* event)
{
    Page::resizeEvent(event);
    arrange(width() >= kNarrowestBesidePx);
}

void ScorePage::showEvent(QShowEvent* event)
{
    Page::showEvent(event);
    m_back->setFocus();
}

QWidget* ScorePage::makeResult()
{
    QFrame* frame = card(this);
    m_result = new QBoxLayout(QBoxLayout::TopToBottom, frame);
    m_result->setContentsMargins(kSpace6, kSpace4, kSpace6, kSpace6);
    m_result->setSpacing(kSpace4);
    auto* column = new QVBoxLayout;
    column->setSpacing(kSpace2);
    m_result->addLayout(column);

    m_total = new TabularLabel(frame);
    m_total->setFont(typeface(kHero, QFont::DemiBold));
    m_total->setObjectName(QStringLiteral("total"));
    column->addWidget(m_total);

    auto* verdict = new QHBoxLayout;
    verdict->setSpacing(kSpace2);
    m_verdictIcon = new QLabel(frame);
    m_verdict = label({}, kTitle, QFont::DemiBold, QPalette::WindowText, frame);
    m_verdict->setWordWrap(true);
    m_verdict->setObjectName(QStringLiteral("verdict"));
    verdict->addWidget(m_verdictIcon);
    verdict->addWidget(m_verdict, 1);
    column->addLayout(verdict);
    column->addSpacing(kSpace2);
    m_bar = new ScoreBar(frame);
    column->addWidget(m_bar);
    m_expected = label({}, kBody, QFont::Normal, QPalette::WindowText, frame);
    m_expected->setWordWrap(true);
    m_expected->setObjectName(QStringLiteral("expectation"));
    column->addWidget(m_expected);
    column->addStretch(1);
    m_picture = new PictureFrame(frame);
    m_picture->setAccessibleName(tr("Picture of the tooth as graded"));
    m_result->addWidget(m_picture, 1);
    return frame;
}

QWidget* ScorePage::makeCriteria()
{
    QFrame* frame = card(this);
    auto* column = new QVBoxLayout(frame);
    column->setContentsMargins(kSpace6, kSpace4, kSpace6, kSpace4);
    column->setSpacing(kSpace2);
    column->addWidget(label(tr("How the grade was worked out"), kBody, QFont::DemiBold, QPalette::WindowText, frame));
    m_criteriaSlot = new QVBoxLayout;
    column->addLayout(m_criteriaSlot);
    column->addWidget(line(frame));
    auto* sum = new QHBoxLayout;
    sum->addWidget(label(tr("Sum"), kBody, QFont::DemiBold, QPalette::WindowText, frame));
    sum->addStretch(1);
    m_sum = label({}, kTitle, QFont::DemiBold, QPalette::WindowText, frame);
    m_sum->setObjectName(QStringLiteral("sum"));
    sum->addWidget(m_sum);
    column->addLayout(sum);
    m_rubric = label({}, kSmall, QFont::Normal, QPalette::PlaceholderText, frame);
    m_rubric->setWordWrap(true);
    m_rubric->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_rubric->setObjectName(QStringLiteral("rubric"));
    column->addWidget(m_rubric);
    return frame;
}

QWidget* ScorePage::makeHistory()
{
    QFrame* frame = card(this);
    auto* column = new QVBoxLayout(frame);
    column->setContentsMargins(kSpace6, kSpace4, kSpace6, kSpace4);
    column->setSpacing(kSpace4);
    column->addWidget(label(tr("Grades before"), kBody, QFont::DemiBold, QPalette::WindowText, frame));
    m_remark = label({}, kBody, QFont::Normal, QPalette::PlaceholderText, frame);
    m_remark->setObjectName(QStringLiteral("historyRemark"));
    column->addWidget(m_remark);
    auto* row = new QHBoxLayout;
    row->setSpacing(2 * kSpace6);
    m_chart = new HistoryChart(frame);
    row->addWidget(m_chart, 3);
    m_listSlot = new QVBoxLayout;
    row->addLayout(m_listSlot, 2);
    row->setAlignment(m_listSlot, Qt::AlignTop);
    column->addLayout(row, 1);
    return frame;
}

void ScorePage::setScore(const QString& work, const lessons::ScoreSheet& sheet,
                         const QList<database::AttemptRecord>& history, const QImage& picture,
                         std::optional<int> expectedTenths)
{
    //: %1 is a lesson, "Tooth 36" or a file name
    setTitle(tr("Grade: %1").arg(work));
    m_expected->setVisible(expectedTenths.has_value());
    if (expectedTenths)
        m_expected->setText(expectation(*expectedTenths, sheet.totalTenths));
    m_rubric->setText(rubricWords(sheet));
    const Tones tone = tones(palette());
    m_total->setText(text::points(sheet.totalTenths), tr("of 100"));
    const bool passed = sheet.passed();
    m_verdict->setText(passed                     ? tr("Passed")
                       : sheet.failedCritically() ? tr("Not passed: harm done")
                                                  : tr("Not passed yet"));
    m_verdictIcon->setPixmap(linePixmap(passed ? QStringLiteral("check") : QStringLiteral("cross"),
                                        passed                     ? tone.accent
                                        : sheet.failedCritically() ? tone.harm
                                                                   : tone.attention,
                                        26, devicePixelRatioF()));
    m_bar->setScore(sheet.totalTenths, sheet.passMarkTenths);
    m_picture->setPicture(picture);
    fillCriteria(sheet);
    fillHistory(history, sheet.totalTenths, sheet.passMarkTenths);
}

void ScorePage::fillCriteria(const lessons::ScoreSheet& sheet)
{
    delete m_criteria;
    m_criteria = new QWidget(this);
    auto* grid = new QGridLayout(m_criteria);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kSpace6);
    grid->setVerticalSpacing(kSpace1);
    grid->setColumnStretch(0, 1);
    const Tones tone = tones(palette());
    int row = 0;
    for (const lessons::Criterion& criterion : sheet.criteria) {
        grid->addWidget(line(m_criteria), row++, 0, 1, 3);
        auto* measured = new TabularLabel(m_criteria);
        measured->setFont(typeface(kBody));
        measured->setAlignment(Qt::AlignRight);
        measured->setText(text::criterionMeasured(criterion));
        if (criterion.measure == "sound_overcut_mm3")
            measured->setToolTip(brokenIntoLines(text::soundTissueCounted()));
        if (criterion.measure == "pulp_exposed_mm2")
            measured->setToolTip(
                brokenIntoLines(tr("The area that lies open, seen from above. The volume that was cut away stands "
                                   "beside the tooth, in mm³.")));
        auto* lost = new TabularLabel(m_criteria);
        lost->setFont(typeface(kTitle, QFont::DemiBold));
        lost->setAlignment(Qt::AlignRight);
        lost->setMinimumWidth(48);
        lost->setText(signedPoints(criterion.lostTenths));
        lost->setColour(criterion.lostTenths > 0 ? criterion.critical ? tone.harmText : tone.attentionText
                                                 : palette().color(QPalette::PlaceholderText));
        lost->setObjectName(QStringLiteral("lost_") + QString::fromStdString(criterion.id));
        //: Tooltip on the points of one criterion
        lost->setToolTip(criterion.critical
                             ? tr("Fails the attempt and takes all points that are left")
                             : tr("At most %1 points can be lost here").arg(text::points(criterion.weightTenths)));
        grid->addWidget(label(text::criterionName(criterion), kBody, QFont::Medium, QPalette::WindowText, m_criteria),
                        row, 0);
        grid->addWidget(measured, row, 1);
        grid->addWidget(lost, row, 2, 2, 1, Qt::AlignVCenter | Qt::AlignRight);
        auto* worked = label(text::criterionWorked(criterion, sheet.verdict), kSmall, QFont::Normal,
                             QPalette::PlaceholderText, m_criteria);
        worked->setWordWrap(true);
        worked->setObjectName(QStringLiteral("worked_") + QString::fromStdString(criterion.id));
        grid->addWidget(worked, row + 1, 0, 1, 2);
        grid->setRowMinimumHeight(row + 1, 24);
        row += 2;
    }
    m_criteriaSlot->addWidget(m_criteria);
    m_sum->setText(text::scoreSum(sheet));
}

void ScorePage::fillHistory(const QList<database::AttemptRecord>& history, int total, int passMark)
{
    QList<int> scores;
    for (qsizetype k = std::min(kCharted, history.size()); k > 0; --k)
        scores << history[k - 1].scoreTenths;
    if (scores.isEmpty())
        scores << total;
    m_chart->setScores(scores, passMark);

    delete m_list;
    m_list = new QWidget(this);
    auto* grid = new QGridLayout(m_list);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(kSpace1);
    grid->setColumnStretch(0, 1);
    const QLocale locale;
    for (qsizetype k = 0; k < std::min(kListed, history.size()); ++k) {
        const auto& attempt = history[k];
        const QDateTime when = QDateTime::fromString(QString::fromStdString(attempt.finishedUtc), Qt::ISODate);
        const QString date = when.isValid() ? locale.toString(when.toLocalTime(), QLocale::ShortFormat)
                                            : QString::fromStdString(attempt.finishedUtc);
        auto* score = new TabularLabel(m_list);
        score->setFont(typeface(kBody, k == 0 ? QFont::DemiBold : QFont::Normal));
        score->setAlignment(Qt::AlignRight);
        score->setText(text::points(attempt.scoreTenths));
        const int line = static_cast<int>(k);
        grid->addWidget(
            label(date, kBody, QFont::Normal, k == 0 ? QPalette::WindowText : QPalette::PlaceholderText, m_list), line,
            0);
        grid->addWidget(score, line, 1);
    }
    m_remark->setText(history.isEmpty()     ? tr("Grades are not being kept; this one will not be here next time.")
                      : history.size() == 1 ? tr("This is the first grade here.")
                                            : QString());
    m_remark->setVisible(!m_remark->text().isEmpty());
    m_listSlot->addWidget(m_list);
}

}  // namespace ui::shell
