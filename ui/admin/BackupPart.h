// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QDateTime>
#include <QList>
#include <QModelIndex>
#include <QString>
#include <QWidget>

#include "database/IntegrityIssue.h"
#include "ui/admin/AdminWords.h"

class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QStandardItemModel;

namespace ui::kit {
class ListTable;
class InlineConfirmation;
}  // namespace ui::kit

namespace ui::admin {

/// An existing backup.
struct Backup
{
    QString file;
    QDateTime made;  ///< UTC
    qint64 bytes = 0;
    bool operator==(const Backup&) const = default;
};

/// Backups of the school's data: creating one, verifying that one can be restored, restoring one; and an integrity
/// check. One operation at a time, with its progress.
class BackupPart final : public QWidget
{
    Q_OBJECT
public:
    explicit BackupPart(QWidget* parent);

    /// @param where    the database, for display
    /// @param isServer  the database is on a server, whose administrator makes the backups
    void setDatabase(const QString& where, bool isServer);
    void setBackups(const QList<Backup>& backups);
    void showProgress(const QString& what);
    /// Ends the operation.
    /// @param sentence  returns the outcome in the current language
    /// @param findings  the issues that a check found
    /// @param isFault  the operation failed, or found issues
    void finish(std::function<QString()> sentence, std::vector<database::IntegrityIssue> findings = {},
                bool isFault = false);
    /// Sets the names of people and classes in the findings.
    void setNames(const NamesByUid& names);
    void setLessonTitles(const text::LessonTitles& titles);
    /// Shows that the text that was typed is not an audit code. No operation has started.
    void refuseCode();

signals:
    void backUpRequested();
    /// Emitted when the user asks for an integrity check.
    /// @param code  the audit code of a report, as typed; empty: none to compare with
    void checkRequested(const QString& code);
    /// Emitted when the user asks to replace the database by a backup, which logs everybody out.
    void restoreRequested(const QString& file);
    void stopRequested();

private:
    void arrange();
    void connectButtons();
    void retranslateUi();
    void tell();
    void tellEnd();
    void fill();
    void restore();
    [[nodiscard]] QModelIndex chosenRow() const;
    /// Returns the selected file; empty: none.
    [[nodiscard]] QString chosen() const;

    QString m_where;
    bool m_isServer = false;
    bool m_isBusy = false;
    QWidget* m_begunBy = nullptr;           ///< had the focus when the operation began and disabled it
    QWidget* m_focusedMeanwhile = nullptr;  ///< got the focus from Qt during the operation
    kit::InlineConfirmation* m_thought;     ///< of restoring a backup
    QList<Backup> m_backups;
    QLabel* m_words;
    QPushButton* m_backUp;
    QPushButton* m_check;
    QLabel* m_codeCaption;
    QLineEdit* m_code;  ///< the code of a report
    QLabel* m_codeFault;
    QPushButton* m_restore;
    QPushButton* m_keep;  ///< cancels the restore, while it is being confirmed
    QPushButton* m_stop;
    QProgressBar* m_bar;
    QLabel* m_said;
    std::function<QString()> m_sentence;  ///< the outcome of the last operation
    bool m_isFault = false;
    std::vector<database::IntegrityIssue> m_found;
    NamesByUid m_names;
    text::LessonTitles m_titles;
    QPlainTextEdit* m_findings;
    QStandardItemModel* m_rows;
    kit::ListTable* m_table;
};

}  // namespace ui::admin
