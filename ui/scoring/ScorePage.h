// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <QList>

#include "database/AttemptRecord.h"
#include "lessons/ClassStanding.h"
#include "lessons/GridSensitivity.h"
#include "lessons/PointLossTimeline.h"
#include "lessons/ScoreSheet.h"
#include "ui/kit/Page.h"
#include "ui/scoring/ScoreHistory.h"
#include "ui/scoring/ScorePrediction.h"
#include "ui/scoring/ScoredWork.h"

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace ui::kit {
class ScoreBar;
class ScrollPane;
class TabularDigitsLabel;
}  // namespace ui::kit

namespace ui::scoring {

struct ScoreCard;
class CommentsPanel;
class ConductNotes;
class CriterionRow;
class HeatMap;
class WorstSection;

/// Shows a grade and its reasons: the result; the points lost at each criterion, when they were lost, and the formula
/// with its numbers; the work from above, and in a section through the worst place of the selected criterion; the sum;
/// and earlier grades.
class ScorePage final : public kit::Page
{
    Q_OBJECT
public:
    ScorePage(const kit::Actions& actions, QWidget* parent);

    /// @param work     returns the title of the lesson, or the name of the tooth, in the current language
    /// @param history  newest first, including this attempt
    /// @param expected  the student's prediction; empty: the student was not asked
    /// @param scored   the graded tooth; empty: there are no pictures and no replay
    void setScore(std::function<QString()> work, const ::lessons::ScoreSheet& sheet,
                  const QList<database::AttemptRecord>& history, const std::optional<ScorePrediction>& expected,
                  const std::optional<ScoredWork>& scored);
    /// Sets the name of the student, after setScore(); empty: the user's own work.
    void setPerson(const QString& fullName);
    [[nodiscard]] const QString& person() const { return m_person; }
    /// Sets the score that a teacher gave instead of the computed one. Empty: the computed score counts.
    void setGiven(std::optional<int> tenths);
    /// Offers this lesson as the next one after a passed attempt, instead of the back button. Null: no offer.
    /// setScore() removes the offer.
    void setNext(const ::lessons::Lesson* lesson);
    /// Replaces the history passed to setScore() after the database has answered.
    void setHistory(const QList<database::AttemptRecord>& history);
    using Keeping = ScoreHistory::Keeping;
    void setKeeping(Keeping keeping);
    /// Returns the comments panel at the end of the page. It is visible for saved attempts only.
    [[nodiscard]] CommentsPanel& talk() { return *m_talk; }
    /// Returns the result in words, for the page and for print.
    /// @param givenTenths  the score given by a teacher, if any
    /// @param doubt        of the attempt
    [[nodiscard]] static QString verdictWords(const ::lessons::ScoreSheet& sheet, std::optional<int> givenTenths,
                                              database::Doubt doubt);
    /// Returns the sum of the criteria in words. Calls it the computed score if a teacher gave another one.
    [[nodiscard]] static QString sumWords(const ::lessons::ScoreSheet& sheet, std::optional<int> givenTenths);
    /// Returns the contents of the printed card. The caller adds attempt, person, comments and proof.
    [[nodiscard]] ScoreCard card() const;
    /// Shows whether the card was saved or printed.
    void say(std::function<QString()> words);
    void setTalkVisible(bool visible);
    /// Scrolls to the comments after the page has been laid out.
    void showTalk();
    /// Sets whether the user may write comments, pin them to places in the picture, and override the score.
    void setMayTalk(bool may);
    /// Shows the rank of the score within a class.
    void setClass(const ::lessons::ClassStanding& standing);
    /// Shows the score on other grids.
    void setNoise(const ::lessons::GridSensitivity& noise);
    /// Shows the progress of the search for moments, 0 to 1; empty: the search has ended.
    void setMomentsProgress(std::optional<double> share);
    /// Sets the moments of each criterion, in the order of the sheet.
    void setMoments(const std::vector<std::vector<::lessons::Moment>>& moments);

signals:
    /// Emitted when the user requests the card as a PDF, or on paper.
    void pdfRequested();
    void printRequested();
    /// Emitted when the user requests a replay of the attempt from this moment, in seconds.
    void momentRequested(double seconds);
    /// Emitted when the user requests a replay of the attempt from its beginning.
    void replayRequested();
    /// Emitted when the user requests the lesson of setNext().
    void nextRequested();
    /// Emitted when a guest wants to log in so that the grade is saved.
    void keepRequested();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void showForm();
    void makeButtons(const kit::Actions& actions);
    QWidget* makeResult();
    QWidget* makeCriteria();
    QWidget* makeAdvice();
    QWidget* makeDetails();
    QWidget* makePlace();
    QWidget* makeTalk();
    QWidget* makeReport();
    /// Places the criteria beside the pictures, or above them if the page is narrow.
    void arrange();
    void retranslateUi();
    void updateSaying();
    void fillCriteria();
    void showPlace(const CriterionRow& row);
    void showPin(const std::optional<std::array<double, 3>>& placeMm);
    void updateAdvice();
    void showDetails(bool shown);
    void updateNoise();
    void updateVerdict();
    void updateUnrecorded();
    void updateMoments();
    void updateHistory();

    // The data shown, needed again when the language changes.
    bool m_isShown = false;
    std::function<QString()> m_work;
    QString m_person;            ///< empty: the user's own work
    std::optional<int> m_given;  ///< score given by a teacher, tenths of a point
    std::optional<ScorePrediction> m_expectation;
    std::optional<::lessons::GridSensitivity> m_noiseNow;
    std::vector<std::vector<::lessons::Moment>> m_moments;
    QList<database::AttemptRecord> m_history;
    std::string m_chosen;  ///< id of the selected criterion
    std::optional<ScoredWork> m_scored;
    std::size_t m_criterionCount = 0;
    QWidget* m_block = nullptr;  ///< the cards
    QGridLayout* m_cards = nullptr;
    QWidget* m_resultCard = nullptr;
    QWidget* m_criteriaCard = nullptr;
    QWidget* m_placeCard = nullptr;
    ScoreHistory* m_historyCard = nullptr;
    CommentsPanel* m_talk = nullptr;
    QWidget* m_talkCard = nullptr;
    QWidget* m_formInUse = nullptr;  ///< the comments form that the user wrote in last
    kit::ScrollPane* m_scroll = nullptr;
    QHBoxLayout* m_buttons = nullptr;
    QLabel* m_said = nullptr;
    std::function<QString()> m_saying;
    QPushButton* m_replay = nullptr;
    bool m_talks = false;
    kit::TabularDigitsLabel* m_total = nullptr;
    QLabel* m_verdictIcon = nullptr;
    QLabel* m_verdict = nullptr;
    QLabel* m_expected = nullptr;
    QWidget* m_adviceBox = nullptr;  ///< the most important advice
    QLabel* m_advice = nullptr;
    QPushButton* m_showMoment = nullptr;
    double m_adviceAtS = 0.0;
    QToolButton* m_detailsButton = nullptr;
    QWidget* m_details = nullptr;
    QLabel* m_presetWarning = nullptr;
    QLabel* m_doubt = nullptr;  ///< why the attempt does not count
    QLabel* m_noise = nullptr;
    QLabel* m_unrecorded = nullptr;
    QLabel* m_rubric = nullptr;
    kit::ScoreBar* m_bar = nullptr;
    QWidget* m_criteria = nullptr;
    QVBoxLayout* m_criteriaSlot = nullptr;
    QList<CriterionRow*> m_rows;
    QWidget* m_looking = nullptr;
    QProgressBar* m_progress = nullptr;
    ConductNotes* m_conduct = nullptr;
    QLabel* m_sum = nullptr;
    QLabel* m_place = nullptr;
    QLabel* m_placeAdvice = nullptr;
    HeatMap* m_heat = nullptr;
    WorstSection* m_section = nullptr;
    QPushButton* m_back = nullptr;
    QPushButton* m_next = nullptr;
    ::lessons::LocalText m_nextTitle;
    QList<QPushButton*> m_ofTheTable;  ///< buttons that act on the current attempt, not on an old one
    ::lessons::ScoreSheet m_sheet;     ///< the shown score
};

}  // namespace ui::scoring
