// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileDialog>
#include <QString>

class QLabel;

namespace ui::kit {

/// Asks for a file, in Qt's own dialog, and goes when it is closed. It looks at the names of files only: whoever opens
/// and closes a database's file to see what it is takes away all locks that this program's SQLite has on it, and
/// another program then deletes the log with what was just entered (POSIX fcntl; "How To Corrupt An SQLite Database
/// File", section 2.2).
class FileDialog final : public QFileDialog
{
    Q_OBJECT
public:
    /// @param folder  where it begins
    /// @param filter  "Tables (*.csv)"; empty: all files
    FileDialog(QWidget* parent, const QString& title, const QString& folder, const QString& filter = {});

    /// Asks where something that is given away is saved: begins where the last was, in this run or in one before.
    /// @param name    what the file may be called: words, made fit for a file's name
    /// @param ending  "pdf"
    void askWhere(const QString& name, const QString& ending);

protected:
    /// Where something is saved: a file that is there is replaced by one of its own kind only, as its name tells. A
    /// school's file never becomes a table by a slip.
    void accept() override;

private:
    QLabel* m_refusal;
};

}  // namespace ui::kit
