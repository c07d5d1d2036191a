// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scoring/ScoreHistory.h"

#include <algorithm>

#include <QDateTime>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/charts/SaveButton.h"
#include "ui/kit/TabularDigitsLabel.h"
#include "ui/kit/Theme.h"
#include "ui/scoring/AttemptCharts.h"
#include "ui/scoring/RecentScoresChart.h"
#include "ui/scoring/ScoreLabels.h"
#include "ui/text/EveryLanguage.h"
#include "ui/text/PeopleTexts.h"
#include "ui/text/Texts.h"

namespace ui::scoring {
namespace {

using namespace ui::kit;

constexpr qsizetype kListed = 4;
constexpr qsizetype kCharted = 12;

}  // namespace

ScoreHistory::ScoreHistory(QWidget* parent) : QFrame(parent)
{
    setProperty("kind", "card");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kSpace4, kSpace4, kSpace4, kSpace4);
    column->setSpacing(kSpace2);
    QLabel* title = scoreLabel({}, kBody, QFont::DemiBold, QPalette::WindowText, this);
    text::bindTranslation(title, [title] { title->setText(tr("Attempts")); });
    column->addWidget(title);
    m_remark = scoreLabel({}, kBody, QFont::Normal, QPalette::PlaceholderText, this);
    m_remark->setObjectName(QStringLiteral("historyRemark"));
    fold(m_remark);
    column->addWidget(m_remark);
    m_keep = new QPushButton(this);
    m_keep->setObjectName(QStringLiteral("keepGrade"));
    m_keep->setAutoDefault(true);
    text::bindTranslation(m_keep, [this] {
        m_keep->setText(tr("Log in and save"));
        m_keep->setAccessibleName(m_keep->text());
    });
    connect(m_keep, &QPushButton::clicked, this, &ScoreHistory::keepRequested);
    column->addWidget(m_keep, 0, Qt::AlignLeft);
    auto* row = new QHBoxLayout;
    row->setSpacing(2 * kSpace6);
    m_chart = new RecentScoresChart(this);
    m_saveChart = new charts::SaveButton([this] { return chart(); }, this);
    m_saveChart->beSmall();
    connect(m_saveChart, &charts::SaveButton::told, this, &ScoreHistory::told);
    auto* chartRow = new QHBoxLayout;
    chartRow->setSpacing(kSpace1);
    chartRow->addWidget(m_chart, 1);
    chartRow->addWidget(m_saveChart, 0, Qt::AlignTop);
    row->addLayout(chartRow, 3);
    // updateHistory() replaces the list while Qt passes a language change on to the card's children, so the list must
    // not be a direct child.
    m_listHolder = new QWidget(this);
    auto* holder = new QVBoxLayout(m_listHolder);
    holder->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_listHolder, 2, Qt::AlignTop);
    column->addLayout(row, 1);
    m_class = scoreLabel({}, kSmall, QFont::Normal, QPalette::PlaceholderText, this);
    m_class->setObjectName(QStringLiteral("class"));
    fold(m_class);
    column->addWidget(m_class);
    text::bindTranslation(this, [this] {
        updateHistory();
        updateClass();
    });
}

void ScoreHistory::setHistory(const QList<database::AttemptRecord>& history, const ::lessons::ScoreSheet& sheet,
                              const QString& of)
{
    m_history = history;
    m_sheet = sheet;
    m_of = of;
    updateHistory();
}

void ScoreHistory::setClass(const std::optional<::lessons::ClassStanding>& standing)
{
    m_standing = standing;
    updateClass();
}

void ScoreHistory::setKeeping(Keeping keeping)
{
    m_keeping = keeping;
    updateKeeping();
}

/// Returns the chart for export: all attempts with their dates.
charts::Chart ScoreHistory::chart() const
{
    ChartedAttempts charted;
    charted.newestFirst = m_history;
    charted.isOneLesson = true;
    charts::Chart chart = scoreChart(charted);
    chart.of = m_of;
    return chart;
}

void ScoreHistory::updateHistory()
{
    const auto isComparable = [&](const database::AttemptRecord& attempt) {
        return attempt.rubricHash == m_sheet.rubricHash;
    };
    QList<RecentScoresChart::Score> scores;
    for (qsizetype k = std::min(kCharted, m_history.size()); k > 0; --k)
        scores << RecentScoresChart::Score{m_history[k - 1].countingTenths(), isComparable(m_history[k - 1]),
                                           text::when(m_history[k - 1].finishedUtc)};
    if (scores.isEmpty())
        scores << RecentScoresChart::Score{m_sheet.totalTenths, true};
    m_chart->setScores(scores, m_sheet.passMarkTenths);
    m_saveChart->setVisible(!m_history.isEmpty());
    m_saveChart->nameIt();

    delete m_list;
    m_list = new QWidget(m_listHolder);
    auto* grid = new QGridLayout(m_list);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(kSpace1);
    grid->setColumnStretch(0, 1);
    const QLocale locale;
    for (qsizetype k = 0; k < std::min(kListed, m_history.size()); ++k) {
        const auto& attempt = m_history[k];
        const QDateTime when = QDateTime::fromString(QString::fromStdString(attempt.finishedUtc), Qt::ISODate);
        const QString date = when.isValid() ? locale.toString(when.toLocalTime(), QLocale::ShortFormat)
                                            : QString::fromStdString(attempt.finishedUtc);
        auto* score = new TabularDigitsLabel(m_list);
        score->setFont(typeface(kBody, k == 0 ? QFont::DemiBold : QFont::Normal));
        score->setAlignment(Qt::AlignRight);
        score->setText(text::points(attempt.countingTenths()));
        const int row = static_cast<int>(k);
        grid->addWidget(
            scoreLabel(date, kBody, QFont::Normal, k == 0 ? QPalette::WindowText : QPalette::PlaceholderText, m_list),
            row, 0);
        if (!isComparable(attempt))
            //: Beside an earlier grade that cannot be compared with this one
            grid->addWidget(scoreLabel(tr("other rubric"), kSmall, QFont::Normal, QPalette::PlaceholderText, m_list),
                            row, 1);
        grid->addWidget(score, row, 2);
    }
    updateKeeping();
    m_listHolder->layout()->addWidget(m_list);
}

void ScoreHistory::updateClass()
{
    m_class->setVisible(m_standing.has_value());
    if (!m_standing)
        return;
    const ::lessons::ClassStanding& standing = *m_standing;
    if (standing.percentBelow)
        //: %1 is a number of per cent
        m_class->setText(tr("Of the best results of %n people in your class, %1 % are below this.", "", standing.people)
                             .arg(text::number(*standing.percentBelow, 0)));
    else if (standing.people <= 1)
        //: %1 is a number of people
        m_class->setText(tr("No comparison with a class: to keep results anonymous it needs %1 people, and yours is "
                            "the only result.")
                             .arg(::lessons::kFewestPeople));
    else
        //: %1 is a number of people
        m_class->setText(tr("No comparison with a class: to keep results anonymous it needs %1 people, and there are "
                            "results of %n person(s).",
                            "", standing.people)
                             .arg(::lessons::kFewestPeople));
}

void ScoreHistory::updateKeeping()
{
    const auto words = [this]() -> QString {
        switch (m_keeping) {
        case Keeping::Nowhere:
            return tr("This grade is not saved and will not be here next time.");
        case Keeping::Refused:
            return tr(
                "This grade is not saved yet. Cusp tries again every few seconds while it runs. Free some disk space.");
        case Keeping::Guest:
            return tr("You are not logged in, so this grade is not saved.");
        case Keeping::Waiting:
            return tr("This grade is saved on this computer. It is sent to the school's database when the connection "
                      "is back.");
        case Keeping::Pending:
            break;
        case Keeping::Kept:
            if (m_history.size() == 1)
                return tr("No earlier grades.");
        }
        return {};
    };
    m_remark->setText(words());
    m_remark->setVisible(!m_remark->text().isEmpty());
    m_keep->setVisible(m_keeping == Keeping::Guest);
}

}  // namespace ui::scoring
