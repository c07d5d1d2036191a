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

/// A grade that explains itself: first what it came to, then why. Every criterion with what it cost, when, and its
/// formula worked in numbers; the work from above and in a section, each through the place where the chosen criterion
/// is worst; the sum, and the grades before it.
class ScorePage final : public kit::Page
{
    Q_OBJECT
public:
    ScorePage(const kit::Actions& actions, QWidget* parent);

    /// @param work     the lesson, or the tooth, in the language of the moment
    /// @param history  newest first, this attempt included
    /// @param expected  what the student had expected, where that was asked
    /// @param scored   what was marked; nothing: no pictures, and no replay
    void setScore(std::function<QString()> work, const ::lessons::ScoreSheet& sheet,
                  const QList<database::AttemptRecord>& history, const std::optional<ScorePrediction>& expected,
                  const std::optional<ScoredWork>& scored);
    /// Whose work it is, after setScore(); empty: one's own.
    void setPerson(const QString& fullName);
    [[nodiscard]] const QString& person() const { return m_person; }
    /// A teacher's score counts in place of the machine's, which stays beneath; nothing: the machine's.
    void setGiven(std::optional<int> tenths);
    /// After a passed attempt, this lesson is offered as the next, in place of the way back. Null: none is offered.
    /// setScore() withdraws the offer.
    void setNext(const ::lessons::Lesson* lesson);
    /// The same, when the database has answered.
    void setHistory(const QList<database::AttemptRecord>& history);
    using Keeping = ScoreHistory::Keeping;
    void setKeeping(Keeping keeping);
    /// What people say of the attempt, under everything else; shown for one that is kept and was opened.
    [[nodiscard]] CommentsPanel& talk() { return *m_talk; }
    /// What a score came to, here and on paper.
    /// @param givenTenths  by a teacher, where he did
    [[nodiscard]] static QString verdictWords(const ::lessons::ScoreSheet& sheet, std::optional<int> givenTenths);
    /// What the criteria leave of all points; named as the machine's where a teacher gave another score.
    [[nodiscard]] static QString sumWords(const ::lessons::ScoreSheet& sheet, std::optional<int> givenTenths);
    /// What is shown, for paper; attempt, person, talk and proof are for who knows them.
    [[nodiscard]] ScoreCard card() const;
    /// What became of the card that was to be saved or printed.
    void say(std::function<QString()> words);
    void setTalkVisible(bool visible);
    /// Scrolls to what people say, once the card is laid out.
    void showTalk();
    /// Who reads may write as well: comments, which can be pinned to places of the picture, and another score.
    void setMayTalk(bool may);
    /// Where the score stands among those of a class.
    void setClass(const ::lessons::ClassStanding& standing);
    /// What the score comes to on other grids.
    void setNoise(const ::lessons::GridSensitivity& noise);
    /// The moments are being looked for, and so far this share of the attempt, 0 .. 1, has been looked at; nothing:
    /// nobody looks any more.
    void setMomentsProgress(std::optional<double> share);
    /// Of the criteria of the sheet that is shown, in their order.
    void setMoments(const std::vector<std::vector<::lessons::Moment>>& moments);

signals:
    /// The card is wanted as a PDF, or on paper.
    void pdfRequested();
    void printRequested();
    /// The attempt is to be seen from this moment on.
    void momentRequested(double seconds);
    /// The attempt is to be seen from its beginning.
    void replayRequested();
    /// Emitted when the user asks for the lesson of setNext().
    void nextRequested();
    /// A guest wants to log in, so that the grade is kept as his.
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
    /// The criteria beside the pictures; where there is no room for that, above.
    void arrange();
    void retranslateUi();
    void tellSaying();
    void fillCriteria();
    void showPlace(const CriterionRow& row);
    void showPin(const std::optional<std::array<double, 3>>& placeMm);
    void tellAdvice();
    void showDetails(bool shown);
    void tellNoise();
    void tellUnrecorded();
    void tellMoments();
    void tellHistory();

    // What is shown, so that it can be said again in another language.
    bool m_isShown = false;
    std::function<QString()> m_work;
    QString m_person;            ///< empty: one's own
    std::optional<int> m_given;  ///< tenths, by a teacher
    std::optional<ScorePrediction> m_expectation;
    std::optional<::lessons::GridSensitivity> m_noiseNow;
    std::vector<std::vector<::lessons::Moment>> m_moments;
    QList<database::AttemptRecord> m_history;
    std::string m_chosen;  ///< criterion that is looked at, by id
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
    QWidget* m_formInUse = nullptr;  ///< of the talk: where something was written last
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
    QWidget* m_adviceBox = nullptr;  ///< the one thing to do better
    QLabel* m_advice = nullptr;
    QPushButton* m_showMoment = nullptr;
    double m_adviceAtS = 0.0;
    QToolButton* m_detailsButton = nullptr;
    QWidget* m_details = nullptr;
    QLabel* m_presetWarning = nullptr;
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
    QList<QPushButton*> m_ofTheTable;  ///< what they do is done to the work on the table, not to an old attempt
    ::lessons::ScoreSheet m_sheet;     ///< that is shown
};

}  // namespace ui::scoring
