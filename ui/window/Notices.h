// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QCoreApplication>
#include <QStringList>

#include "core/base/Result.h"
#include "ui/kit/MessageBar.h"
#include "ui/text/Texts.h"

namespace ui::window {

/// Shows the messages of the window about files, the database and attempts.
class Notices
{
    Q_DECLARE_TR_FUNCTIONS(ui::window::Notices)
public:
    explicit Notices(kit::MessageBar& messages) : m_messages(messages) {}

    /// Shows a sentence for some seconds.
    void say(const QString& sentence);
    /// Shows a sentence until it is closed.
    void warn(const QString& sentence);
    /// Shows a sentence for some seconds, with an undo button.
    /// @param undo  called when the button is pressed
    void sayUndoable(const QString& sentence, const std::function<void()>& undo);
    /// Shows an error.
    /// @param file  path of the file that failed; empty: none
    void showError(const core::Error& error, text::FailedOperation failed, const QString& file);
    /// Shows that a grade could not be saved. The message stays until Topic::Keeping is withdrawn.
    void showGradeNotSaved(const core::Error& error);
    void showDatabaseSilent();
    /// Shows that the grade is not saved because the student had no attempt left.
    /// @param actionText  text of the button that saves the work as a recording
    /// @param save        called when the button is pressed
    void showOverLimit(const QString& actionText, const std::function<void()>& save);
    void showWrongFile(const QString& path);
    void showRecordingSaved(const QString& path);
    /// Shows the guesses and warnings of the importer of a scan.
    /// @param notes         returns them, one sentence each; not empty
    /// @param chooseUnit    reads the scan again in another unit: "mm", "cm" or "m"; null if the unit is certain
    void showScanNotes(const std::function<QStringList()>& notes,
                       const std::function<void(const QString& unit)>& chooseUnit);

private:
    void showError(const core::Error& error, text::FailedOperation failed, const QString& file,
                   kit::MessageBar::Topic topic);

    kit::MessageBar& m_messages;
};

}  // namespace ui::window
