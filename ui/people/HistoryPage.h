// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QList>

#include "database/AttemptRecord.h"
#include "database/ClassOverview.h"
#include "ui/kit/Page.h"
#include "ui/scoring/AttemptCharts.h"

class QButtonGroup;
class QComboBox;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace ui::kit {
class ListTable;
}

namespace ui::charts {
class ChartPanel;
}

namespace ui::people {

class HistoryFilter;
class HistoryModel;

/// All attempts of one person: a list that can be sorted and filtered by lesson, with charts of score, criteria, time
/// and force. Shows the user's own attempts, or those of a student.
class HistoryPage final : public kit::Page
{
    Q_OBJECT
public:
    HistoryPage(const kit::Actions& actions, QWidget* parent);

    /// Resets the page for another user.
    void forget();
    /// @param fullName  empty: the user's own attempts
    void setPerson(const QString& fullName);
    /// Sets the attempts of one person. The selection stays if it is among them.
    void setHistory(const QList<database::AttemptRecord>& newestFirst);
    /// Sets the attempts that other users have commented on. Call after setHistory().
    void setFeedback(const std::vector<database::Feedback>& feedback);
    /// Sets the person's exams that were begun and have no score.
    void setExamsWithoutScore(const QList<database::ExamStart>& newestFirst);
    /// Sets the number of the person's attempts that are stored on this computer until the database can be reached.
    void setWaiting(int count);
    void setLessonTitles(const text::LessonTitles& titles);
    /// Sets the names of criteria.
    /// @param names  of the criteria of each lesson, by lesson id
    void setCriterionNames(const std::map<std::string, text::CriterionNames>& names);
    /// Shows the attempts at one lesson; empty: all.
    void setLesson(const std::optional<std::string>& lessonId);
    /// Sets the band of the class at the selected lesson; empty until it is known, and for too few people.
    void setBand(const std::vector<database::BandPoint>& band);
    void setClassMedians(const std::optional<scoring::ClassMedians>& medians);

    /// Requests the attempts again, because other users may have commented on them.
    void readAgain() { emit readAgainRequested(); }

    /// Sets the focus to the list of lessons, because this page has no search field.
    [[nodiscard]] bool focusSearch() const override;
    [[nodiscard]] std::optional<std::string> lesson() const;
    /// Returns the selected attempt; 0: none.
    [[nodiscard]] std::int64_t chosen() const;

signals:
    /// Emitted when the user requests the score card of an attempt.
    void attemptOpenRequested(qint64 id);
    void replayRequested(qint64 id);
    void readAgainRequested();
    /// Emitted when a lesson was selected and its band and medians are needed. Not emitted for "all lessons".
    void lessonChosen(const QString& id);

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* makeList();
    QWidget* makeCharts();
    QWidget* makeEmpty(const kit::Actions& actions);
    void fillLessons();
    void takeLesson();
    void retell();
    void fitColumns();
    void makeRoom();
    void drawCharts();
    void updateChosen();
    void updateWithoutScore();
    void updateWaiting();

    QString m_person;
    QList<database::AttemptRecord> m_history;
    QList<database::ExamStart> m_startsWithoutScore;
    int m_waiting = 0;
    scoring::ChartedAttempts m_charted;  ///< those of the selected lesson
    HistoryModel* m_model;
    HistoryFilter* m_filter;
    QStackedWidget* m_stack;
    QComboBox* m_lessons = nullptr;
    QLabel* m_count = nullptr;
    QLabel* m_withoutScore = nullptr;
    QLabel* m_waitingWords = nullptr;
    kit::ListTable* m_table = nullptr;
    std::map<int, int> m_columnPx;  ///< the width that each column needs
    QLabel* m_missing = nullptr;    ///< the reason why the selected attempt cannot be opened
    QPushButton* m_open = nullptr;
    QPushButton* m_replay = nullptr;
    QButtonGroup* m_which = nullptr;
    charts::ChartPanel* m_score = nullptr;
    charts::ChartPanel* m_other = nullptr;
    QLabel* m_emptyTitle = nullptr;
    QLabel* m_emptyWords = nullptr;
    QPushButton* m_start = nullptr;
};

}  // namespace ui::people
