// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QByteArray>
#include <QJsonObject>
#include <QList>
#include <QSet>
#include <QString>

#include "core/preparation/CapturedIdeal.h"
#include "core/preparation/ToleranceBand.h"
#include "core/preparation/ToothDesign.h"
#include "lessons/Assignment.h"
#include "lessons/LessonReader.h"
#include "ui/inside/OutlinePainter.h"

namespace ui::lessoneditor {

/// A size of the ideal that a teacher may change.
struct IdealField
{
    QString id;    ///< its key in the file
    QString name;  ///< in the user's language
    QString unit;  ///< may be empty
    double value = 0.0;
    double minimum = 0.0;
    double maximum = 0.0;
    bool whole = false;
};

/// The result of evaluating a draft: the lesson that was read, its assignment, and its score.
struct EvaluatedDraft
{
    ::lessons::ReadLesson read;  ///< with its errors
    std::optional<::lessons::Assignment> assignment;
    std::vector<IdealField> fields;                       ///< empty for a captured ideal, and for removing decay
    std::optional<core::preparation::ToothDesign> usual;  ///< for this tooth, if the ideal is built by rule
    double outlineMm = 0.0;                               ///< tolerance of the outline, or the allowance beside a shape
    double spanMm = 0.0;                                  ///< beyond the tolerance, up to where all points of the
                                                          ///< criterion are lost
    double depthMm = 0.0;                                 ///< tolerance of the depth, or the allowance below a shape
    std::optional<core::preparation::ToleranceBand> band;
    inside::FromAbove above;
    std::optional<::lessons::ScoreSheet> itself;  ///< the score of the ideal itself, graded like a student's attempt
    double milliseconds = 0.0;                    ///< duration of the evaluation

    [[nodiscard]] bool isFullMarks() const { return itself && itself->totalTenths == ::lessons::kFullTenths; }
};

/// Evaluates a draft. A change of tolerances takes about ten milliseconds, a change of the ideal some tens more. The
/// tooth is built again only if the draft uses another one. Any thread but the ui thread.
/// @param before  the previous result, for reuse; may be null
[[nodiscard]] std::shared_ptr<const EvaluatedDraft> weigh(const QJsonObject& draft, const QString& file,
                                                          const std::shared_ptr<const EvaluatedDraft>& before);

/// A lesson while it is edited: the JSON object, its file, and the undo history. Ui thread.
class LessonDraft
{
public:
    /// Starts with a lesson. If the lesson is shipped, creates a new lesson based on it in the teacher's folder. The
    /// teacher's own lesson is changed in its own file.
    void begin(const ::lessons::ReadLesson& lesson, const QString& teachersFolder);

    /// Continues with a stored draft, as one undo step after begin().
    /// @param object  as returned by object()
    /// @param saved  contents of the file when the draft was stored, as returned by saved(); empty: the present
    ///               contents
    void goOnWith(const QJsonObject& object, const QJsonObject& saved);
    /// Discards all changes since the last save, and the undo history.
    void revert();
    /// Loads the file again, as one undo step.
    void openAnew(const ::lessons::ReadLesson& lesson);

    [[nodiscard]] const QJsonObject& object() const { return m_states[m_at]; }
    /// Returns the contents of the file as last read or written.
    [[nodiscard]] const QJsonObject& saved() const { return m_saved; }
    [[nodiscard]] const QString& file() const { return m_file; }
    /// Returns whether another window or computer has written the file since then.
    [[nodiscard]] bool isOvertaken() const;
    /// Returns the title in the user's language.
    [[nodiscard]] QString title() const;
    /// Returns the rubric as it is graded, even if it is invalid.
    [[nodiscard]] QJsonObject rubric() const;
    [[nodiscard]] bool canUndo() const { return m_at > 0; }
    [[nodiscard]] bool canRedo() const { return m_at + 1 < m_states.size(); }
    [[nodiscard]] bool isChanged() const { return m_states[m_at] != m_saved; }
    void undo();
    void redo();
    /// Returns the bytes to save, and marks them as saved. The first save of an existing lesson increments its version.
    [[nodiscard]] QByteArray stamped();
    [[nodiscard]] bool isSavedOnce() const { return m_exists; }

    void setTitle(const QString& title, const QString& language);
    void setSize(const QString& id, double value);
    /// Sets the ideal.
    /// @param name  a file in the lesson's folder; empty: computed by rule
    void setCaptured(const QString& name, const std::optional<core::preparation::Tolerances>& tolerances);
    void setPassMark(double points);
    /// @param key  a number of the criterion: "tolerance", "weight", "target", "span"
    void setCriterion(int index, const char* key, double value);

private:
    void takeWhole(const ::lessons::Lesson& lesson);
    /// Returns the titles by language: those in the file, otherwise those of the base lesson.
    [[nodiscard]] QJsonObject titles() const;
    /// @param what  successive changes with the same value become one undo step
    void change(const QString& what, const QJsonObject& object);

    QList<QJsonObject> m_states{QJsonObject()};
    qsizetype m_at = 0;
    QString m_lastChange;
    QJsonObject m_saved;
    QJsonObject m_wholeRubric;  ///< the rubric before any change, as an object for the lesson's own file
    QJsonObject m_wholeTitle;   ///< titles by language when the draft was begun
    QJsonObject m_firstTitles;  ///< the same, with the file's own titles
    bool m_areTitlesMadeUp = false;
    QSet<QString> m_typedTitles;  ///< languages whose title the user has typed since
    QString m_file;
    bool m_exists = false;
    bool m_isBlock = false;
    bool m_isStamped = false;
};

}  // namespace ui::lessoneditor
