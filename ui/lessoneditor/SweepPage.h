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

/// Shows the scores that past attempts would have under other tolerances than the draft's. The attempts come from the
/// recordings of a folder, which are replayed once on another thread, and from the history of the lesson.
class SweepPage final : public QWidget
{
    Q_OBJECT
public:
    explicit SweepPage(QWidget* parent);
    ~SweepPage() override;

    /// Prepares the page for another lesson. Keeps the attempts read from a folder, because they may be on the same
    /// tooth.
    void begin(const std::optional<::lessons::Lesson>& opened);
    /// Sets the measures of past attempts at the opened lesson. They are used until its ideal is changed.
    void setKnown(std::vector<MeasuredAttempt> attempts);
    /// Sets the current draft.
    /// @param good  a result with an assignment
    void setDraft(const std::shared_ptr<const EvaluatedDraft>& good);
    /// Replays the recordings of a folder. Cancels the reading of another folder.
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
    int m_unmeasured = 0;                     ///< attempts without stored measures
    std::vector<MeasuredAttempt> m_measured;  ///< measures of the attempts in m_past
    core::grading::IdealTop m_measuredFor;
    std::string m_criteriaOffered;  ///< ids of the criteria in the list
    int m_reading = 0;              ///< number of the newest reading
    std::shared_ptr<std::atomic<bool>> m_cancel;
    std::shared_ptr<std::atomic<int>> m_measuring;  ///< number of the newest measuring; older results are discarded
    QString m_summary;

    QComboBox* m_swept = nullptr;
    QProgressBar* m_progress = nullptr;
    QPushButton* m_stop = nullptr;
    SweepChart* m_chart = nullptr;
    QLabel* m_words = nullptr;
    QThreadPool m_pool;  ///< last: its destructor waits for a job that uses the members above
};

}  // namespace ui::lessoneditor
