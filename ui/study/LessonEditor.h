// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>

#include <QJsonArray>
#include <QJsonObject>
#include <QSet>
#include <QThreadPool>

#include "ui/shell/Page.h"
#include "ui/study/LessonDraft.h"
#include "ui/study/ToleranceSweep.h"

class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;

namespace ui::study {

class DraftWeigher;
class IdealForm;
class RubricForm;
class SweepPage;
class ToleranceView;

/// Where a teacher changes a lesson: the numbers of its ideal, or attempts that stand for it; what the rubric tolerates
/// and what each criterion weighs; with what that means on the tooth, and for attempts that are there. Shipped lessons
/// become lessons of the teacher's own.
///
/// All that is slow happens on threads of its own; the newest wish is answered. A draft stays as it was left while the
/// program runs, whatever is looked at meanwhile; unsaved() tells what would be lost at its end.
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

    /// The titles of the lessons whose drafts have changed since they were saved.
    [[nodiscard]] QStringList unsaved() const;
    /// The files that those drafts began from.
    [[nodiscard]] QSet<QString> unsavedFiles() const;
    /// Writes all of those; each takes some tenths of a second. False when one cannot be written: then that one is on
    /// the page, with what is wrong.
    [[nodiscard]] bool saveAll();

    /// The changed drafts, each as an object with its "lesson", the file "from" which it began, and what was "saved"
    /// there.
    [[nodiscard]] QJsonArray unsavedDrafts() const;
    /// One of those is a draft again. False: it is none, its lesson cannot be read now, or another draft of that is
    /// here.
    /// @param folder  the teacher's
    [[nodiscard]] bool goOnWith(const QJsonObject& unsaved, const QString& folder);
    /// One that was refused, in place of what is there. Answers that, which waits in its stead.
    [[nodiscard]] QJsonObject trade(const QJsonObject& unsaved);
    /// What was refused, in a sentence; empty: it is none.
    [[nodiscard]] static QString words(const QJsonObject& unsaved);
    /// Another draft of that lesson is here.
    [[nodiscard]] bool isTaken(const QJsonObject& unsaved) const;

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
    QWidget* makeFoot(const shell::Actions& actions);
    [[nodiscard]] LessonDraft& draft();
    [[nodiscard]] const LessonDraft& draft() const;
    [[nodiscard]] static QJsonObject toJson(const QString& from, const Opened& opened);
    [[nodiscard]] QString keyOf(const QJsonObject& unsaved) const;
    void turnTo(const QString& present);
    void showTitle();
    void changed();
    void take(const std::shared_ptr<const Weighed>& weighed, bool isNewest);
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
    void speak();

    std::map<QString, Opened> m_opened;  ///< by the file of the lesson they began from
    QString m_present;
    std::shared_ptr<const Weighed> m_now;   ///< the newest of the present draft
    std::shared_ptr<const Weighed> m_good;  ///< the newest of it that is a lesson
    DraftWeigher* m_weigher;
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

}  // namespace ui::study
