// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <map>
#include <memory>

#include <QThreadPool>

#include "ui/shell/Page.h"
#include "ui/study/LessonDraft.h"
#include "ui/study/ToleranceSweep.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace ui::study {

class SweepChart;
class ToleranceView;

/// Where a teacher changes a lesson: the numbers of its ideal, or attempts that stand for it; what the rubric tolerates
/// and what each criterion weighs; with what that means on the tooth, and for attempts that are there. Shipped lessons
/// become lessons of the teacher's own.
///
/// All that is slow happens on threads of its own; the newest wish is answered. A draft stays as it was left while the
/// program runs.
class LessonEditor final : public shell::Page
{
    Q_OBJECT
public:
    LessonEditor(const shell::Actions& actions, QWidget* parent);
    ~LessonEditor() override;

    /// @param lesson  one that can be given
    /// @param folder  the teacher's, where his own version of a shipped lesson will stand
    void edit(const ::lessons::ReadLesson& lesson, const QString& folder);
    [[nodiscard]] bool canUndo() const;
    [[nodiscard]] bool canRedo() const;
    void undo();
    void redo();
    /// Writes the lesson, or says beside the button why not.
    void save();
    /// What was measured of attempts at the lesson that is edited, as it was when it was opened: they count in the
    /// sweep until its ideal is changed.
    void setKnown(std::vector<MeasuredAttempt> attempts);
    /// Replays the recordings of a folder for the sweep.
    void readFolder(const QString& folder);

signals:
    /// What can be undone has changed.
    void stepsChanged();
    /// The teacher's folder has a lesson that it had not, or not so.
    void lessonSaved(const QString& file);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Criterion
    {
        QDoubleSpinBox* tolerance = nullptr;
        QDoubleSpinBox* weight = nullptr;  ///< null for a critical one
        QLabel* fault = nullptr;
    };

    QWidget* makeForm();
    QWidget* makePictures();
    QWidget* makeSweep();
    QWidget* makeFoot(const shell::Actions& actions);
    [[nodiscard]] LessonDraft& draft();
    [[nodiscard]] const LessonDraft& draft() const;

    void changed();
    void weighLater();
    void take(const std::shared_ptr<const Weighed>& weighed);
    void fillFields();
    void fillRubric();
    void fillReferences();
    void showValues();
    void showFaults();
    void showCheck();
    void fitTolerances();
    void chooseReference(int index);
    void askForRecordings();
    void captureFrom(const QStringList& recordings);
    void askForFolder();
    void takeAttempts(const std::shared_ptr<const PastAttempts>& past);
    void measureLater();
    void sweepAgain();
    void say(const QString& words, bool isWrong);
    QDoubleSpinBox* spin(double low, double high, int decimals, const QString& unit, const QString& name);

    std::map<QString, LessonDraft> m_drafts;  ///< by the file of the lesson they began from
    QString m_present;
    std::shared_ptr<const Weighed> m_now;   ///< the newest
    std::shared_ptr<const Weighed> m_good;  ///< the newest that is a lesson
    bool m_isWeighing = false;
    bool m_isWanted = false;  ///< weighed again as soon as it is done
    bool m_isSaveWanted = false;
    bool m_isFilling = false;

    std::shared_ptr<const PastAttempts> m_past;
    std::vector<MeasuredAttempt> m_measured;
    std::vector<MeasuredAttempt> m_known;
    std::optional<::lessons::Lesson> m_opened;
    core::grading::IdealTop m_measuredFor;
    int m_reading = 0;  ///< number of the newest reading: an older one comes to nothing
    std::shared_ptr<std::atomic<bool>> m_cancel;

    QLineEdit* m_title = nullptr;
    QLabel* m_generalFault = nullptr;
    QLabel* m_idealHead = nullptr;
    QComboBox* m_reference = nullptr;
    QPushButton* m_fromRecordings = nullptr;
    QLabel* m_idealFault = nullptr;
    QVBoxLayout* m_fieldsSlot = nullptr;
    QWidget* m_fields = nullptr;
    std::map<QString, QWidget*> m_fieldInputs;
    std::map<QString, QLabel*> m_fieldFaults;
    QVBoxLayout* m_rubricSlot = nullptr;
    QWidget* m_rubric = nullptr;
    std::vector<Criterion> m_criteria;
    std::string m_rubricShown;  ///< ids of the criteria there are inputs for
    QDoubleSpinBox* m_passMark = nullptr;
    QLabel* m_sum = nullptr;
    QLabel* m_check = nullptr;
    QPushButton* m_fit = nullptr;
    QStackedWidget* m_pictures = nullptr;
    ToleranceView* m_view = nullptr;
    QLabel* m_meaning = nullptr;
    SweepChart* m_chart = nullptr;
    QComboBox* m_swept = nullptr;
    QLabel* m_sweepWords = nullptr;
    QProgressBar* m_progress = nullptr;
    QPushButton* m_stop = nullptr;
    QPlainTextEdit* m_json = nullptr;
    QPushButton* m_save = nullptr;
    QLabel* m_said = nullptr;

    // Last: they are waited for before what they answer to goes away.
    QThreadPool m_weighing;
    QThreadPool m_replaying;
};

}  // namespace ui::study
