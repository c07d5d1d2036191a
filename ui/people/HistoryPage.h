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

/// All attempts of one person: a list that sorts and filters by lesson, and beside it how the score, the criteria, time
/// and force went. One's own, or a student's, seen by a teacher.
class HistoryPage final : public kit::Page
{
    Q_OBJECT
public:
    HistoryPage(const kit::Actions& actions, QWidget* parent);

    /// Somebody else comes: nobody's attempts are shown.
    void forget();
    /// @param fullName  empty: one's own
    void setPerson(const QString& fullName);
    /// @param newestFirst  of one person. What is chosen stays, where it is among them.
    void setHistory(const QList<database::AttemptRecord>& newestFirst);
    /// Of which of them others have said something. Newer than setHistory().
    void setFeedback(const std::vector<database::Feedback>& feedback);
    /// Exams of that person that were begun, and have no score.
    void setExamsWithoutScore(const QList<database::ExamStart>& newestFirst);
    /// Attempts of that person that wait on this computer until the school can take them.
    void setWaiting(int count);
    void setLessonTitles(const text::LessonTitles& titles);
    /// What criteria are called, by their ids; of the lessons that are known.
    /// @param names  of the criteria of each lesson, by its id
    void setCriterionNames(const std::map<std::string, text::CriterionNames>& names);
    /// Shows one lesson's attempts only; nothing: all.
    void setLesson(const std::optional<std::string>& lessonId);
    /// How the class did at the lesson that is shown. Empty until it is known, and of too few people.
    void setBand(const std::vector<database::BandPoint>& band);
    void setClassMedians(const std::optional<scoring::ClassMedians>& medians);

    /// Asks for them once more: others may have said something of them meanwhile.
    void readAgain() { emit readAgainRequested(); }

    /// Focuses the list of lessons, as this page has no search field.
    [[nodiscard]] bool focusSearch() const override;
    [[nodiscard]] std::optional<std::string> lesson() const;
    /// The chosen attempt; 0: none.
    [[nodiscard]] std::int64_t chosen() const;

signals:
    /// Its score card is to be seen.
    void attemptOpenRequested(qint64 id);
    void replayRequested(qint64 id);
    void readAgainRequested();
    /// A lesson was chosen: its band and medians are wanted. Of all lessons together there are none.
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
    void tellChosen();
    void tellWithoutScore();
    void tellWaiting();

    QString m_person;
    QList<database::AttemptRecord> m_history;
    QList<database::ExamStart> m_startsWithoutScore;
    int m_waiting = 0;
    scoring::ChartedAttempts m_charted;  ///< those of the lesson
    HistoryModel* m_model;
    HistoryFilter* m_filter;
    QStackedWidget* m_stack;
    QComboBox* m_lessons = nullptr;
    QLabel* m_count = nullptr;
    QLabel* m_withoutScore = nullptr;
    QLabel* m_waitingWords = nullptr;
    kit::ListTable* m_table = nullptr;
    std::map<int, int> m_columnPx;  ///< what each needs
    QLabel* m_missing = nullptr;    ///< why the chosen one cannot be opened
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
