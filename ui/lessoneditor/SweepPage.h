// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include <QThreadPool>
#include <QWidget>

#include "ui/lessoneditor/LessonDraft.h"
#include "ui/lessoneditor/ToleranceSweep.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace ui::lessoneditor {

class SweepChart;

/// How attempts that are there would score under other tolerances than the draft's: those of a folder, replayed once on
/// a thread of its own, and what the history knows of attempts at the lesson.
class SweepPage final : public QWidget
{
    Q_OBJECT
public:
    explicit SweepPage(QWidget* parent);
    ~SweepPage() override;

    /// Another lesson is edited. The attempts that were read stay: they may be at its tooth as well.
    void begin(const std::optional<::lessons::Lesson>& opened);
    /// What was measured of attempts at the lesson as it was opened: they count until its ideal is changed.
    void setKnown(std::vector<MeasuredAttempt> attempts);
    /// The draft as it is now.
    /// @param good  one with an assignment
    void setDraft(const std::shared_ptr<const EvaluatedDraft>& good);
    /// Replays the recordings of a folder. One that is still being read comes to nothing.
    void readFolder(const QString& folder);

private:
    void askForFolder();
    void takeAttempts(const std::shared_ptr<const PastAttempts>& past);
    void measureLater();
    void sweepAgain();
    void say(const QString& words);
    void sayHowToBegin();
    void nameCriteria();
    void retranslateUi();
    [[nodiscard]] bool isAsOpened() const;

    std::shared_ptr<const EvaluatedDraft> m_good;
    std::optional<::lessons::Lesson> m_opened;
    std::shared_ptr<const PastAttempts> m_past;
    std::vector<MeasuredAttempt> m_known;
    int m_unmeasured = 0;                     ///< of which the history knows no measures
    std::vector<MeasuredAttempt> m_measured;  ///< of m_past
    core::grading::IdealTop m_measuredFor;
    std::string m_criteriaOffered;  ///< their ids
    int m_reading = 0;              ///< number of the newest reading
    std::shared_ptr<std::atomic<bool>> m_cancel;
    std::shared_ptr<std::atomic<int>> m_measuring;  ///< number of the newest measuring: an older one is left out
    QString m_summary;

    QComboBox* m_swept = nullptr;
    QProgressBar* m_progress = nullptr;
    QPushButton* m_stop = nullptr;
    SweepChart* m_chart = nullptr;
    QLabel* m_words = nullptr;
    QThreadPool m_pool;  ///< last: waited for before what it answers to goes away
};

}  // namespace ui::lessoneditor
