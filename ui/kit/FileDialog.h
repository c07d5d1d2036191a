// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileDialog>
#include <QString>

class QLabel;

namespace ui::kit {

/// Asks for a file in Qt's own dialog, and deletes itself when it is closed. It reads names only, never contents:
/// opening and closing a database file would drop all locks that this program's SQLite holds on it, and another program
/// would then delete the log with the newest entries (POSIX fcntl; "How To Corrupt An SQLite Database File", section
/// 2.2).
class FileDialog final : public QFileDialog
{
    Q_OBJECT
public:
    /// @param folder  the folder that is shown first
    /// @param filter  "Tables (*.csv)"; empty: all files
    FileDialog(QWidget* parent, const QString& title, const QString& folder, const QString& filter = {});

    /// Opens the dialog to save an exported file. Starts in the folder of the last export, also of earlier runs.
    /// @param name    suggested file name; characters that do not fit a file name are replaced
    /// @param ending  "pdf"
    void askWhere(const QString& name, const QString& ending);

protected:
    /// When saving, refuses to replace a file of another type (judged by its suffix), so that no database is
    /// overwritten by mistake.
    void accept() override;

private:
    QLabel* m_refusal;
};

}  // namespace ui::kit
