// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileDialog>
#include <QString>

class QLabel;

namespace ui::kit {

/// Asks for a file in Qt's own dialog, and deletes itself when it is closed. The dialog reads names only, never
/// contents. Opening and closing a database file would release all locks that this program's SQLite holds on it, and
/// another program would then delete the log with the newest entries (POSIX fcntl; "How To Corrupt An SQLite Database
/// File", section 2.2).
class FileDialog final : public QFileDialog
{
    Q_OBJECT
public:
    /// @param folder  the folder that is shown first
    /// @param filter  "Tables (*.csv)"; empty: all files
    FileDialog(QWidget* parent, const QString& title, const QString& folder, const QString& filter = {});

    /// Opens the dialog to export a file. Begins in the folder of the last export, also of earlier runs.
    /// @param name    suggested file name; characters that are invalid in a file name are replaced
    /// @param ending  suffix, for example "pdf"
    void askWhere(const QString& name, const QString& ending);

protected:
    /// Refuses, when saving, to replace a file of another type (judged by its suffix), so that no database is
    /// overwritten by mistake.
    void accept() override;

private:
    QLabel* m_refusal;
};

}  // namespace ui::kit
