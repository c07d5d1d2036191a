// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>

#include <QJsonArray>
#include <QSet>
#include <QThreadPool>
#include <QTimer>

#include "core/base/FileLock.h"
#include "ui/kit/Page.h"
#include "ui/lessoneditor/LessonDraft.h"
#include "ui/lessoneditor/ToleranceSweep.h"

class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;

namespace ui::lessoneditor {

class DraftEvaluator;
class IdealForm;
class RubricForm;
class SweepPage;
class ToleranceView;

/// The page where teachers edit a lesson: the sizes of its ideal, or the attempts from which it is captured; the
/// tolerances and weights of the rubric; and the effect of these on the tooth and on past attempts. Editing a shipped
/// lesson creates a new lesson that belongs to the teacher.
///
/// Slow work runs on other threads, and only the newest request is answered. Drafts stay open while the user is logged
/// in, and survive a crash of the program; see recover().
class LessonEditor final : public kit::Page
{
    Q_OBJECT
public:
    LessonEditor(const kit::Actions& actions, QWidget* parent);
    ~LessonEditor() override;

    /// Opens a lesson.
    /// @param lesson  a valid lesson
    /// @param folder  the teacher's folder, where a version of a shipped lesson is saved
    void edit(const ::lessons::ReadLesson& lesson, const QString& folder);
    [[nodiscard]] bool canUndo() const;
    [[nodiscard]] bool canRedo() const;
    void undo();
    void redo();
    /// Writes the lesson. If that fails, shows the reason beside the button.
    void save();

    /// Returns a sentence with the number of unsaved lessons. Empty if there are none.
    [[nodiscard]] QString unsavedChanges() const;
    void discardChanges();
    /// Returns the files from which the unsaved drafts were created.
    [[nodiscard]] QSet<QString> unsavedFiles() const;

    /// Closes all drafts. Unsaved drafts stay in the recovery file, from which recover() restores them.
    void closeDrafts();
    /// Restores the unsaved drafts from a recovery file, and from then on writes unsaved drafts to it. Does nothing if
    /// another window uses the file.
    /// @param folder  the teacher's folder
    /// @param file  the user's recovery file
    void recover(const QString& folder, const QString& file);

    /// Sets the measures of past attempts at the opened lesson. The sweep uses them until the ideal is changed.
    void setKnown(std::vector<MeasuredAttempt> attempts);
    /// Replays the recordings of a folder for the sweep.
    void readFolder(const QString& folder);

signals:
    /// Emitted when canUndo() or canRedo() may have changed.
    void stepsChanged();
    /// Emitted when a lesson has been written to the teacher's folder.
    void lessonSaved(const QString& file);

protected:
    void showEvent(QShowEvent* event) override;

private:
    /// A draft and the lesson from which it was created.
    struct Opened
    {
        LessonDraft draft;
        ::lessons::Lesson lesson;
    };

    QWidget* makeForm();
    QWidget* makePictures();
    QWidget* makeFoot(const kit::Actions& actions);
    [[nodiscard]] LessonDraft& draft();
    [[nodiscard]] const LessonDraft& draft() const;
    void keepDrafts();
    void turnTo(const QString& present);
    void showTitle();
    void changed();
    void take(const std::shared_ptr<const EvaluatedDraft>& weighed, bool isNewest);
    void offerReferences();
    void showMeaning();
    void showFaults();
    void showCheck();
    void fitTolerances();
    void chooseReference(const QString& name);
    void openAnew();
    void refuseToSave(const QString& whyNot);
    void askForRecordings();
    void captureFrom(const QStringList& recordings);
    /// @param words  returns the message in the current language
    void say(std::function<QString()> words, bool isWrong);
    void retranslateUi();

    std::map<QString, Opened> m_opened;  ///< by the file of the lesson from which the draft was created
    QString m_present;
    std::shared_ptr<const EvaluatedDraft> m_now;   ///< the newest result for the current draft
    std::shared_ptr<const EvaluatedDraft> m_good;  ///< the newest result with an assignment
    QString m_recoveryFile;
    std::optional<core::FileLock> m_recoveryLock;  ///< from recover() on, unless another window holds it
    QJsonArray m_kept;                             ///< the contents of the recovery file
    QTimer m_keeping;
    DraftEvaluator* m_weigher;
    bool m_isSaveWanted = false;
    std::function<QString()> m_saying;
    bool m_isSaidWrong = false;

    QLineEdit* m_title = nullptr;
    QLabel* m_generalFault = nullptr;
    IdealForm* m_ideal = nullptr;
    RubricForm* m_rubric = nullptr;
    ToleranceView* m_view = nullptr;
    QLabel* m_meaning = nullptr;
    SweepPage* m_sweep = nullptr;
    QPlainTextEdit* m_json = nullptr;
    QPushButton* m_save = nullptr;
    QLabel* m_check = nullptr;
    QLabel* m_said = nullptr;
    QPushButton* m_fit = nullptr;
    QPushButton* m_anew = nullptr;  ///< visible while the file has been changed by another window or program
    QThreadPool m_capturing;        ///< last: its destructor waits for a job that uses the members above
};

}  // namespace ui::lessoneditor
