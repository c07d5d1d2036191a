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

/// A number of the ideal that a teacher may change.
struct IdealField
{
    QString id;    ///< in the file
    QString name;  ///< in the user's language
    QString unit;  ///< may be empty
    double value = 0.0;
    double minimum = 0.0;
    double maximum = 0.0;
    bool whole = false;
};

/// What a draft comes to: read, given and marked as any lesson is.
struct EvaluatedDraft
{
    ::lessons::ReadLesson read;  ///< with what is wrong
    std::optional<::lessons::Assignment> assignment;
    std::vector<IdealField> fields;  ///< none of a captured ideal, and where decay is to be removed
    std::optional<core::preparation::ToothDesign> usual;  ///< for this tooth, where the ideal is made by rule
    double outlineMm = 0.0;                               ///< tolerance of the outline, or the leeway beside a shape
    double spanMm = 0.0;                                  ///< beyond it, until all points of that criterion are lost
    double depthMm = 0.0;                                 ///< tolerance of the depth, or the leeway below a shape
    std::optional<core::preparation::ToleranceBand> band;
    inside::FromAbove above;
    std::optional<::lessons::ScoreSheet> itself;  ///< the ideal, marked as if a student had cut it
    double milliseconds = 0.0;                    ///< that this took

    [[nodiscard]] bool isFullMarks() const { return itself && itself->totalTenths == ::lessons::kFullTenths; }
};

/// Any thread that may wait. A change of tolerances takes some ten milliseconds, of the ideal some tens more; a new
/// tooth is made only where the draft asks for another one.
/// @param before  what it came to last, to be used again; may be null
[[nodiscard]] std::shared_ptr<const EvaluatedDraft> weigh(const QJsonObject& draft, const QString& file,
                                                          const std::shared_ptr<const EvaluatedDraft>& before);

/// A lesson while it is edited: the object of its file, where it will stand, and all that can be taken back. Ui thread.
class LessonDraft
{
public:
    /// A shipped lesson becomes one of the teacher's own, based on it; his own is changed where it stands.
    void begin(const ::lessons::ReadLesson& lesson, const QString& teachersFolder);

    /// What it had become, as object() gave it; one step further than it begins.
    /// @param saved  what stood in its file then, as saved() gave it; empty: as it stands there now
    void goOnWith(const QJsonObject& object, const QJsonObject& saved);
    /// Discards all changes since it was saved, and the steps to them.
    void revert();
    /// What stands in its file now becomes one step further; a step back leads to what was changed here.
    void openAnew(const ::lessons::ReadLesson& lesson);

    [[nodiscard]] const QJsonObject& object() const { return m_states[m_at]; }
    /// What stood in its file when that was read or written last.
    [[nodiscard]] const QJsonObject& saved() const { return m_saved; }
    [[nodiscard]] const QString& file() const { return m_file; }
    /// Another window, or somebody at another computer, has written to its file since.
    [[nodiscard]] bool isOvertaken() const;
    /// In the user's language.
    [[nodiscard]] QString title() const;
    /// As it is marked, also where that is no rubric yet.
    [[nodiscard]] QJsonObject rubric() const;
    [[nodiscard]] bool canUndo() const { return m_at > 0; }
    [[nodiscard]] bool canRedo() const { return m_at + 1 < m_states.size(); }
    [[nodiscard]] bool isChanged() const { return m_states[m_at] != m_saved; }
    void undo();
    void redo();
    /// The bytes to be saved, which count as saved from now on. A lesson that was there gets a higher version, once.
    [[nodiscard]] QByteArray stamped();
    [[nodiscard]] bool isSavedOnce() const { return m_exists; }

    void setTitle(const QString& title, const QString& language);
    void setSize(const QString& id, double value);
    /// @param name  of a file beside the lesson; empty: by rule again
    void setCaptured(const QString& name, const std::optional<core::preparation::Tolerances>& tolerances);
    void setPassMark(double points);
    /// @param key  of a number of a criterion: "tolerance", "weight", "target", "span"
    void setCriterion(int index, const char* key, double value);

private:
    void takeWhole(const ::lessons::Lesson& lesson);
    /// The title by language: the file's own words, and where it says none those of what it is based on.
    [[nodiscard]] QJsonObject titles() const;
    /// @param what  several changes of one thing in a row are one
    void change(const QString& what, const QJsonObject& object);

    QList<QJsonObject> m_states{QJsonObject()};
    qsizetype m_at = 0;
    QString m_lastChange;
    QJsonObject m_saved;
    QJsonObject m_wholeRubric;  ///< what the rubric is before it has been changed, as an object of the lesson's own
    QJsonObject m_wholeTitle;   ///< by language, as it was when the draft was begun
    QJsonObject m_firstTitles;  ///< the same, with what the file itself says
    bool m_areTitlesMadeUp = false;
    QSet<QString> m_typedTitles;  ///< languages in which somebody has typed one since
    QString m_file;
    bool m_exists = false;
    bool m_isBlock = false;
    bool m_isStamped = false;
};

}  // namespace ui::lessoneditor
