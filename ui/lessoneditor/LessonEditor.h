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

/// Where a teacher changes a lesson: the numbers of its ideal, or attempts that stand for it; what the rubric tolerates
/// and what each criterion weighs; with what that means on the tooth, and for attempts that are there. Shipped lessons
/// become lessons of the teacher's own.
///
/// All that is slow happens on threads of its own; the newest wish is answered. A draft stays as it was left while the
/// user is logged in, whatever is looked at meanwhile, and survives a crash of the program: see setRecoveryFile().
class LessonEditor final : public kit::Page
{
    Q_OBJECT
public:
    LessonEditor(const kit::Actions& actions, QWidget* parent);
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

    /// Counts the lessons that are changed and not saved, in a sentence. Empty: there are none.
    [[nodiscard]] QString unsavedChanges() const;
    void discardChanges();
    /// The files that those drafts began from.
    [[nodiscard]] QSet<QString> unsavedFiles() const;

    /// Closes all drafts. The unsaved ones stay in the recovery file, from which recover() brings them back.
    void closeDrafts();
    /// Restores the unsaved drafts in a recovery file, and writes unsaved drafts there from now on. Does nothing if
    /// another window uses the file.
    /// @param folder  the teacher's
    /// @param file  the user's own
    void recover(const QString& folder, const QString& file);

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
    void showEvent(QShowEvent* event) override;

private:
    /// A draft and the lesson it began as.
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
    /// @param words  said again in another language
    void say(std::function<QString()> words, bool isWrong);
    void retranslateUi();

    std::map<QString, Opened> m_opened;  ///< by the file of the lesson they began from
    QString m_present;
    std::shared_ptr<const EvaluatedDraft> m_now;   ///< the newest of the present draft
    std::shared_ptr<const EvaluatedDraft> m_good;  ///< the newest of it that is a lesson
    QString m_recoveryFile;
    std::optional<core::FileLock> m_recoveryLock;  ///< from recover() on, if no other window has it
    QJsonArray m_kept;                             ///< what is in the recovery file
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
    QPushButton* m_anew = nullptr;  ///< while somebody else has written to the file
    QThreadPool m_capturing;        ///< last: waited for before what it answers to goes away
};

}  // namespace ui::lessoneditor
